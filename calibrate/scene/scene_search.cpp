#include "calibrate/scene/scene_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plastica/theory/sampling.hpp"

namespace plastica::calibrate {
namespace {

/// Of the fits that set a part's noise by what is left of it.
constexpr int kMostRounds = 4;
constexpr double kSameNoise = 0.05;

}  // namespace

double largest_size(std::span<const double> values) {
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  return largest;
}

SceneSearch::SceneSearch(SceneProblem& problem, const SceneFitOptions& options)
    : problem_(problem), options_(options) {
  const std::span<const ScenePart> parts = problem.parts();
  knows_noise_ = std::all_of(parts.begin(), parts.end(),
                             [](const ScenePart& part) { return part.target.noise; });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double range = largest_size(parts[i].target.ordinate);
    problem.set_scale(i, parts[i].target.noise.value_or(range > 0.0 ? range : 1.0));
  }
}

void SceneSearch::run() {
  search();
  if (found()) settle_noise();
}

LeastSquares SceneSearch::search_from(std::span<const double> start) {
  LeastSquaresOptions how;
  how.max_evaluations = options_.evaluations;
  how.x_tolerance = options_.tolerance;
  LeastSquaresProblem problem = problem_.squares();
  problem.start.assign(start.begin(), start.end());
  return minimize_squares(problem, how);
}

std::vector<double> SceneSearch::searched_values(std::span<const double> x) const {
  std::vector<double> values = problem_.parameters().values(x);
  values.resize(x.size());
  return values;
}

void SceneSearch::search() {
  const LeastSquaresProblem& squares = problem_.squares();
  const std::size_t n = squares.start.size();
  const auto others = static_cast<std::size_t>(options_.starts - 1);
  // The first of Sobol's points is a corner; with a seed all are scrambled.
  const std::vector<double> drawn =
      n > 0 ? theory::sobol(others, n, options_.seed) : std::vector<double>();
  for (std::size_t k = 0; k <= (n > 0 ? others : 0); ++k) {
    std::vector<double> from = squares.start;
    for (std::size_t i = 0; k > 0 && i < n; ++i) {
      const double share = drawn[(k - 1) * n + i];
      from[i] = squares.lower[i] + share * (squares.upper[i] - squares.lower[i]);
    }
    LeastSquares found = search_from(from);
    SceneStart start;
    start.from = searched_values(from);
    start.outcome = found.outcome;
    start.evaluations = found.evaluations;
    const bool any = found.outcome != LeastSquaresOutcome::NoStart;
    start.cost = any ? found.cost : std::numeric_limits<double>::infinity();
    if (any) start.to = searched_values(found.x);
    starts_.push_back(std::move(start));
    if (k == 0) {
      first_reason_ = problem_.reason();
      start_turns_ = !any && problem_.turned();
    }
    if (!any) continue;
    if (best_.outcome == LeastSquaresOutcome::NoStart || found.cost < best_.cost) {
      best_ = std::move(found);
    }
  }
}

double SceneSearch::cost_of(std::size_t part) const {
  const std::size_t first = problem_.first_residual(part);
  double sum = 0.0;
  for (std::size_t i = 0; i < problem_.parts()[part].target.ordinate.size(); ++i) {
    sum += best_.residual[first + i] * best_.residual[first + i];
  }
  const double scale = problem_.scale(part);
  return sum * scale * scale / problem_.parts()[part].weight;
}

double SceneSearch::noise_left(std::size_t part) const {
  const auto samples = static_cast<double>(problem_.parts()[part].target.ordinate.size());
  const auto taken =
      static_cast<double>(problem_.parameters().size()) / static_cast<double>(problem_.samples());
  return std::sqrt(cost_of(part) / (samples * (1.0 - taken)));
}

/// Weights parts by the noise that they turn out to have.
void SceneSearch::settle_noise() {
  for (int round = 0; !knows_noise_; ++round) {
    double change = 0.0;
    for (std::size_t part = 0; part < problem_.parts().size(); ++part) {
      if (problem_.parts()[part].target.noise) continue;
      // Without any residual its range goes on to weight it.
      const double noise = noise_left(part);
      if (!(noise > 1e-12 * problem_.scale(part))) continue;
      const double factor = problem_.scale(part) / noise;
      change = std::max(change, std::abs(factor - 1.0));
      const std::size_t first = problem_.first_residual(part);
      for (std::size_t i = 0; i < problem_.parts()[part].target.ordinate.size(); ++i) {
        best_.residual[first + i] *= factor;
      }
      problem_.set_scale(part, noise);
    }
    best_.cost = 0.0;
    for (const double r : best_.residual) best_.cost += r * r;
    const bool alone =
        problem_.parts().size() == 1 && problem_.squares().residuals == problem_.samples();
    if (alone || change < kSameNoise || round == kMostRounds) return;
    LeastSquares again = search_from(best_.x);
    if (again.outcome != LeastSquaresOutcome::NoStart) best_ = std::move(again);
  }
}

}  // namespace plastica::calibrate
