#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plastica::calibrate {

/// What a stage of a search minimizes: a cost over a box, in scaled coordinates of order one.
struct Problem {
  std::vector<double> lower;  ///< (n), finite
  std::vector<double> upper;  ///< (n), finite, above lower
  std::vector<double> start;  ///< (n), within the box
  /// Cost at x (n); fills `gradient` (n) if it is not empty. May throw: `minimize`
  /// passes the exception on. Not-a-number or infinite costs are taken as very bad points.
  std::function<double(std::span<const double> x, std::span<double> gradient)> cost;
  /// The same cost as a sum of squares |r|^2 with exact slopes J = dr/dx, for "gauss-newton": fills
  /// `gradient` with J^T r (n), half of that of the cost, and `normal` with J^T J (n x n), row by
  /// row. May be empty: then there is no such stage. May throw, as `cost`.
  std::function<double(std::span<const double> x, std::span<double> gradient,
                       std::span<double> normal)>
      squares = nullptr;
};

/// A stage of a search.
struct MinimizeOptions {
  std::string algorithm;          ///< one of `algorithm_names()` but "auto"
  int max_evaluations = 500;      ///< >= 1; never exceeded
  double x_tolerance = 1e-10;     ///< |dx_i| <= x_tolerance for all i
  double cost_tolerance = 1e-14;  ///< |df| <= cost_tolerance |f|
  std::uint64_t seed = 1;         ///< for the algorithms that draw random numbers
};

struct Minimum {
  std::vector<double> x;  ///< best point that was evaluated (n)
  double cost = 0.0;
  int evaluations = 0;
  std::string outcome;  ///< "xtol-reached", "ftol-reached", "maxeval-reached", "roundoff-limited"…
  bool usable = false;  ///< whether x is worth keeping; true for "roundoff-limited"
  /// Of "gauss-newton": what its linear model promises to take off the cost at x. Where that is
  /// much, the cost has a kink there.
  double promised = 0.0;
};

/// The stage that is not NLopt's: Levenberg and Marquardt's (least_squares.hpp).
inline constexpr std::string_view kGaussNewton = "gauss-newton";

/// Names that a fit file may use: "auto", "gauss-newton" and those of NLopt that need bounds and no
/// constraints, in lower case ("crs", "direct-l", "slsqp", "lbfgs", "nelder-mead", "sbplx",
/// "bobyqa", …).
std::span<const std::string_view> algorithm_names();
bool is_global(std::string_view algorithm);
bool needs_gradient(std::string_view algorithm);

/// "2.7.1": the NLopt that runs.
std::string nlopt_version();

/// Runs a stage: one of NLopt's algorithms, or Levenberg and Marquardt's with exact slopes. The
/// same problem and options give the same bits, in any thread.
/// @throws whatever the problem's functions threw; InputError for an unknown algorithm
Minimum minimize(const Problem& problem, const MinimizeOptions& options);

}  // namespace plastica::calibrate
