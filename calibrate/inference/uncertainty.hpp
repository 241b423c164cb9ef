#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"

namespace plastica::calibrate {

/// How well a curve determines the active parameters (n of them).
///
/// With the residuals' Jacobian J (n_samples x n), weights W = diag(w_i), A = J^T W J:
///   C = s^2 A^-1 (J^T W^2 J) A^-1,
/// the covariance of a weighted fit of samples with independent errors of equal size s (the
/// "sandwich"; for equal weights it is s^2 (J^T J)^-1, and with them and a given noise A^-1).
///   least squares with a given noise: s = noise, whatever the given weights;
///   otherwise: s^2 = sum r_i^2/(n_samples - n) over the samples whose weight is above 0.
/// Where residuals that are noise scatter otherwise on the samples that decide on a parameter than
/// on the rest (`is_noise_unequal`), and no noise is given, each sample has its own variance v_i
/// instead of s^2 (`own_variances`): C = A^-1 J^T W diag(v) W J A^-1, and each parameter its own
/// degrees of freedom.
/// So given weights are no inverse variances: they say which part of the curve the parameters have
/// to follow, and a fit that leans on fewer samples gets larger errors.
/// Where the model cannot follow the curve the residuals are not independent and the errors are too
/// small: what they lack is added by `misfit_error` (material_interval.hpp).
/// A prior of E (modulus_prior.hpp) adds its curvature to A, variance/sd^2 times sum w_i; its own
/// scatter makes the covariance P = A^-1 B_p A^-1, with the square of that curvature times sd^2
/// for B_p. It stems from samples of the same curve, so that it may err as these do: an error from
/// both is the sum of the two errors, not the root of the sum of squares, and no less than that of
/// errors that are alike.
/// Where the elastic line has decided by how much the strain is shifted, that has an error d of its
/// own: it moves the parameters by g = -A^-1 J^T W (dr/dshift) d, and g g^T is added to C.
/// A break strain adds its sampling interval: its variance is that of the model's permanent strain
/// at the break (through C) plus h^2/3 of a break that lies anywhere within +-h.
///
/// Not identified is a parameter whose column of J vanishes (its fraction of the misfit is below
/// 1e-12 of the largest stress for a relative change of one), or which takes part in a
/// combination that is not identifiable from J (an eigenvalue of A, scaled to a unit diagonal,
/// below 1e-12); and a yield stress that is not identifiable from the curve
/// (identifiable_yield.hpp).
struct Uncertainty {
  std::vector<bool> identified;  ///< (n)
  /// How many parameters of the stress the curve shows, by themselves or in combinations.
  std::size_t rank = 0;
  std::vector<double> standard_error;  ///< SI (n); NaN if not identified
  /// The part of the standard error that is the residuals', the prior's and the shift's, SI (n);
  /// NaN if not identified.
  std::vector<double> noise_error;
  std::vector<double> residual_error;  ///< the residuals' alone, SI (n); NaN if not identified
  std::vector<double> sampling;     ///< half a break's sampling interval, SI (n); 0 of all others
  std::vector<double> correlation;  ///< (n x n); NaN in rows and columns not identified
  double noise = 0.0;               ///< s [Pa]
  /// Of the residuals' part of the errors (n); infinite if s is given.
  std::vector<double> degrees_of_freedom;
  /// Of what is known of a parameter, the fraction that its stated prior knows (n) [1].
  std::vector<double> prior_fraction;
  /// Of unequal noise: v of the samples with a weight [Pa^2]; else empty.
  std::vector<double> own_variance;
};

/// @param active  solution, SI (n)
Uncertainty uncertainty(const Misfit::Details& details, std::span<const double> active,
                        const ParameterSet& parameters, const Target& target,
                        const FitOptions& options, double break_factor);

/// What C is made of, without the noise; NaN in rows and columns of breaks and of what is not
/// identified, SI (n x n).
struct Spread {
  std::vector<double> inverse;  ///< A^-1, with the weights of the details
  std::vector<double> spread;   ///< A^-1 (J^T W^2 J) A^-1; of unequal noise C over s^2
  std::vector<double> prior;    ///< P of the slope's, with the noise that it has
  std::vector<double> stated;   ///< and of the stated ones
};
Spread spread_of(const Misfit::Details& details, std::span<const double> active,
                 const ParameterSet& parameters, const Target& target, const FitOptions& options);

}  // namespace plastica::calibrate
