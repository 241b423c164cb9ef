#include "calibrate/search/gauss_newton.hpp"

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "calibrate/search/vector_of.hpp"

namespace plastica::calibrate {
namespace {

/// A cost with kinks does not keep what its slopes promise: steps from one side of a kink to the
/// other are refused, or gain little. The stage ends where so many evaluations bring less than this
/// fraction of what the undamped step promised before them.
constexpr int kPatience = 8;
constexpr double kKept = 0.1;

/// In the words of NLopt's stages.
std::string_view outcome_of(LeastSquaresOutcome outcome) {
  switch (outcome) {
    case LeastSquaresOutcome::StepReached: return "xtol-reached";
    case LeastSquaresOutcome::CostReached: return "ftol-reached";
    case LeastSquaresOutcome::EvaluationsReached: return "maxeval-reached";
    case LeastSquaresOutcome::Stalled: return "stalled";
    case LeastSquaresOutcome::NoStart:
    case LeastSquaresOutcome::SetAside: break;
  }
  return "failure";
}

}  // namespace

GaussNewton::GaussNewton(const Problem& problem, const std::vector<double>& start,
                         const MinimizeOptions& options)
    : problem_(problem),
      lower_(vector_of(problem.lower)),
      upper_(vector_of(problem.upper)),
      x_(vector_of(start)),
      steps_(lower_, upper_,
             {.max_evaluations = options.max_evaluations,
              .x_tolerance = options.x_tolerance,
              .cost_tolerance = options.cost_tolerance}) {}

Minimum GaussNewton::advance(int evaluations) {
  const int before = evaluations_;
  if (evaluations_ == 0) {
    model_ = at(x_);
    if (!std::isfinite(model_.cost)) outcome_ = LeastSquaresOutcome::NoStart;
    cost_before_ = model_.cost;
    promised_before_ = found() ? promised() : 0.0;
    watched_ = evaluations_;
  }
  auto outcome = outcome_;
  while (!outcome) {
    outcome_ = step(before + evaluations);
    outcome = outcome_;
    if (outcome == LeastSquaresOutcome::EvaluationsReached) outcome_.reset();
  }
  Minimum end;
  end.outcome = outcome_of(*outcome);
  end.evaluations = evaluations_ - before;
  end.usable = found();
  if (!found()) return end;
  end.x.assign(x_.data(), x_.data() + x_.size());
  end.cost = model_.cost;
  end.promised = promised();
  return end;
}

/// A step, unless `last` evaluations have been made. @return how the search has ended, if it has
std::optional<LeastSquaresOutcome> GaussNewton::step(int last) {
  if (evaluations_ >= watched_ + kPatience) {
    if (cost_before_ - model_.cost < kKept * promised_before_) return LeastSquaresOutcome::Stalled;
    cost_before_ = model_.cost;
    promised_before_ = promised();
    watched_ = evaluations_;
  }
  if (const auto end = steps_.propose(x_, model_)) return end;
  if (evaluations_ >= last) return LeastSquaresOutcome::EvaluationsReached;
  const Eigen::VectorXd to = steps_.target(x_);
  SquaresModel there = at(to);
  const auto end = steps_.judge(model_.cost, there.cost);
  if (steps_.accepted()) {
    x_ = to;
    model_ = std::move(there);
  }
  return end;
}

double GaussNewton::promised() const { return promised_decrease(x_, model_, lower_, upper_); }

SquaresModel GaussNewton::at(const Eigen::VectorXd& x) {
  const auto n = static_cast<std::size_t>(x.size());
  SquaresModel model;
  model.gradient.resize(x.size());
  model.normal.resize(x.size(), x.size());  // symmetric: rows or columns
  ++evaluations_;
  model.cost =
      problem_.squares({x.data(), n}, {model.gradient.data(), n}, {model.normal.data(), n * n});
  if (!std::isfinite(model.cost)) model.cost = std::numeric_limits<double>::infinity();
  return model;
}

Minimum minimize_exact_squares(const Problem& problem, const MinimizeOptions& options) {
  return GaussNewton(problem, problem.start, options).advance(options.max_evaluations);
}

}  // namespace plastica::calibrate
