#include "calibrate/inference/out_of_line.hpp"

#include <cmath>

#include "plastica/base/median.hpp"

namespace plastica::calibrate {

ModifiedZScores modified_z_scores(const std::vector<double>& values) {
  ModifiedZScores found;
  if (values.size() < kFewestInLine) return found;
  found.median = median_of(values);
  std::vector<double> distances;
  distances.reserve(values.size());
  for (const double value : values) distances.push_back(std::fabs(value - found.median));
  const double deviation = median_of(distances);
  if (!(deviation > 0.0)) return found;
  for (const double value : values) {
    found.scores.push_back(0.6745 * (value - found.median) / deviation);
  }
  return found;
}

}  // namespace plastica::calibrate
