#include "calibrate/search/multi_start.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "calibrate/search/screening.hpp"

namespace plastica::calibrate {

Minimum search_from(const Problem& problem, const std::vector<std::vector<double>>& starts,
                    const MultiStartOptions& options, const MinimizeOptions& how,
                    const StageListener& tell) {
  Problem from = problem;
  MinimizeOptions brief = how;
  brief.algorithm = kGaussNewton;
  brief.max_evaluations = std::min(how.max_evaluations, options.short_evaluations);
  std::vector<std::vector<double>> ends;
  std::vector<double> costs;
  for (const std::vector<double>& start : starts) {
    from.start = start;
    Minimum end = minimize(from, brief);
    tell(brief.algorithm, end);
    costs.push_back(end.x.empty() ? std::numeric_limits<double>::infinity() : end.cost);
    ends.push_back(std::move(end.x));
  }
  Minimum best;
  double least = options.known;
  for (const double cost : costs) least = std::min(least, cost);
  for (const std::size_t k : ranked(costs, options.polished)) {
    from.start = ends[k];
    Minimum end = descend(from, how, tell, {.rounds = 1, .highest_cost = options.near * least});
    least = std::min(least, end.cost);
    if (best.x.empty() || end.cost < best.cost) best = std::move(end);
  }
  return best;
}

}  // namespace plastica::calibrate
