#include "calibrate/inference/identifiable_slopes.hpp"

#include <algorithm>

#include "calibrate/inference/small_matrices.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

IdentifiableSlopes::IdentifiableSlopes(std::span<const double> slopes,
                                       const std::vector<bool>& at_bound) {
  const auto n = static_cast<Index>(at_bound.size());
  const Index m = n > 0 ? static_cast<Index>(slopes.size()) / n : 0;
  const SlopeRows j(slopes.data(), m, n);
  std::vector<Index> moving;
  for (Index k = 0; k < n; ++k) {
    const bool held = at_bound[static_cast<std::size_t>(k)];
    if (!held && j.col(k).squaredNorm() > 0.0) moving.push_back(k);
  }
  slopes_ = j(Eigen::all, moving);
  if (moving.empty()) return;
  const UnitDirections directions(gram(slopes_));
  VectorXd compliance = directions.values;
  for (double& value : compliance) value = value > kNotIdentifiable ? 1.0 / value : 0.0;
  inverse_ = scaled(mapped(directions.vectors, compliance), directions.size);
}

std::vector<double> degrees_left(const SceneProblem& problem, const IdentifiableSlopes& slopes) {
  std::vector<double> left;
  for (const WeightedTarget& weighted : problem.targets()) {
    left.push_back(static_cast<double>(weighted.target.ordinate.size()));
  }
  if (slopes.slopes().cols() == 0) return left;
  const MatrixXd& inverse = slopes.inverse();
  // The targets, and the priors as one more: A^-1 times what they put into J^T J over and times the
  // weights of their samples.
  std::vector<MatrixXd> by_target, unweighted;
  MatrixXd squared = MatrixXd::Zero(inverse.rows(), inverse.cols());
  for (std::size_t t = 0; t <= problem.targets().size(); ++t) {
    const bool priors = t == problem.targets().size();
    const std::size_t first = priors ? problem.samples() : problem.first_residual(t);
    const std::size_t count =
        priors ? problem.squares().residuals - first : problem.targets()[t].target.ordinate.size();
    const MatrixPart rows =
        slopes.slopes().middleRows(static_cast<Index>(first), static_cast<Index>(count));
    VectorXd w = VectorXd::Ones(static_cast<Index>(count));
    if (!priors) w = Eigen::Map<const VectorXd>(problem.weights(t).data(), w.size());
    by_target.push_back(product(inverse, gram(rows)));
    unweighted.push_back(product(inverse, gram(rows, w.cwiseInverse())));
    squared += product(inverse, gram(rows, w));
  }
  for (std::size_t p = 0; p < left.size(); ++p) {
    // Of r = (1 - H) e the sum of variances: n - 2 tr(H) + tr(H H^T), H = J A^-1 J^T W.
    left[p] += product(unweighted[p], squared).trace() - 2.0 * by_target[p].trace();
    left[p] = std::max(left[p], 0.0);
  }
  return left;
}

}  // namespace plastica::calibrate
