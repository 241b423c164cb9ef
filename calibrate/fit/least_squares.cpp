#include "calibrate/fit/least_squares.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFirstLambda = 1e-3;
constexpr double kLeastLambda = 1e-12;
constexpr double kMostLambda = 1e12;

double sum_of_squares(const VectorXd& r) { return r.squaredNorm(); }

std::span<double> span_of(VectorXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }
std::span<const double> span_of(const VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

/// One minimization.
class Minimizer {
 public:
  Minimizer(const LeastSquaresProblem& problem, const LeastSquaresOptions& options)
      : problem_(problem),
        options_(options),
        lower_(vector(problem.lower)),
        upper_(vector(problem.upper)),
        x_(vector(problem.start)),
        r_(static_cast<Index>(problem.residuals)) {}

  LeastSquares run() {
    LeastSquares result;
    result.outcome = search();
    result.x.assign(x_.data(), x_.data() + x_.size());
    result.residual.assign(r_.data(), r_.data() + r_.size());
    result.cost = cost_;
    result.evaluations = evaluations_;
    return result;
  }

 private:
  static VectorXd vector(const std::vector<double>& v) {
    return Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size()));
  }

  bool spent() const { return evaluations_ >= options_.max_evaluations; }

  /// The cost at a point; infinite where there are no residuals.
  double evaluate(const VectorXd& x, VectorXd& r) {
    ++evaluations_;
    r.resize(r_.size());
    if (!problem_.residual(span_of(x), span_of(r))) return std::numeric_limits<double>::infinity();
    const double cost = sum_of_squares(r);
    return std::isfinite(cost) ? cost : std::numeric_limits<double>::infinity();
  }

  LeastSquaresOutcome search() {
    cost_ = evaluate(x_, r_);
    if (!std::isfinite(cost_)) return LeastSquaresOutcome::NoStart;
    if (x_.size() == 0) return LeastSquaresOutcome::StepReached;
    for (;;) {
      if (!set_slopes()) return LeastSquaresOutcome::EvaluationsReached;
      const VectorXd pull = jacobian_.transpose() * r_;
      const MatrixXd normal = jacobian_.transpose() * jacobian_;
      for (;;) {
        const VectorXd step = step_of(normal, pull);
        const VectorXd fitted = r_ + jacobian_ * step;
        const double gain = cost_ - sum_of_squares(fitted);
        const bool small = step.cwiseAbs().maxCoeff() <= options_.x_tolerance;
        if (gain <= options_.cost_tolerance * cost_) {
          return small ? LeastSquaresOutcome::StepReached : LeastSquaresOutcome::CostReached;
        }
        if (spent()) return LeastSquaresOutcome::EvaluationsReached;
        VectorXd r_new;
        const double cost = evaluate(x_ + step, r_new);
        if (cost < cost_) {
          x_ += step;
          r_ = r_new;
          cost_ = cost;
          lambda_ = std::max(0.1 * lambda_, kLeastLambda);
          if (small) return LeastSquaresOutcome::StepReached;
          break;
        }
        if (small) return LeastSquaresOutcome::StepReached;
        lambda_ = std::max(10.0 * lambda_, kFirstLambda);
        if (lambda_ > kMostLambda) return LeastSquaresOutcome::Stalled;
      }
    }
  }

  /// Forward differences; backward at the upper bound, and where there is nothing ahead. A
  /// coordinate without either is not moved.
  /// @return false if the evaluations do not suffice
  bool set_slopes() {
    jacobian_ = MatrixXd::Zero(r_.size(), x_.size());
    for (Index k = 0; k < x_.size(); ++k) {
      for (const double step : {options_.difference_step, -options_.difference_step}) {
        VectorXd moved = x_;
        moved[k] += step;
        if (moved[k] > upper_[k] || moved[k] < lower_[k]) continue;
        if (spent()) return false;
        VectorXd r;
        if (!std::isfinite(evaluate(moved, r))) continue;
        jacobian_.col(k) = (r - r_) / (moved[k] - x_[k]);
        break;
      }
    }
    return true;
  }

  /// The damped step within the box. What a bound stops is held, and the others are solved again.
  VectorXd step_of(const MatrixXd& normal, const VectorXd& pull) const {
    const Index n = x_.size();
    std::vector<Index> free;
    for (Index k = 0; k < n; ++k) {
      const bool out =
          (x_[k] <= lower_[k] && pull[k] > 0.0) || (x_[k] >= upper_[k] && pull[k] < 0.0);
      if (!out && normal(k, k) > 0.0) free.push_back(k);
    }
    VectorXd step = VectorXd::Zero(n);
    while (!free.empty()) {
      const auto m = static_cast<Index>(free.size());
      MatrixXd a(m, m);
      VectorXd b(m);
      for (Index i = 0; i < m; ++i) {
        const Index row = free[static_cast<std::size_t>(i)];
        b[i] = -pull[row];
        // What is held at its bound has moved all the same.
        for (Index k = 0; k < n; ++k) b[i] -= normal(row, k) * step[k];
        for (Index j = 0; j < m; ++j) a(i, j) = normal(row, free[static_cast<std::size_t>(j)]);
        a(i, i) *= 1.0 + lambda_;
      }
      const VectorXd solved = a.ldlt().solve(b);
      const std::size_t before = free.size();
      for (Index i = m; i-- > 0;) {
        const Index k = free[static_cast<std::size_t>(i)];
        const double to = x_[k] + solved[i];
        if (to > lower_[k] && to < upper_[k]) continue;
        step[k] = (to <= lower_[k] ? lower_[k] : upper_[k]) - x_[k];
        free.erase(free.begin() + i);
      }
      if (free.size() < before) continue;
      for (Index i = 0; i < m; ++i) step[free[static_cast<std::size_t>(i)]] = solved[i];
      break;
    }
    return step;
  }

  const LeastSquaresProblem& problem_;
  const LeastSquaresOptions& options_;
  VectorXd lower_, upper_;
  VectorXd x_, r_;
  MatrixXd jacobian_;
  double cost_ = 0.0;
  double lambda_ = kFirstLambda;
  int evaluations_ = 0;
};

}  // namespace

