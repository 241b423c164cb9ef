#include "calibrate/search/least_squares_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "calibrate/search/vector_of.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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
      steps_(lower_, upper_, options),
      has_companions_(problem.has_companions) {
  ask_point(Phase::Start, x_);
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
    case Phase::Start: take_start(residuals, found); return;
    case Phase::Slopes:
      if (has_companions_) {
        take_slopes_beside(residuals, found);
      } else {
        take_slopes(residuals, found);
      }
      return;
    case Phase::Trial: take_trial(residuals, found); return;
    case Phase::Done: return;
  }
}

/// Asks for a point and, where that costs little, for those of its differences, in case it is a
/// better one.
void LeastSquaresSearch::ask_point(Phase phase, const VectorXd& x) {
  std::vector<double> points(x.data(), x.data() + x.size());
  within_.clear();
  has_slopes_ = has_companions_ && evaluations_ + x.size() < options_.max_evaluations;
  if (has_slopes_) {
    want_all_slopes();
    add_moved(x, points);
  }
  ++evaluations_;  // of slopes once they are used
  ask(phase, std::move(points), 1 + within_.size());
}

void LeastSquaresSearch::take_start(std::span<const double> residuals,
                                    std::span<const bool> found) {
  r_ = vector_of(residuals.first(static_cast<std::size_t>(r_.size())));
  cost_ = found[0] ? cost_of(r_) : std::numeric_limits<double>::infinity();
  if (!std::isfinite(cost_)) {
    end(LeastSquaresOutcome::NoStart);
  } else if (x_.size() == 0) {
    end(LeastSquaresOutcome::StepReached);
  } else {
    begin_slopes(residuals, found);
  }
}

/// Forward differences; backward at the upper bound, and where there is nothing ahead. A
/// coordinate without either is not moved.
void LeastSquaresSearch::want_all_slopes() {
  wanted_.resize(static_cast<std::size_t>(x_.size()));
  std::iota(wanted_.begin(), wanted_.end(), Index{0});
  side_ = options_.difference_step;
}

/// @param residuals, found  of the point that the search is at now, and of what was asked for with
///                          it
void LeastSquaresSearch::begin_slopes(std::span<const double> residuals,
                                      std::span<const bool> found) {
  jacobian_ = MatrixXd::Zero(r_.size(), x_.size());
  if (has_slopes_) {
    evaluations_ += static_cast<int>(within_.size());
    take_slopes_beside(residuals, found);
  } else {
    want_all_slopes();
    ask_slopes();
  }
}

/// Adds the points of wanted slopes that lie within the box.
void LeastSquaresSearch::add_moved(const VectorXd& x, std::vector<double>& points) {
  std::vector<Index> left;
  within_.clear();
  for (const Index k : wanted_) {
    const double to = x[k] + side_;
    if (to > upper_[k] || to < lower_[k]) {
      left.push_back(k);
      continue;
    }
    within_.push_back(k);
    points.insert(points.end(), x.data(), x.data() + x.size());
    points[points.size() - static_cast<std::size_t>(x.size() - k)] = to;
  }
  wanted_ = std::move(left);
}

void LeastSquaresSearch::ask_slopes() {
  std::vector<double> points;
  if (has_companions_) points.assign(x_.data(), x_.data() + x_.size());
  add_moved(x_, points);
  const int most = options_.max_evaluations - evaluations_;
  if (static_cast<int>(within_.size()) > most) {
    end(LeastSquaresOutcome::EvaluationsReached);
  } else if (within_.empty()) {
    take_slopes({}, {});
  } else {
    evaluations_ += static_cast<int>(within_.size());
    ask(Phase::Slopes, std::move(points), within_.size() + (has_companions_ ? 1 : 0));
  }
}

/// Those of points that were asked for behind the one that they lie beside.
void LeastSquaresSearch::take_slopes_beside(std::span<const double> residuals,
                                            std::span<const bool> found) {
  points_.erase(points_.begin(), points_.begin() + x_.size());
  take_slopes(residuals.subspan(static_cast<std::size_t>(r_.size())), found.subspan(1));
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
  model_ = {cost_, jacobian_.transpose() * r_, jacobian_.transpose() * jacobian_};
  try_step();
}

void LeastSquaresSearch::try_step() {
  if (const auto ended = steps_.propose(x_, model_)) {
    end(*ended);
    return;
  }
  if (evaluations_ >= options_.max_evaluations) {
    end(LeastSquaresOutcome::EvaluationsReached);
    return;
  }
  ask_point(Phase::Trial, steps_.target(x_));
}

void LeastSquaresSearch::take_trial(std::span<const double> residuals,
                                    std::span<const bool> found) {
  const VectorXd r = vector_of(residuals.first(static_cast<std::size_t>(r_.size())));
  const double cost = found[0] ? cost_of(r) : std::numeric_limits<double>::infinity();
  const auto ended = steps_.judge(cost_, cost);
  if (steps_.accepted()) {
    x_ = vector_of(std::span<const double>(points_).first(static_cast<std::size_t>(x_.size())));
    r_ = r;
    cost_ = cost;
  }
  if (ended) {
    end(*ended);
  } else if (steps_.accepted()) {
    begin_slopes(residuals, found);
  } else {
    try_step();
  }
}

}  // namespace plastica::calibrate
