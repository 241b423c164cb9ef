#include "calibrate/search/search_by_algorithm.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/search/marquardt_steps.hpp"
#include "calibrate/search/minimize_alone.hpp"
#include "calibrate/search/pass_kinks.hpp"
#include "calibrate/search/vector_of.hpp"

namespace plastica::calibrate {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// NLopt's word in those of a least-squares search.
LeastSquaresOutcome outcome_of(std::string_view word) {
  if (word == "xtol-reached") return LeastSquaresOutcome::StepReached;
  if (word == "ftol-reached") return LeastSquaresOutcome::CostReached;
  if (word == "maxeval-reached") return LeastSquaresOutcome::EvaluationsReached;
  return LeastSquaresOutcome::Stalled;
}

/// A problem's sum of squares as NLopt asks for it, and the best point so far.
class SumOfSquares {
 public:
  explicit SumOfSquares(SceneProblem& problem) : problem_(problem), squares_(problem.squares()) {}

  double cost(std::span<const double> x, std::span<double> gradient) {
    const bool slopes = !gradient.empty();
    const double cost = run(x, slopes);
    if (slopes && cost < kInfinite) set_gradient(gradient, 2.0);
    return cost;
  }

  double with_normal(std::span<const double> x, std::span<double> gradient,
                     std::span<double> normal) {
    const double cost = run(x, true);
    if (!(cost < kInfinite)) return cost;
    set_gradient(gradient, 1.0);
    const std::size_t n = x.size();
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < squares_.residuals; ++i) sum += slope(a, i) * slope(b, i);
        normal[a * n + b] = sum;
      }
    }
    return cost;
  }

  /// Starts from what is known of a point.
  void begin_at(const LeastSquares& found) {
    record_.found = found;
    record_.found.evaluations = 0;
  }

  SearchRecord& record() { return record_; }

 private:
  static constexpr double kStep = 1e-5;

  /// Runs the point, and with slopes a neighbour of it in each coordinate. @return its cost
  double run(std::span<const double> x, bool slopes) {
    const std::size_t n = x.size(), m = squares_.residuals;
    const std::size_t count = slopes ? n + 1 : 1;
    std::vector<double> points;
    for (std::size_t k = 0; k < count; ++k) points.insert(points.end(), x.begin(), x.end());
    step_.assign(n, 0.0);
    for (std::size_t k = 0; slopes && k < n; ++k) {
      step_[k] = x[k] + kStep > squares_.upper[k] ? -kStep : kStep;
      points[(k + 1) * n + k] += step_[k];
    }
    residuals_.resize(count * m);
    const std::vector<PointRun> runs = problem_.evaluate(points, count, residuals_);
    found_.assign(count, false);
    for (std::size_t k = 0; k < count; ++k) {
      found_[k] = runs[k].found;
      record_.runs.add(runs[k].runs);
    }
    if (record_.found.evaluations == 0) record_.start = runs.front();
    record_.found.evaluations += static_cast<int>(count);
    if (!found_[0]) return kInfinite;
    double cost = 0.0;
    for (std::size_t i = 0; i < m; ++i) cost += residuals_[i] * residuals_[i];
    if (record_.found.x.empty() || cost < record_.found.cost) {
      record_.found.x.assign(x.begin(), x.end());
      record_.found.residual.assign(residuals_.begin(),
                                    residuals_.begin() + static_cast<std::ptrdiff_t>(m));
      record_.found.cost = cost;
    }
    return cost;
  }

  /// d residual i / d coordinate k; 0 where the neighbour has no curve.
  double slope(std::size_t k, std::size_t i) const {
    if (!found_[k + 1]) return 0.0;
    return (residuals_[(k + 1) * squares_.residuals + i] - residuals_[i]) / step_[k];
  }

  void set_gradient(std::span<double> gradient, double factor) const {
    for (std::size_t k = 0; k < gradient.size(); ++k) {
      double sum = 0.0;
      for (std::size_t i = 0; i < squares_.residuals; ++i) sum += residuals_[i] * slope(k, i);
      gradient[k] = factor * sum;
    }
  }

  SceneProblem& problem_;
  const LeastSquaresProblem& squares_;
  SearchRecord record_;
  std::vector<double> residuals_, step_;
  std::vector<bool> found_;
};