std::string_view name_of(LeastSquaresOutcome outcome) {
  switch (outcome) {
    case LeastSquaresOutcome::StepReached: return "step-reached";
    case LeastSquaresOutcome::CostReached: return "cost-reached";
    case LeastSquaresOutcome::Stalled: return "stalled";
    case LeastSquaresOutcome::EvaluationsReached: return "evaluations-reached";
    case LeastSquaresOutcome::NoStart: return "no-start";
  }
  return "";
}

LeastSquares minimize_squares(const LeastSquaresProblem& problem,
                              const LeastSquaresOptions& options) {
  return Minimizer(problem, options).run();
}

std::vector<double> residual_slopes(const LeastSquaresProblem& problem, std::span<const double> x,
                                    std::span<const double> at, double step) {
  const std::size_t n = x.size();
  const std::size_t m = problem.residuals;
  std::vector<double> slopes(m * n);
  std::vector<double> moved(x.begin(), x.end());
  std::vector<double> above(m);
  std::vector<double> below(m);
  for (std::size_t k = 0; k < n; ++k) {
    const double high = std::min(x[k] + step, problem.upper[k]);
    const double low = std::max(x[k] - step, problem.lower[k]);
    moved[k] = high;
    if (high == x[k]) {
      std::copy(at.begin(), at.end(), above.begin());
    } else if (!problem.residual(moved, above)) {
      return {};
    }
    moved[k] = low;
    if (low == x[k]) {
      std::copy(at.begin(), at.end(), below.begin());
    } else if (!problem.residual(moved, below)) {
      return {};
    }
    moved[k] = x[k];
    for (std::size_t i = 0; i < m; ++i) slopes[i * n + k] = (above[i] - below[i]) / (high - low);
  }
  return slopes;
}

}  // namespace plastica::calibrate
