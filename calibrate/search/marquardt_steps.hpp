#pragma once

#include <Eigen/Core>
#include <optional>

#include "calibrate/search/least_squares.hpp"

namespace plastica::calibrate {

/// A sum of squares as Gauss and Newton take it near a point: |r + J dx|^2 = cost + 2 gradient . dx
/// + dx . normal dx.
struct SquaresModel {
  double cost = 0.0;         ///< |r|^2
  Eigen::VectorXd gradient;  ///< J^T r, half of that of the cost (n)
  Eigen::MatrixXd normal;    ///< J^T J (n x n)
};

/// The steps of Levenberg and Marquardt over a box, for those who find residuals and slopes:
///
///     MarquardtSteps steps(lower, upper, options);
///     while (!steps.propose(x, model)) {
///       // cost and model at x + steps.step()
///       if (const auto end = steps.judge(model.cost, cost)) break;
///       if (steps.accepted()) move x and model there
///     }
///
class MarquardtSteps {
 public:
  /// @param lower, upper  of the box (n)
  MarquardtSteps(Eigen::VectorXd lower, Eigen::VectorXd upper, const LeastSquaresOptions& options);

  /// Solves for the next step. @return how the search has ended, if no step is worth a trial
  std::optional<LeastSquaresOutcome> propose(const Eigen::VectorXd& x, const SquaresModel& model);
  const Eigen::VectorXd& step() const { return step_; }  ///< (n)
  /// The point that it leads to, within the box to the last bit (n).
  Eigen::VectorXd target(const Eigen::VectorXd& x) const;

  /// Accepts a step that lowers the cost, or damps the next one more.
  /// @param before, after  costs; infinite where there is none
  /// @return how the search has ended, if this was the last step
  std::optional<LeastSquaresOutcome> judge(double before, double after);
  bool accepted() const { return accepted_; }

 private:
  LeastSquaresOptions options_;
  Eigen::VectorXd lower_, upper_;
  Eigen::VectorXd step_;
  double lambda_;
  bool accepted_ = false;
};

/// What the undamped step from a point promises to take off the cost: what is left to gain, if the
/// cost is as smooth as it looks.
double promised_decrease(const Eigen::VectorXd& x, const SquaresModel& model,
                         const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

}  // namespace plastica::calibrate
