#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace plastica {

/// The middle one of some values; of an even number of them the mean of the two in the middle.
/// @param values  one or more, none of them NaN
inline double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) return *middle;
  // Halves are added: the sum of two may overflow.
  return 0.5 * *std::max_element(values.begin(), middle) + 0.5 * *middle;
}

}  // namespace plastica
