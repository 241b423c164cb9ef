#pragma once

#include <vector>

namespace plastica::testing {

/// From one turning point over the next to the last, in even steps.
inline std::vector<double> path_over(const std::vector<double>& turning_points, int steps) {
  std::vector<double> path;
  double from = 0.0;
  for (const double to : turning_points) {
    for (int i = 1; i <= steps; ++i) path.push_back(from + (to - from) * i / steps);
    from = to;
  }
  return path;
}

}  // namespace plastica::testing
