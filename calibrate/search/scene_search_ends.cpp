#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "calibrate/inference/bootstrap.hpp"
#include "calibrate/search/scene_search.hpp"
#include "calibrate/search/search_by_algorithm.hpp"

/// The stages of a search that go on from one point.
namespace plastica::calibrate {

std::string kept_name(std::string_view stage, std::size_t index) {
  return std::string(stage) + " " + std::to_string(index);
}

double cost_of_search(const LeastSquares& found) {
  return found.outcome == LeastSquaresOutcome::NoStart ? std::numeric_limits<double>::infinity()
                                                       : found.cost;
}

/// What one search alone makes, unless an earlier fit has kept it.
SearchRecord SceneSearch::made_once(std::string_view stage,
                                    const std::function<SearchRecord()>& make) {
  const SceneFitHooks& hooks = options_.hooks;
  const std::vector<std::byte>* kept = hooks.find ? hooks.find(kept_name(stage, 0)) : nullptr;
  if (kept != nullptr) {
    SearchRecord record = search_record_from(*kept);
    problem_.count(record.runs);
    return record;
  }
  tell(stage, 0, 1);
  SearchRecord record = make();
  if (hooks.keep) hooks.keep(kept_name(stage, 0), bytes_of(record));
  tell(stage, 1, 1);
  return record;
}

/// By the algorithm that the options name.
SearchRecord SceneSearch::search_alone() {
  return made_once("search", [&] {
    return search_by_algorithm(problem_, {.name = options_.algorithm,
                                          .evaluations = options_.evaluations,
                                          .tolerance = options_.tolerance,
                                          .seed = options_.seed});
  });
}

/// Coupons yield all at once, so that the sum of squares has a kink at each sample, and many minima
/// near the best point. Looks for the least of them from seeded points around it, at which the sum
/// would be up to a tenth higher if it were a parabola, as fits of curves do.
void SceneSearch::search_around() {
  constexpr int kAround = 16;
  constexpr double kRise = 0.1;
  for (std::size_t t = 0; t < problem_.targets().size(); ++t) {
    if (problem_.model(t).level() != Level::Coupon) return;
  }
  if (options_.algorithm != "auto" || options_.starts == 1 || best_.x.empty() ||
      best_.outcome == LeastSquaresOutcome::NoStart) {
    return;
  }
  const LeastSquaresProblem& squares = problem_.squares();
  const std::size_t n = best_.x.size();
  const std::vector<double> slopes = residual_slopes(squares, best_.x, best_.residual, kErrorStep);
  std::vector<double> reach(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    double curvature = 0.0;
    for (std::size_t i = 0; i < squares.residuals; ++i) {
      curvature += slopes[i * n + k] * slopes[i * n + k];
    }
    if (curvature > 0.0) reach[k] = std::sqrt(kRise * best_.cost / curvature);
  }
  Points points(kAround, best_.x);
  for (int p = 0; p < kAround; ++p) {
    Draws draws(options_.seed, static_cast<std::uint64_t>(p));
    std::vector<double>& x = points[static_cast<std::size_t>(p)];
    for (std::size_t k = 0; k < n; ++k) {
      x[k] = std::clamp(x[k] + reach[k] * (2.0 * draws.uniform() - 1.0), squares.lower[k],
                        squares.upper[k]);
    }
  }
  for (SearchRecord& record : search_from("around", points, options_.evaluations)) {
    if (cost_of_search(record.found) < best_.cost) best_ = std::move(record.found);
  }
}

/// Goes on with the best point past kinks, where steps are refused.
void SceneSearch::pass_kinks(std::string_view stage) {
  const bool any = best_.outcome != LeastSquaresOutcome::NoStart && !best_.x.empty();
  if (!any || options_.algorithm != "auto") return;
  best_ = made_once(stage, [&] {
            return search_past_kinks(problem_, best_,
                                     {.name = {},
                                      .evaluations = options_.evaluations,
                                      .tolerance = options_.tolerance,
                                      .seed = options_.seed});
          }).found;
}

}  // namespace plastica::calibrate
