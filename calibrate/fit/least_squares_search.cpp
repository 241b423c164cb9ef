#include "calibrate/fit/least_squares_search.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
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

VectorXd vector_of(std::span<const double> v) {
  return Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size()));
}

double cost_of(const VectorXd& r) {
  const double cost = r.squaredNorm();
  return std::isfinite(cost) ? cost : std::numeric_limits<double>::infinity();
}

}  // namespace

LeastSquaresSearch::LeastSquaresSearch(const LeastSquaresProblem& problem,
                                       const LeastSquaresOptions& options)
    : options_(options),
      lower_(vector_of(problem.lower)),
      upper_(vector_of(problem.upper)),
      x_(vector_of(problem.start)),
      r_(static_cast<Index>(problem.residuals)),
      lambda_(kFirstLambda) {
  ++evaluations_;
  ask(Phase::Start, problem.start, 1);
}

LeastSquares LeastSquaresSearch::result() const {
  LeastSquares result;
  result.outcome = outcome_;
  result.x.assign(x_.data(), x_.data() + x_.size());
  result.residual.assign(r_.data(), r_.data() + r_.size());
  result.cost = cost_;
  result.evaluations = evaluations_;
  return result;
}

void LeastSquaresSearch::end(LeastSquaresOutcome outcome) {
  outcome_ = outcome;
  ask(Phase::Done, {}, 0);
}

void LeastSquaresSearch::ask(Phase phase, std::vector<double> points, std::size_t count) {
  phase_ = phase;
  points_ = std::move(points);
  count_ = count;
}

void LeastSquaresSearch::take(std::span<const double> residuals, std::span<const bool> found) {
  switch (phase_) {
    case Phase::Start: take_start(residuals, found[0]); return;
    case Phase::Slopes: take_slopes(residuals, found); return;
    case Phase::Trial: take_trial(residuals, found[0]); return;
    case Phase::Done: return;
  }
}

void LeastSquaresSearch::take_start(std::span<const double> residuals, bool found) {
  r_ = vector_of(residuals);
  cost_ = found ? cost_of(r_) : std::numeric_limits<double>::infinity();
  if (!std::isfinite(cost_)) {
    end(LeastSquaresOutcome::NoStart);
  } else if (x_.size() == 0) {
    end(LeastSquaresOutcome::StepReached);
  } else {
    begin_slopes();
  }
}

/// Forward differences; backward at the upper bound, and where there is nothing ahead. A
/// coordinate without either is not moved.
void LeastSquaresSearch::begin_slopes() {
  jacobian_ = MatrixXd::Zero(r_.size(), x_.size());
  wanted_.resize(static_cast<std::size_t>(x_.size()));
  std::iota(wanted_.begin(), wanted_.end(), Index{0});
  side_ = options_.difference_step;
  ask_slopes();
}

void LeastSquaresSearch::ask_slopes() {
  std::vector<Index> left;
  std::vector<double> points;
  within_.clear();
  for (const Index k : wanted_) {
    const double to = x_[k] + side_;
    if (to > upper_[k] || to < lower_[k]) {
      left.push_back(k);
      continue;
    }
    within_.push_back(k);
    points.insert(points.end(), x_.data(), x_.data() + x_.size());
    points[points.size() - static_cast<std::size_t>(x_.size() - k)] = to;
  }
  wanted_ = std::move(left);
  const int most = options_.max_evaluations - evaluations_;
  if (static_cast<int>(within_.size()) > most) {
    end(LeastSquaresOutcome::EvaluationsReached);
  } else if (within_.empty()) {
    take_slopes({}, {});
  } else {
    evaluations_ += static_cast<int>(within_.size());
    ask(Phase::Slopes, std::move(points), within_.size());
  }
}

void LeastSquaresSearch::take_slopes(std::span<const double> residuals,
                                     std::span<const bool> found) {
  const auto m = static_cast<std::size_t>(r_.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const VectorXd r = vector_of(residuals.subspan(i * m, m));
    const Index k = within_[i];
    if (found[i] && std::isfinite(cost_of(r))) {
      const double to =
          points_[i * static_cast<std::size_t>(x_.size()) + static_cast<std::size_t>(k)];
      jacobian_.col(k) = (r - r_) / (to - x_[k]);
    } else {
      wanted_.push_back(k);
    }
  }
  if (!wanted_.empty() && side_ > 0.0) {
    side_ = -side_;
    ask_slopes();
  } else {
    begin_trials();
  }
}

void LeastSquaresSearch::begin_trials() {
  pull_ = jacobian_.transpose() * r_;
  normal_ = jacobian_.transpose() * jacobian_;
  try_step();
}

void LeastSquaresSearch::try_step() {
  step_ = step_of();
  if (!step_.allFinite()) {
    end(LeastSquaresOutcome::Stalled);
    return;
  }
  const VectorXd fitted = r_ + jacobian_ * step_;
  const double gain = cost_ - fitted.squaredNorm();
  if (gain <= options_.cost_tolerance * cost_) {
    const bool small = step_.cwiseAbs().maxCoeff() <= options_.x_tolerance;
    end(small ? LeastSquaresOutcome::StepReached : LeastSquaresOutcome::CostReached);
    return;
  }
  if (evaluations_ >= options_.max_evaluations) {
    end(LeastSquaresOutcome::EvaluationsReached);
    return;
  }
  ++evaluations_;
  const VectorXd to = x_ + step_;
  ask(Phase::Trial, std::vector<double>(to.data(), to.data() + to.size()), 1);
}

void LeastSquaresSearch::take_trial(std::span<const double> residuals, bool found) {
  const VectorXd r = vector_of(residuals);
  const double cost = found ? cost_of(r) : std::numeric_limits<double>::infinity();
  const bool small = step_.cwiseAbs().maxCoeff() <= options_.x_tolerance;
  if (cost < cost_) {
    x_ += step_;
    r_ = r;
    cost_ = cost;
    lambda_ = std::max(0.1 * lambda_, kLeastLambda);
    if (small) {
      end(LeastSquaresOutcome::StepReached);
    } else {
      begin_slopes();
    }
    return;
  }
  if (small) {
    end(LeastSquaresOutcome::StepReached);
    return;
  }
  lambda_ = std::max(10.0 * lambda_, kFirstLambda);
  if (lambda_ > kMostLambda) {
    end(LeastSquaresOutcome::Stalled);
  } else {
    try_step();
  }
}

/// The damped step within the box. What a bound stops is held, and the others are solved again.
VectorXd LeastSquaresSearch::step_of() const {
  const Index n = x_.size();
  std::vector<Index> free;
  for (Index k = 0; k < n; ++k) {
    const bool out =
        (x_[k] <= lower_[k] && pull_[k] > 0.0) || (x_[k] >= upper_[k] && pull_[k] < 0.0);
    if (!out && normal_(k, k) > 0.0) free.push_back(k);
  }
  VectorXd step = VectorXd::Zero(n);
  while (!free.empty()) {
    const auto m = static_cast<Index>(free.size());
    MatrixXd a(m, m);
    VectorXd b(m);
    for (Index i = 0; i < m; ++i) {
      const Index row = free[static_cast<std::size_t>(i)];
      b[i] = -pull_[row];
      // What is held at its bound has moved all the same.
      for (Index k = 0; k < n; ++k) b[i] -= normal_(row, k) * step[k];
      for (Index j = 0; j < m; ++j) a(i, j) = normal_(row, free[static_cast<std::size_t>(j)]);
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

}  // namespace plastica::calibrate
