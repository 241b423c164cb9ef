#include "calibrate/inference/unbounded_yield.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "calibrate/inference/small_matrices.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool is_yield_stress(const Parameter& p) {
  return p.field->material == MaterialField::YieldStress ||
         p.field->material == MaterialField::ShearYieldStress;
}

/// The residuals at a point; empty where there are none.
VectorXd residuals_at(SceneProblem& problem, const std::vector<double>& point) {
  VectorXd residual(static_cast<Index>(problem.squares().residuals));
  const auto runs =
      problem.evaluate(point, 1, {residual.data(), static_cast<std::size_t>(residual.size())});
  return runs.front().found ? residual : VectorXd();
}

/// Whether the squares rise by less than a threshold where one coordinate is at its upper bound.
bool is_unbounded(SceneProblem& problem, std::span<const double> x, double squares,
                  const MatrixXd& others, const std::vector<std::size_t>& moving, std::size_t k,
                  double threshold) {
  const LeastSquaresProblem& box = problem.squares();
  std::vector<double> point(x.begin(), x.end());
  point[k] = box.upper[k];
  const VectorXd beyond = residuals_at(problem, point);
  if (beyond.size() == 0) return false;
  if (others.cols() > 0) {
    const VectorXd step = others.colPivHouseholderQr().solve(-beyond);
    if (!((beyond + others * step).squaredNorm() - squares < threshold)) return false;
    for (std::size_t i = 0; i < moving.size(); ++i) {
      const std::size_t at = moving[i];
      point[at] = std::clamp(x[at] + step[static_cast<Index>(i)], box.lower[at], box.upper[at]);
    }
  }
  const VectorXd fitted = residuals_at(problem, point);
  return fitted.size() > 0 && fitted.squaredNorm() - squares < threshold;
}

}  // namespace

std::vector<double> drop_unbounded_yield(SceneProblem& problem, std::span<const double> x,
                                         std::span<const double> residual,
                                         const std::vector<bool>& at_bound, double confidence,
                                         std::span<double> slopes) {
  const std::size_t n = x.size();
  const double t =
      theory::student_t_quantile(0.5 + 0.5 * confidence, degrees_of_freedom(problem.noise()));
  double squares = 0.0;
  for (const double each : residual) squares += each * each;
  std::vector<double> without;
  for (std::size_t k = 0; k < n; ++k) {
    if (at_bound[k] || !is_yield_stress(problem.parameters().parameter(k))) continue;
    std::vector<std::size_t> moving;
    for (std::size_t i = 0; i < n; ++i) {
      if (i != k && !at_bound[i]) moving.push_back(i);
    }
    MatrixXd others(static_cast<Index>(residual.size()), static_cast<Index>(moving.size()));
    for (std::size_t row = 0; row < residual.size(); ++row) {
      for (std::size_t i = 0; i < moving.size(); ++i) {
        others(static_cast<Index>(row), static_cast<Index>(i)) = slopes[row * n + moving[i]];
      }
    }
    if (!is_unbounded(problem, x, squares, others, moving, k, t * t)) continue;
    for (std::size_t row = 0; row < residual.size(); ++row) slopes[row * n + k] = 0.0;
    if (without.empty()) without.assign(x.begin(), x.end());
    without[k] = problem.squares().upper[k];
  }
  return without;
}

}  // namespace plastica::calibrate
