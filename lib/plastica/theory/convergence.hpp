#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace plastica::theory {

// Orders of convergence, extrapolation to size zero, and the grid convergence index. A size h is
// what is refined: the length of a segment, a time step. Sizes may come in any order. All functions
// throw InputError for sizes that are not positive and finite, for one that appears twice (to
// 1e-12), for errors or values that are not finite, and for lists of unequal length.

/// What observed_order takes for round-off.
struct OrderOptions {
  /// S: size of the values that the errors belong to, in their unit; 1 for relative errors. > 0
  double scale = 1.0;
  /// A floor counts as round-off only where error/S <= floor_limit [1]: above, an error that stays
  /// is a wrong method. Iterations that end by a tolerance make floors higher than eps.
  double floor_limit = 1e-9;
};

/// The line log|error| = log(constant) + order log h through a series.
struct OrderFit {
  std::optional<double> order;        ///< p; empty if fewer than two points can be used
  std::optional<double> constant;     ///< error at h = 1, in the errors' unit; empty as the order
  std::optional<double> correlation;  ///< Pearson's r of the logarithms; 0 if all errors are equal
  std::size_t points = 0;             ///< how many points the line goes through
  std::vector<bool> used;             ///< which, in the order of the input
};

/// The order at which errors fall, by least squares of log|error| over log h.
///
/// Two kinds of points are left out:
/// - errors of at most 16 eps S, exact zeros included: the sum of a few roundings of the value;
/// - the floor: all from one size down to the finest if each has error <= floor_limit S and has
///   stopped falling, while the coarser ones have a clear order. Clear: three points or more with
///   order >= 0.5 and correlation >= 0.9, or two between which the error falls tenfold. Stopped
///   falling: with the line of the coarser ones, order q, rms distance s of them from it, and the
///   last of them h', the error at h exceeds line(h') (h/h')^(q/2), half of the fall at most, and
///   exceeds line(h) by a factor of 2 and of exp(3 s), which noise about the line does not reach.
///   Points next to a floor go with it while they are off the line of the coarser ones by more than
///   a factor of 1.25 and of exp(3 s).
///
/// So a noisy series keeps its points, and one that stays at a wrong value keeps them as well and
/// shows a low order.
/// @param sizes   h, any unit (n)
/// @param errors  of either sign, any unit (n)
OrderFit observed_order(std::span<const double> sizes, std::span<const double> errors,
                        const OrderOptions& options = {});

/// Orders between neighbours, log(e_i/e_{i+1})/log(h_i/h_{i+1}), from the coarsest to the finest
/// (n - 1); empty where an error is zero.
std::vector<std::optional<double>> pairwise_orders(std::span<const double> sizes,
                                                   std::span<const double> errors);

/// The value at size zero, f_1 + (f_1 - f_2)/(r^p - 1), if the error is C h^p.
/// Source: Richardson & Gaunt, Phil. Trans. R. Soc. A 226 (1927) 299.
/// @param fine    f_1, at size h
/// @param coarse  f_2, at size r h
/// @param ratio   r > 1
/// @param order   p > 0
double richardson(double fine, double coarse, double ratio, double order);

/// The value at size zero of three values with the error a h + b h^2: the parabola through them.
/// Where both terms matter they may cancel at one size, and two values next to it agree though both
/// are off: no single power says so, this does. Exact for a pure order of 1 or 2.
/// @param sizes, values  three each, in any order
double limit_of_two_orders(std::span<const double> sizes, std::span<const double> values);

/// Of all joints and schemes here; values that converge faster do so by luck, or because errors of
/// unlike orders cancel. [1]
inline constexpr double kHighestOrder = 2.0;
/// An order that is seen may be so much higher, by the terms that it leaves out. [1]
inline constexpr double kBeyondHighestOrder = 0.5;

