#include "calibrate/target/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace plastica::calibrate {

double largest_magnitude(std::span<const double> values) {
  // In chains of their own, since each maximum waits for the one before.
  constexpr std::size_t kChains = 8;
  std::array<double, kChains> size{};
  std::size_t i = 0;
  for (; i + kChains <= values.size(); i += kChains) {
    for (std::size_t k = 0; k < kChains; ++k) {
      size[k] = std::max(size[k], std::fabs(values[i + k]));
    }
  }
  for (; i < values.size(); ++i) size[0] = std::max(size[0], std::fabs(values[i]));
  return *std::max_element(size.begin(), size.end());
}

}  // namespace plastica::calibrate
