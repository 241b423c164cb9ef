#include "plastica/run/path_stops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace plastica {

PathStops path_stops(const Scene& scene, const SolverOptions& options) {
  std::vector<double> corners;
  const auto add = [&](const History& history) {
    const auto take = [&](const std::vector<double>& times) {
      corners.insert(corners.end(), times.begin(), times.end());
    };
    take(history.corners());
    if (options.analysis == Analysis::Statics) take(history.reversals());
  };
  for (const Load& load : scene.loads) add(load.history);
  for (const Support& support : scene.supports) {
    if (support.moves()) add(support.history);
  }
  if (scene.gravity != std::array<double, 3>{}) add(scene.gravity_history);
  double duration = options.duration;
  if (duration == 0.0) {
    duration = corners.empty() ? 0.0 : *std::max_element(corners.begin(), corners.end());
  }
  if (duration == 0.0) duration = 1.0;  // loads that are there from the beginning
  // A sine of 90 deg turns at the beginning, but for rounding: at 2e-18 s.
  const double least = 1e-9 * duration;
  std::erase_if(corners, [least](double corner) { return corner < least; });
  for (const Cut& cut : scene.cuts) corners.push_back(cut.time);

  const int steps = options.steps;
  std::vector<std::pair<double, bool>> stops;
  for (int k = 1; k <= steps; ++k) {
    stops.emplace_back(k == steps ? duration : duration * k / steps, true);
  }
  // Of corners within 1e-9 of each other, or of a sample, one stop; a file may have 100 000 of
  // them.
  std::sort(corners.begin(), corners.end());
  std::vector<std::pair<double, bool>> between;
  auto next = stops.begin();
  double last = 0.0;
  for (const double corner : corners) {
    if (corner <= 0.0 || corner >= duration) continue;
    while (next != stops.end() && next->first < corner - least) ++next;
    const bool on_sample = next != stops.end() && std::abs(next->first - corner) < least;
    if (on_sample || (!between.empty() && corner - last < least)) continue;
    between.emplace_back(corner, false);
    last = corner;
  }
  stops.insert(stops.end(), between.begin(), between.end());
  std::sort(stops.begin(), stops.end());
  PathStops all;
  for (const auto& [time, recorded] : stops) {
    all.time.push_back(time);
    all.recorded.push_back(recorded);
  }
  return all;
}

FixedSteps fixed_steps(const PathStops& stops, double time_step) {
  FixedSteps steps;
  double begin = 0.0;
  double sample = 0.0;
  for (std::size_t k = 0; k < stops.time.size(); ++k) {
    const double interval = stops.time[k] - begin;
    const double parts = std::max(std::ceil(interval / time_step - 1e-9), 1.0);
    steps.longest = std::max(steps.longest, interval / parts);
    if (interval > 0.0) steps.count += parts;
    begin = stops.time[k];
    if (!stops.recorded[k]) continue;
    steps.samples = std::max(steps.samples, begin - sample);
    sample = begin;
  }
  return steps;
}

double taken_time_step(const Scene& scene, const SolverOptions& options) {
  const bool fixed = options.analysis == Analysis::Dynamics && options.step_error == 0.0 &&
                     !scene.is_coupon() && options.steps > 0 && options.time_step > 0.0;
  if (!fixed) return options.time_step;
  return fixed_steps(path_stops(scene, options), options.time_step).longest;
}

}  // namespace plastica
