#include "calibrate/inference/out_of_line.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::calibrate {
namespace {

/// @param values  one or more
double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  // Halves are added: the sum of two may overflow.
  return values.size() % 2 == 1 ? values[half] : 0.5 * values[half - 1] + 0.5 * values[half];
}

}  // namespace

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
