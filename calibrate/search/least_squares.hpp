#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace plastica::calibrate {

/// A sum of squares over a box, in scaled coordinates of order one.
struct LeastSquaresProblem {
  std::vector<double> lower;  ///< (n), finite
  std::vector<double> upper;  ///< (n), finite, above lower
  std::vector<double> start;  ///< (n), within the box
  std::size_t residuals = 0;  ///< m, at least n
  /// Residuals at a point. May throw: `minimize_squares` passes the exception on.
  /// @return false where there are none; taken as a very bad point
  using AtPoint = std::function<bool(std::span<const double> x, std::span<double> residual)>;
  /// Residuals at several points, for those who find them side by side.
  /// @param points  (n_points x n), row by row
  /// @param residuals  to be filled (n_points x m)
  /// @param found  for each point, whether there are any (n_points)
  using AtPoints = std::function<void(std::span<const double> points, std::span<double> residuals,
                                      std::span<bool> found)>;
  AtPoints evaluate;
  /// Whether points beside the first one that is asked for, within `kBeside` of it, cost less than
  /// points of their own; where it has no residuals, they have none.
  bool has_companions = false;
};

/// For each point the first one that it lies beside, or itself.
/// @param points  (count x n), row by row
std::vector<std::size_t> leads_among(std::span<const double> points, std::size_t count);

/// One point after the other.
LeastSquaresProblem::AtPoints one_by_one(LeastSquaresProblem::AtPoint residual);

struct LeastSquaresOptions {
  int max_evaluations = 200;  ///< >= 1; of residuals, those of differences included
  double x_tolerance = 1e-9;  ///< a step with |dx_i| <= x_tolerance for all i is the last one
  double cost_tolerance =
      1e-14;  ///< … and one that would lower the cost by less than this fraction
  double difference_step = 1e-5;  ///< of forward differences
  double central_step = 1e-4;     ///< of the central differences at the solution
};

enum class LeastSquaresOutcome {
  StepReached,         ///< x_tolerance
  CostReached,         ///< cost_tolerance
  Stalled,             ///< no step lowers the cost any more
  EvaluationsReached,  ///< max_evaluations; x is the best so far
  NoStart,             ///< no residuals at the start
  SetAside,            ///< ended early, because other searches had come further down
};

/// One word for reports: "step-reached", …
std::string_view name_of(LeastSquaresOutcome outcome);

struct LeastSquares {
  LeastSquaresOutcome outcome = LeastSquaresOutcome::NoStart;
  std::vector<double> x;         ///< best point (n)
  std::vector<double> residual;  ///< there (m)
  double cost = 0.0;             ///< sum of their squares
  int evaluations = 0;           ///< those of `residual_slopes` are not among them
};

/// Minimizes by Levenberg and Marquardt with forward differences: (J^T J + lambda D) dx = -J^T r,
/// D the diagonal of J^T J. Coordinates at a bound that would leave the box are held there. Needs
/// few evaluations where residuals are smooth; the same problem gives the same bits.
/// Source: Marquardt, J. SIAM 11 (1963) 431.
LeastSquares minimize_squares(const LeastSquaresProblem& problem,
                              const LeastSquaresOptions& options);

/// Of the central differences at a solution, in scaled parameters: fibres that yield one after the
/// other, and Newton's tolerance, are smooth over it.
inline constexpr double kErrorStep = 1e-4;

/// In each coordinate: more than any step of differences.
inline constexpr double kBeside = 1.5 * kErrorStep;

/// d residual / d x at a point by central differences, one-sided at bounds and where residuals are
/// missing on one side (m x n), row by row; NaN of a coordinate that has none on either.
/// @param at  residuals at x (m)
std::vector<double> residual_slopes(const LeastSquaresProblem& problem, std::span<const double> x,
                                    std::span<const double> at, double step);

}  // namespace plastica::calibrate
