#include "calibrate/problem/objective.hpp"

#include <cmath>
#include <cstddef>

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

}  // namespace plastica::calibrate
