#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calibrate/search/marquardt_steps.hpp"
#include "calibrate/search/optimizer.hpp"

namespace plastica::calibrate {

/// A search by Levenberg and Marquardt's steps (least_squares.hpp) with the problem's exact slopes,
/// which can be left and gone on with. A point and its slopes are one evaluation.
class GaussNewton {
 public:
  /// @param problem  its box and squares; must outlive this. Its start does not count
  /// @param start  within the box (n)
  GaussNewton(const Problem& problem, const std::vector<double>& start,
              const MinimizeOptions& options);

  /// Goes on until its end, or for so many evaluations.
  /// @return where it is now; of the evaluations, those since it went on
  /// @throws whatever `problem.squares` threw
  Minimum advance(int evaluations);

  bool ended() const { return outcome_.has_value(); }
  /// Whether the start has a cost; known after the first `advance`.
  bool found() const { return evaluations_ > 0 && outcome_ != LeastSquaresOutcome::NoStart; }
  const Eigen::VectorXd& x() const { return x_; }       ///< best point (n)
  const SquaresModel& model() const { return model_; }  ///< there

 private:
  std::optional<LeastSquaresOutcome> step(int last);
  double promised() const;
  SquaresModel at(const Eigen::VectorXd& x);

  const Problem& problem_;
  Eigen::VectorXd lower_, upper_;
  Eigen::VectorXd x_;
  SquaresModel model_;
  MarquardtSteps steps_;
  std::optional<LeastSquaresOutcome> outcome_;
  int evaluations_ = 0;
  int watched_ = 0;           ///< evaluations when patience was last counted from
  double cost_before_ = 0.0;  ///< at that time
  double promised_before_ = 0.0;
};

/// The stage "gauss-newton" of `minimize`: such a search to its end.
/// @throws whatever `problem.squares` threw
Minimum minimize_exact_squares(const Problem& problem, const MinimizeOptions& options);

}  // namespace plastica::calibrate
