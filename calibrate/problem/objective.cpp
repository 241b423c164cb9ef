#include "calibrate/problem/objective.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace plastica::calibrate {

std::vector<double> path_weights(const std::vector<double>& x) {
  std::vector<double> weight(x.size(), 0.0);
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double half = 0.5 * std::fabs(x[i] - x[i - 1]);
    weight[i - 1] += half;
    weight[i] += half;
  }
  return weight;
}

std::vector<double> sample_weights(const std::vector<double>& x, Objective objective) {
  std::vector<double> weights(x.size(), 1.0);
  if (objective != Objective::Path) return weights;
  constexpr double kMin = 1e-6;
  const std::vector<double> along = path_weights(x);
  const double mean =
      std::accumulate(along.begin(), along.end(), 0.0) / static_cast<double>(along.size());
  for (std::size_t i = 0; i < x.size(); ++i) weights[i] = std::max(along[i] / mean, kMin);
  return weights;
}

}  // namespace plastica::calibrate
