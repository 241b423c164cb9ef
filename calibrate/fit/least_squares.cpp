#include "calibrate/fit/least_squares.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFirstLambda = 1e-3;
constexpr double kLeastLambda = 1e-12;
constexpr double kMostLambda = 1e12;

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
    bool found = false;
    problem_.evaluate(span_of(x), span_of(r), {&found, 1});
    return found ? cost_of(r) : std::numeric_limits<double>::infinity();
  }

  static double cost_of(const VectorXd& r) {
    const double cost = r.squaredNorm();
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
        const double gain = cost_ - fitted.squaredNorm();
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
    std::vector<Index> wanted(static_cast<std::size_t>(x_.size()));
    std::iota(wanted.begin(), wanted.end(), Index{0});
    for (const double step : {options_.difference_step, -options_.difference_step}) {
      std::vector<Index> within, left;
      for (const Index k : wanted) {
        const double to = x_[k] + step;
        (to > upper_[k] || to < lower_[k] ? left : within).push_back(k);
      }
      const int most = options_.max_evaluations - evaluations_;
      if (static_cast<int>(within.size()) > most) return false;
      evaluations_ += static_cast<int>(within.size());
      const std::vector<Index> failed = set_slopes_of(within, step);
      left.insert(left.end(), failed.begin(), failed.end());
      wanted = std::move(left);
      if (wanted.empty()) break;
    }
    return true;
  }

  /// @return those that have no residuals there
  std::vector<Index> set_slopes_of(const std::vector<Index>& coordinates, double step) {
    const std::size_t count = coordinates.size();
    const auto n = static_cast<std::size_t>(x_.size());
    const auto m = static_cast<std::size_t>(r_.size());
    std::vector<double> points;
    points.reserve(count * n);
    for (const Index k : coordinates) {
      VectorXd moved = x_;
      moved[k] += step;
      points.insert(points.end(), moved.data(), moved.data() + n);
    }
    std::vector<double> residuals(count * m);
    const auto found = std::make_unique<bool[]>(count);
    if (count > 0) problem_.evaluate(points, residuals, {found.get(), count});
    std::vector<Index> failed;
    for (std::size_t i = 0; i < count; ++i) {
      const VectorXd r = Eigen::Map<const VectorXd>(residuals.data() + i * m, r_.size());
      const Index k = coordinates[i];
      if (found[i] && std::isfinite(cost_of(r))) {
        jacobian_.col(k) = (r - r_) / (points[i * n + static_cast<std::size_t>(k)] - x_[k]);
      } else {
        failed.push_back(k);
      }
    }
    return failed;
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

LeastSquaresProblem::AtPoints one_by_one(LeastSquaresProblem::AtPoint residual) {
  return [residual = std::move(residual)](std::span<const double> points,
                                          std::span<double> residuals, std::span<bool> found) {
    const std::size_t n = points.size() / found.size();
    const std::size_t m = residuals.size() / found.size();
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i] = residual(points.subspan(i * n, n), residuals.subspan(i * m, m));
    }
  };
}

std::vector<double> residual_slopes(const LeastSquaresProblem& problem, std::span<const double> x,
                                    std::span<const double> at, double step) {
  const std::size_t n = x.size();
  const std::size_t m = problem.residuals;
  // Two points a coordinate; one that a bound holds is `x` itself, whose residuals are known.
  std::vector<double> ends(2 * n);
  std::vector<double> points;
  std::vector<std::size_t> which;
  for (std::size_t k = 0; k < n; ++k) {
    ends[2 * k] = std::min(x[k] + step, problem.upper[k]);
    ends[2 * k + 1] = std::max(x[k] - step, problem.lower[k]);
    for (const std::size_t end : {2 * k, 2 * k + 1}) {
      if (ends[end] == x[k]) continue;
      which.push_back(end);
      points.insert(points.end(), x.begin(), x.end());
      points[points.size() - n + k] = ends[end];
    }
  }
  std::vector<double> moved(which.size() * m);
  const auto found = std::make_unique<bool[]>(which.size());
  if (!which.empty()) problem.evaluate(points, moved, {found.get(), which.size()});
  std::vector<std::span<const double>> residuals(2 * n, at);
  for (std::size_t i = 0; i < which.size(); ++i) {
    if (found[i]) {
      residuals[which[i]] = std::span<const double>(moved).subspan(i * m, m);
    } else {
      ends[which[i]] = x[which[i] / 2];  // the other side alone
    }
  }
  std::vector<double> slopes(m * n);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < m; ++i) {
      // 0/0 where there is nothing on either side.
      slopes[i * n + k] =
          (residuals[2 * k][i] - residuals[2 * k + 1][i]) / (ends[2 * k] - ends[2 * k + 1]);
    }
  }
  return slopes;
}

}  // namespace plastica::calibrate