Problem box_of(const LeastSquaresProblem& problem, SumOfSquares& squares) {
  return {problem.lower, problem.upper, problem.start,
          [&](std::span<const double> x, std::span<double> gradient) {
            return squares.cost(x, gradient);
          },
          [&](std::span<const double> x, std::span<double> gradient, std::span<double> normal) {
            return squares.with_normal(x, gradient, normal);
          }};
}

/// What a step after Gauss and Newton promises to take off the cost, by central slopes.
double promise_at(const LeastSquaresProblem& problem, const LeastSquares& at) {
  const std::vector<double> slopes = residual_slopes(problem, at.x, at.residual, kErrorStep);
  const auto m = static_cast<Eigen::Index>(problem.residuals);
  const auto n = static_cast<Eigen::Index>(at.x.size());
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Rows j = Eigen::Map<const Rows>(slopes.data(), m, n).unaryExpr([](double slope) {
    return std::isfinite(slope) ? slope : 0.0;  // no curve on either side
  });
  SquaresModel model;
  model.cost = at.cost;
  model.gradient = j.transpose() * vector_of(at.residual);
  model.normal = j.transpose() * j;
  return promised_decrease(vector_of(at.x), model, vector_of(problem.lower),
                           vector_of(problem.upper));
}

}  // namespace

SearchRecord search_by_algorithm(SceneProblem& problem, const AlgorithmOptions& options) {
  SumOfSquares squares(problem);
  const Problem box = box_of(problem.squares(), squares);
  const auto n = static_cast<int>(box.start.size());
  MinimizeOptions how;
  how.algorithm = options.name;
  how.x_tolerance = options.tolerance;
  how.seed = options.seed;
  // The scales of the coordinates take one evaluation with slopes.
  const int for_scales = n + 1;
  const int each = needs_gradient(options.name) ? n + 1 : 1;
  how.max_evaluations = std::max(1, (options.evaluations - for_scales) / each);
  const Minimum end = minimize_alone(box, how);
  SearchRecord record = std::move(squares.record());
  const bool none = record.found.x.empty();
  record.found.outcome = none ? LeastSquaresOutcome::NoStart : outcome_of(end.outcome);
  return record;
}

SearchRecord search_past_kinks(SceneProblem& problem, const LeastSquares& from,
                               const AlgorithmOptions& options) {
  constexpr double kMatters = 1e-6;
  SumOfSquares squares(problem);
  squares.begin_at(from);
  Minimum stopped;
  stopped.x = from.x;
  stopped.cost = from.cost;
  const RunCounters before = problem.counters();
  stopped.promised = promise_at(problem.squares(), from);
  const RunCounters after = problem.counters();
  MinimizeOptions how;
  how.x_tolerance = options.tolerance;
  how.seed = options.seed;
  how.max_evaluations =
      std::max(1, options.evaluations / static_cast<int>(problem.squares().start.size() + 1));
  const StageListener nobody = [](std::string_view, const Minimum&) {};
  (void)pass_kinks(box_of(problem.squares(), squares), std::move(stopped), how, nobody,
                   {.worthwhile = kMatters});
  SearchRecord record = std::move(squares.record());
  record.found.evaluations += from.evaluations;
  // The slopes' runs are known where the point has stayed: who asks for its slopes next counts
  // them.
  if (record.found.x != from.x) {
    record.runs.add({after.runs - before.runs, after.failed - before.failed,
                     after.segment_iterations - before.segment_iterations});
  }
  return record;
}

}  // namespace plastica::calibrate