/// How values go with refinement.
enum class ConvergenceKind {
  Monotone,  ///< differences shrink and keep their sign
  /// Only with `GridOptions::highest_order`: monotone but faster than that, or the two finest agree
  /// and the third does not.
  TooFast,
  Oscillatory,  ///< differences shrink and change their sign
  Divergent,    ///< differences do not shrink as any order > 0 has it; nothing is extrapolated
  Unchanged,    ///< the two finest agree to 16 eps: converged, without an order to be seen
  Unknown,      ///< two values do not show it
};

struct GridOptions {
  /// F_s. By default 1.25, or 3 for two values with an assumed order, as Roache advises.
  std::optional<double> safety_factor{};
  /// Order to extrapolate with in place of the observed one, > 0; two values need it.
  std::optional<double> order{};
  /// The highest order that the method has, > 0; empty: any is believed. With it, three values that
  /// fall by more than `kBeyondHighestOrder` faster, or go to and fro, show errors of unlike orders
  /// that cancel: nothing is extrapolated, and the uncertainty is that of order 1 with F_s = 3, the
  /// larger of what either coarser value says. Of all others p is at most this, and the uncertainty
  /// no less than F_s times the distance from `limit_of_two_orders`; no coarse index is taken. Not
  /// together with `order`.
  std::optional<double> highest_order{};
};

/// Roache's grid convergence index: an estimate of the discretization error of the finest value
/// with a margin of safety. 1, 2, 3 number the values from the finest on. What cannot be had is
/// empty: of divergent values all that needs an order; of a value that is zero what is relative to
/// it.
struct GridConvergence {
  ConvergenceKind kind = ConvergenceKind::Unknown;
  double safety_factor = 0.0;            ///< F_s
  double r21 = 0.0;                      ///< h_2/h_1
  std::optional<double> r32;             ///< h_3/h_2; empty for two values
  std::optional<double> observed_order;  ///< of monotone and oscillatory values
  std::optional<double> order;           ///< p that the figures below use: given, or observed
  std::optional<double> extrapolated;    ///< f_0 = (r21^p f_1 - f_2)/(r21^p - 1), the value's unit
  std::optional<double> uncertainty;     ///< F_s |f_1 - f_2|/(r21^p - 1), the value's unit
  std::optional<double> approximate_error;   ///< |f_1 - f_2|/|f_1| [1]
  std::optional<double> extrapolated_error;  ///< |f_0 - f_1|/|f_0| [1]
  std::optional<double> fine_index;          ///< GCI_12 = F_s |f_1 - f_2|/|f_1|/(r21^p - 1) [1]
  std::optional<double> coarse_index;        ///< GCI_23 = F_s |f_2 - f_3|/|f_2|/(r32^p - 1) [1]
  /// GCI_23/(r21^p GCI_12) [1]: 1 in the asymptotic range of the order p. With the observed order
  /// it is |f_1/f_2|, and says nothing.
  std::optional<double> asymptotic_ratio;
};

/// Grid convergence index of the three finest values, or of two with a given order.
///
/// With e_21 = f_2 - f_1, e_32 = f_3 - f_2, s = sign(e_32/e_21), the observed order solves
///
///   p ln r21 = ln|e_32/e_21| + q(p),  q(p) = ln((r21^p - s)/(r32^p - s)),
///
/// that is p ln r32 + ln(1 - s r32^-p) - ln(1 - s r21^-p) = ln|e_32/e_21|, whose left side rises
/// with p: from ln(ln r32/ln r21) at p = 0 if s = 1, from 0 if s = -1. So p > 0 is unique, and
/// missing where |e_32/e_21| is no greater than that: divergent values. (Celik takes the absolute
/// value of the right side, which would give these an order.) Oscillatory values are extrapolated
/// as monotone ones, as Celik does. Sources: Roache, J. Fluids Eng. 116 (1994) 405; Celik et al.,
/// J. Fluids Eng. 130 (2008) 078001.
/// @param sizes   h (n >= 2)
/// @param values  f (n)
/// @throws InputError also for fewer than two values, or two without an order
GridConvergence grid_convergence(std::span<const double> sizes, std::span<const double> values,
                                 const GridOptions& options = {});

}  // namespace plastica::theory
