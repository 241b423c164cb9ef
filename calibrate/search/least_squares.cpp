#include "calibrate/search/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "calibrate/search/least_squares_search.hpp"

namespace plastica::calibrate {

std::string_view name_of(LeastSquaresOutcome outcome) {
  switch (outcome) {
    case LeastSquaresOutcome::StepReached: return "step-reached";
    case LeastSquaresOutcome::CostReached: return "cost-reached";
    case LeastSquaresOutcome::Stalled: return "stalled";
    case LeastSquaresOutcome::EvaluationsReached: return "evaluations-reached";
    case LeastSquaresOutcome::NoStart: return "no-start";
    case LeastSquaresOutcome::SetAside: return "set-aside";
  }
  return "";
}

std::vector<std::size_t> leads_among(std::span<const double> points, std::size_t count) {
  const std::size_t n = count > 0 ? points.size() / count : 0;
  const auto beside = [&](std::size_t i, std::size_t lead) {
    for (std::size_t k = 0; k < n; ++k) {
      if (!(std::abs(points[i * n + k] - points[lead * n + k]) <= kBeside)) return false;
    }
    return true;
  };
  std::vector<std::size_t> leads;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t lead = 0;
    while (lead < i && !(leads[lead] == lead && beside(i, lead))) ++lead;
    leads.push_back(lead);
  }
  return leads;
}

LeastSquares minimize_squares(const LeastSquaresProblem& problem,
                              const LeastSquaresOptions& options) {
  LeastSquaresSearch search(problem, options);
  std::vector<double> residuals;
  while (!search.done()) {
    residuals.resize(search.count() * problem.residuals);
    const auto found = std::make_unique<bool[]>(search.count());
    problem.evaluate(search.points(), residuals, {found.get(), search.count()});
    search.take(residuals, {found.get(), search.count()});
  }
  return search.result();
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
  // Two points a coordinate; one that a bound holds is `x` itself, whose residuals are known. They
  // may lie beside `x`.
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
  const std::size_t first = problem.has_companions && !which.empty() ? 1 : 0;
  if (first == 1) points.insert(points.begin(), x.begin(), x.end());
  const std::size_t count = first + which.size();
  std::vector<double> moved(count * m);
  const auto found = std::make_unique<bool[]>(count);
  if (count > 0) problem.evaluate(points, moved, {found.get(), count});
  std::vector<std::span<const double>> residuals(2 * n, at);
  for (std::size_t i = 0; i < which.size(); ++i) {
    if (found[first + i]) {
      residuals[which[i]] = std::span<const double>(moved).subspan((first + i) * m, m);
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
