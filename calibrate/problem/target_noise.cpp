#include "calibrate/problem/target_noise.hpp"

#include <algorithm>
#include <cmath>

#include "calibrate/problem/scene_problem.hpp"

namespace plastica::calibrate {
double size_of(const WeightedTarget& weighted) {
  const double largest = largest_size(weighted.target.ordinate);
  return largest > 0.0 ? largest : 1.0;
}

double largest_size(std::span<const double> values) {
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  return largest;
}

std::vector<TargetNoise> noise_of_targets(const SceneProblem& problem,
                                          std::span<const double> costs,
                                          std::span<const double> degrees,
                                          std::span<const TargetNoise> before) {
  const std::span<const WeightedTarget> targets = problem.targets();
  double fractions = 0.0, all = 0.0;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const double size = size_of(targets[t]);
    fractions += costs[t] / (size * size);
    all += degrees[t];
  }
  std::vector<TargetNoise> noise;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    TargetNoise& made = noise.emplace_back();
    made.degrees_left = degrees[t];
    if (targets[t].target.noise) {
      made.deviation = *targets[t].target.noise;
      continue;
    }
    const bool lone = targets.size() == 1;
    made.pooled = before[t].pooled || (!lone && degrees[t] < kMinDegrees);
    // Of unequal weights the expected squares may be more than those of all samples.
    const auto samples = static_cast<double>(targets[t].target.ordinate.size());
    made.degrees_of_freedom = made.pooled ? all : std::min(degrees[t], samples);
    made.deviation = made.pooled ? size_of(targets[t]) * std::sqrt(fractions / all)
                                 : std::sqrt(costs[t] / degrees[t]);
  }
  return noise;
}

double degrees_of_freedom(std::span<const TargetNoise> noise) {
  double all = 0.0;
  bool known = true;
  for (const TargetNoise& one : noise) {
    if (std::isinf(one.degrees_of_freedom)) continue;
    known = false;
    all += one.degrees_left;
  }
  return known ? std::numeric_limits<double>::infinity() : all;
}

}  // namespace plastica::calibrate
