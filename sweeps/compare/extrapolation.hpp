#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sweeps/compare/reference_sets.hpp"

/// Limits of values that several axes refine; not installed.
namespace plastica::sweeps {

/// Why there is no limit of values along one axis.
inline constexpr std::string_view kNothingExtrapolated =
    "nothing can be extrapolated: it takes three values that converge from one side, no faster "
    "than with order 2";

/// A limit, and how sure it is.
struct Limit {
  double value = 0.0;              ///< f_0, the value's unit
  double uncertainty = 0.0;        ///< of it, the value's unit
  std::vector<double> constant{};  ///< a_k: what axis k adds at its finest size, the value's unit
  std::vector<double> order{};     ///< p_k [1]
};

/// Fits f = f_0 + sum over axes of a_k (h_k/H_k)^p_k, H_k the finest size, by least squares; values
/// count the less the coarser they are. The orders are searched within 0.3 … 2.5 (variable
/// projection); an axis that moves no value by more than rounding is left out (constant
/// and order 0).
/// The uncertainty is the most of: three standard errors of f_0 of the fit linearized in all its
/// numbers; the change of f_0 without the coarsest sizes; and that with terms of the orders 1 and 2
/// along each axis in the place of one of order p_k, if there are values enough.
/// @param sizes  h of each value along each axis (n x n_axes), > 0
/// @param values  (n)
/// @return none where an order runs to its bound, or where fewer values than numbers are left
std::optional<Limit> fit_limit(std::span<const double> sizes, std::size_t axes,
                               std::span<const double> values);

/// Of three values or more along one axis, see theory/convergence.hpp; none where they diverge, go
/// to and fro, or converge faster than with `theory::kHighestOrder`.
std::optional<double> extrapolated_along(const std::vector<double>& sizes,
                                         const std::vector<double>& values);

/// The limit of a set of cases.
struct Extrapolated {
  /// Whether each axis has sizes enough; else there is nothing of all axes.
  bool possible = false;
  std::optional<double> value{};        ///< [SI]
  std::optional<double> uncertainty{};  ///< [SI]
  std::string reason{};                 ///< why there is no value
};

Extrapolated extrapolate(const Sweep& sweep, const ReferenceSets& sets, const ReferenceSet& set,
                         const std::vector<CaseResult>& results);

}  // namespace plastica::sweeps
