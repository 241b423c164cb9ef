#include "calibrate/search/multi_start.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "calibrate/search/gauss_newton.hpp"
#include "calibrate/search/screening.hpp"

namespace plastica::calibrate {
namespace {

/// Searches that end by a tolerance of the cost are so many times that above their minimum.
constexpr double kOpen = 10.0;

}  // namespace

bool same_basin(const Basin& a, const Basin& b, double rise) {
  const Eigen::VectorXd dx = a.x - b.x;
  const double highest = rise * std::min(a.model.cost, b.model.cost);
  return dx.dot(a.model.normal * dx) <= highest && dx.dot(b.model.normal * dx) <= highest;
}

Ends search_from(const Problem& problem, const std::vector<std::vector<double>>& starts,
                 const MultiStartOptions& options, const MinimizeOptions& how,
                 const StageListener& tell, std::vector<Basin>& known) {
  const int few = std::min(how.max_evaluations, options.short_evaluations);
  std::vector<GaussNewton> searches;
  std::vector<Minimum> now;
  std::vector<double> costs;
  double least = options.known;
  for (const std::vector<double>& start : starts) {
    searches.emplace_back(problem, start, how);
    const Minimum& end = now.emplace_back(searches.back().advance(few));
    tell(kGaussNewton, end);
    costs.push_back(end.x.empty() ? std::numeric_limits<double>::infinity() : end.cost);
    least = std::min(least, costs.back());
  }
  Ends ends;
  for (const std::size_t k : ranked(costs, options.polished)) {
    GaussNewton& search = searches[k];
    Minimum& end = now[k];
    const auto is_known = [&] {
      const Basin here{search.x(), search.model()};
      return std::ranges::any_of(
          known, [&](const Basin& basin) { return same_basin(here, basin, options.rise); });
    };
    bool alike = is_known();
    int more = 0;
    while (!alike && !search.ended() && more + few <= how.max_evaluations) {
      end = search.advance(few);
      more += end.evaluations;
      alike = is_known();
    }
    if (more > 0) {
      end.evaluations = more;
      tell(kGaussNewton, end);
    }
    if (alike) {
      ends.alike.push_back(std::move(end));
      continue;
    }
    known.push_back({search.x(), search.model()});
    if (end.cost <= options.near * least) {
      end = pass_kinks(problem, std::move(end), how, tell, {.rounds = 1});
    }
    least = std::min(least, end.cost);
    ends.apart.push_back(std::move(end));
  }
  return ends;
}

Minimum least_of_basin(const Problem& problem, std::vector<Minimum> points, Minimum best,
                       const AgreementOptions& options, const MinimizeOptions& how,
                       const StageListener& tell) {
  std::ranges::stable_sort(points, {}, &Minimum::cost);
  std::size_t at_least = 1;
  std::size_t searches = 0;
  for (Minimum& point : points) {
    if (at_least >= options.enough || searches >= options.max) break;
    const int before = point.evaluations;
    Minimum end = pass_kinks(problem, std::move(point), how, tell, {.rounds = 1});
    // Where the slopes promise nothing there was none.
    if (end.evaluations > before) ++searches;
    if (end.cost < best.cost * (1.0 - options.same)) {
      at_least = 1;
    } else if (end.cost <= best.cost * (1.0 + options.same)) {
      ++at_least;
    }
    if (end.cost < best.cost * (1.0 - kOpen * how.cost_tolerance)) best = std::move(end);
  }
  return best;
}

}  // namespace plastica::calibrate
