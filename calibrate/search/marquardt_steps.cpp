#include "calibrate/search/marquardt_steps.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFirstLambda = 1e-3;
constexpr double kMinLambda = 1e-12;
constexpr double kMaxLambda = 1e12;

/// Solves a x = b by LDL^T, the larger pivot first; a direction that nothing decides stays at 0.
/// Most systems are of one or two unknowns, for which Eigen's way takes ten times as long.
VectorXd solved_by(const MatrixXd& a, const VectorXd& b) {
  if (b.size() != 1 && b.size() != 2) return a.ldlt().solve(b);
  const auto over = [](double sum, double pivot) {
    return std::abs(pivot) > std::numeric_limits<double>::min() ? sum / pivot : 0.0;
  };
  VectorXd x(b.size());
  if (b.size() == 1) {
    x[0] = over(b[0], a(0, 0));
    return x;
  }
  const Index first = std::abs(a(0, 0)) >= std::abs(a(1, 1)) ? 0 : 1, second = 1 - first;
  const double times = over(a(second, first), a(first, first));
  x[second] = over(b[second] - times * b[first], a(second, second) - times * a(second, first));
  x[first] = over(b[first], a(first, first)) - times * x[second];
  return x;
}

/// The damped step within the box. What a bound stops is held, and the others are solved again.
VectorXd damped_step(const VectorXd& x, const SquaresModel& model, const VectorXd& lower,
                     const VectorXd& upper, double lambda) {
  const Index n = x.size();
  std::vector<Index> free;
  for (Index k = 0; k < n; ++k) {
    const bool out = (x[k] <= lower[k] && model.gradient[k] > 0.0) ||
                     (x[k] >= upper[k] && model.gradient[k] < 0.0);
    if (!out && model.normal(k, k) > 0.0) free.push_back(k);
  }
  VectorXd step = VectorXd::Zero(n);
  while (!free.empty()) {
    const auto m = static_cast<Index>(free.size());
    MatrixXd a(m, m);
    VectorXd b(m);
    for (Index i = 0; i < m; ++i) {
      const Index row = free[static_cast<std::size_t>(i)];
      b[i] = -model.gradient[row];
      // What is held at its bound has moved all the same.
      for (Index k = 0; k < n; ++k) b[i] -= model.normal(row, k) * step[k];
      for (Index j = 0; j < m; ++j) a(i, j) = model.normal(row, free[static_cast<std::size_t>(j)]);
      a(i, i) *= 1.0 + lambda;
    }
    const VectorXd solved = solved_by(a, b);
    const std::size_t before = free.size();
    for (Index i = m; i-- > 0;) {
      const Index k = free[static_cast<std::size_t>(i)];
      const double to = x[k] + solved[i];
      if (to > lower[k] && to < upper[k]) continue;
      step[k] = (to <= lower[k] ? lower[k] : upper[k]) - x[k];
      free.erase(free.begin() + i);
    }
    if (free.size() < before) continue;
    for (Index i = 0; i < m; ++i) step[free[static_cast<std::size_t>(i)]] = solved[i];
    break;
  }
  return step;
}

/// How much less than at the point the squares of the linear model are after a step.
double gain_of(const VectorXd& step, const SquaresModel& model) {
  return -(2.0 * model.gradient.dot(step) + step.dot(model.normal * step));
}

bool is_small(const VectorXd& step, double tolerance) {
  return step.cwiseAbs().maxCoeff() <= tolerance;
}

}  // namespace

MarquardtSteps::MarquardtSteps(VectorXd lower, VectorXd upper, const LeastSquaresOptions& options)
    : options_(options),
      lower_(std::move(lower)),
      upper_(std::move(upper)),
      lambda_(kFirstLambda) {}

std::optional<LeastSquaresOutcome> MarquardtSteps::propose(const VectorXd& x,
                                                           const SquaresModel& model) {
  step_ = damped_step(x, model, lower_, upper_, lambda_);
  if (!step_.allFinite()) return LeastSquaresOutcome::Stalled;
  if (gain_of(step_, model) <= options_.cost_tolerance * model.cost) {
    return is_small(step_, options_.x_tolerance) ? LeastSquaresOutcome::StepReached
                                                 : LeastSquaresOutcome::CostReached;
  }
  return std::nullopt;
}

VectorXd MarquardtSteps::target(const VectorXd& x) const {
  return (x + step_).cwiseMax(lower_).cwiseMin(upper_);
}

std::optional<LeastSquaresOutcome> MarquardtSteps::judge(double before, double after) {
  accepted_ = after < before;
  if (is_small(step_, options_.x_tolerance)) return LeastSquaresOutcome::StepReached;
  if (accepted_) {
    lambda_ = std::max(0.1 * lambda_, kMinLambda);
    return std::nullopt;
  }
  lambda_ = std::max(10.0 * lambda_, kFirstLambda);
  if (lambda_ > kMaxLambda) return LeastSquaresOutcome::Stalled;
  return std::nullopt;
}

double promised_decrease(const VectorXd& x, const SquaresModel& model, const VectorXd& lower,
                         const VectorXd& upper) {
  const VectorXd step = damped_step(x, model, lower, upper, kMinLambda);
  return step.allFinite() ? gain_of(step, model) : 0.0;
}

}  // namespace plastica::calibrate
