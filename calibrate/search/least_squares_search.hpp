#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "calibrate/search/least_squares.hpp"
#include "calibrate/search/marquardt_steps.hpp"

namespace plastica::calibrate {

/// The minimization of `minimize_squares`, which asks for residuals in place of finding them, so
/// that several minimizations have theirs found together.
///
///     LeastSquaresSearch search(problem, options);
///     while (!search.done()) search.take(residuals at search.points(), found);
///
class LeastSquaresSearch {
 public:
  /// @param problem  its box, start and number of residuals; must outlive this
  LeastSquaresSearch(const LeastSquaresProblem& problem, const LeastSquaresOptions& options);

  bool done() const { return phase_ == Phase::Done; }
  /// Where residuals are wanted next, until it is done (count x n), row by row.
  std::span<const double> points() const { return points_; }
  std::size_t count() const { return count_; }  ///< of these points, >= 1
  /// @param residuals  at the points (count x m)
  /// @param found  for each point, whether there are any (count)
  void take(std::span<const double> residuals, std::span<const bool> found);

  LeastSquares result() const;

 private:
  enum class Phase { Start, Slopes, Trial, Done };

  void end(LeastSquaresOutcome outcome);
  void ask(Phase phase, std::vector<double> points, std::size_t count);
  void ask_point(Phase phase, const Eigen::VectorXd& x);
  void take_start(std::span<const double> residuals, std::span<const bool> found);
  void want_all_slopes();
  void begin_slopes(std::span<const double> residuals, std::span<const bool> found);
  void add_moved(const Eigen::VectorXd& x, std::vector<double>& points);
  void ask_slopes();
  void take_slopes_beside(std::span<const double> residuals, std::span<const bool> found);
  void take_slopes(std::span<const double> residuals, std::span<const bool> found);
  void begin_trials();
  void try_step();
  void take_trial(std::span<const double> residuals, std::span<const bool> found);

  LeastSquaresOptions options_;
  Eigen::VectorXd lower_, upper_;
  Eigen::VectorXd x_, r_;
  Eigen::MatrixXd jacobian_;
  double cost_ = 0.0;
  MarquardtSteps steps_;
  SquaresModel model_;
  int evaluations_ = 0;
  LeastSquaresOutcome outcome_ = LeastSquaresOutcome::NoStart;

  Phase phase_ = Phase::Start;
  std::vector<double> points_;
  std::size_t count_ = 0;
  std::vector<Eigen::Index> wanted_, within_;  ///< coordinates without a slope yet, and asked for
  double side_ = 0.0;                          ///< step of the differences that are asked for
  bool has_companions_ = false;
  bool has_slopes_ = false;  ///< whether slopes were asked for with the point
};

}  // namespace plastica::calibrate
