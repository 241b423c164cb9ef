#include "calibrate/problem/part_noise.hpp"

#include <algorithm>
#include <cmath>

#include "calibrate/problem/scene_problem.hpp"

namespace plastica::calibrate {
double size_of(const ScenePart& part) {
  const double largest = largest_size(part.target.ordinate);
  return largest > 0.0 ? largest : 1.0;
}

double largest_size(std::span<const double> values) {
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  return largest;
}

std::vector<PartNoise> noise_of_parts(const SceneProblem& problem, std::span<const double> costs,
                                      std::span<const double> degrees,
                                      std::span<const PartNoise> before) {
  const std::span<const ScenePart> parts = problem.parts();
  double fractions = 0.0, all = 0.0;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const double size = size_of(parts[part]);
    fractions += costs[part] / (size * size);
    all += degrees[part];
  }
  std::vector<PartNoise> noise;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    PartNoise& made = noise.emplace_back();
    made.degrees_left = degrees[part];
    if (parts[part].target.noise) {
      made.deviation = *parts[part].target.noise;
      continue;
    }
    const bool lone = parts.size() == 1;
    made.pooled = before[part].pooled || (!lone && degrees[part] < kFewestDegrees);
    made.degrees_of_freedom = made.pooled ? all : degrees[part];
    made.deviation = made.pooled ? size_of(parts[part]) * std::sqrt(fractions / all)
                                 : std::sqrt(costs[part] / degrees[part]);
  }
  return noise;
}

double degrees_of_freedom(std::span<const PartNoise> noise) {
  double all = 0.0;
  bool known = true;
  for (const PartNoise& part : noise) {
    if (std::isinf(part.degrees_of_freedom)) continue;
    known = false;
    all += part.degrees_left;
  }
  return known ? std::numeric_limits<double>::infinity() : all;
}

}  // namespace plastica::calibrate
