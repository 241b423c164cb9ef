#include "calibrate/target/several_specimens.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace plastica::calibrate {
namespace {

/// Numbers that are not finite are as the one before.
std::vector<double> sizes_of(std::span<const double> values) {
  std::vector<double> sizes;
  double last = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) last = std::abs(value);
    sizes.push_back(last);
  }
  return sizes;
}

double median_step(const std::vector<double>& sizes) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < sizes.size(); ++i) steps.push_back(std::abs(sizes[i] - sizes[i - 1]));
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

}  // namespace

std::optional<std::size_t> find_next_specimen(std::span<const double> deformation,
                                              std::span<const double> load) {
  constexpr std::size_t kFewest = 10;
  if (deformation.size() < kFewest) return std::nullopt;
  const std::vector<double> way = sizes_of(deformation);
  const std::vector<double> size = sizes_of(load);
  const double most_load = *std::ranges::max_element(size);
  const double far = 10.0 * median_step(way);
  const double most_way = *std::ranges::max_element(way);
  double reached = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    reached = std::max(reached, way[i - 1]);
    const bool jumps = way[i - 1] - way[i] > far && way[i] <= 0.05 * reached &&
                       way[i - 1] >= 0.5 * reached && reached > 0.1 * most_way;
    if (!jumps || size[i] > 0.1 * most_load) continue;
    const auto from = static_cast<std::ptrdiff_t>(i);
    const double way_after = *std::max_element(way.begin() + from, way.end());
    const double load_after = *std::max_element(size.begin() + from, size.end());
    if (way_after > 0.1 * reached && load_after > 0.5 * most_load) return i;
  }
  return std::nullopt;
}

}  // namespace plastica::calibrate
