#include "calibrate/search/gauss_newton.hpp"

#include <cmath>
#include <limits>

#include "calibrate/search/marquardt_steps.hpp"

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

class ExactSquares {
 public:
  ExactSquares(const Problem& problem, const MinimizeOptions& options)
      : problem_(problem),
        options_(options),
        lower_(vector_of(problem.lower)),
        upper_(vector_of(problem.upper)),
        steps_(lower_, upper_,
               {.max_evaluations = options.max_evaluations,
                .x_tolerance = options.x_tolerance,
                .cost_tolerance = options.cost_tolerance}) {}

  Minimum run() {
    Eigen::VectorXd x = vector_of(problem_.start);
    SquaresModel model = at(x);
    const bool any = std::isfinite(model.cost);
    const LeastSquaresOutcome outcome = any ? descend(x, model) : LeastSquaresOutcome::NoStart;
    Minimum end;
    end.outcome = outcome_of(outcome);
    end.evaluations = evaluations_;
    end.usable = any;
    if (!any) return end;
    end.x.assign(x.data(), x.data() + x.size());
    end.cost = model.cost;
    end.promised = promised_decrease(x, model, lower_, upper_);
    return end;
  }

 private:
  static Eigen::VectorXd vector_of(const std::vector<double>& v) {
    return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
  }

  LeastSquaresOutcome descend(Eigen::VectorXd& x, SquaresModel& model) {
    double cost = model.cost;
    double promised = promised_decrease(x, model, lower_, upper_);
    int last = evaluations_;
    for (;;) {
      if (evaluations_ >= last + kPatience) {
        if (cost - model.cost < kKept * promised) return LeastSquaresOutcome::Stalled;
        cost = model.cost;
        promised = promised_decrease(x, model, lower_, upper_);
        last = evaluations_;
      }
      if (const auto end = steps_.propose(x, model)) return *end;
      if (evaluations_ >= options_.max_evaluations) return LeastSquaresOutcome::EvaluationsReached;
      const Eigen::VectorXd to = steps_.target(x);
      SquaresModel there = at(to);
      const auto end = steps_.judge(model.cost, there.cost);
      if (steps_.accepted()) {
        x = to;
        model = std::move(there);
      }
      if (end) return *end;
    }
  }

  SquaresModel at(const Eigen::VectorXd& x) {
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

  const Problem& problem_;
  const MinimizeOptions& options_;
  Eigen::VectorXd lower_, upper_;
  MarquardtSteps steps_;
  int evaluations_ = 0;
};

}  // namespace

Minimum minimize_exact_squares(const Problem& problem, const MinimizeOptions& options) {
  return ExactSquares(problem, options).run();
}

}  // namespace plastica::calibrate
