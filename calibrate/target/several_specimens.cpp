#include "calibrate/target/several_specimens.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "plastica/base/median.hpp"

namespace plastica::calibrate {
namespace {

/// Numbers that are not finite are as the one before.
std::vector<double> sizes_of(std::span<const double> values) {
  std::vector<double> sizes;
  sizes.reserve(values.size());
  double last = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) last = std::abs(value);
    sizes.push_back(last);
  }
  return sizes;
}

double median_step(const std::vector<double>& sizes) {
  std::vector<double> steps;
  steps.reserve(sizes.size());
  for (std::size_t i = 1; i < sizes.size(); ++i) steps.push_back(std::abs(sizes[i] - sizes[i - 1]));
  return median_of(std::move(steps));
}

/// The largest value from each on.
std::vector<double> largest_after(std::vector<double> values) {
  for (std::size_t i = values.size() - 1; i-- > 0;) values[i] = std::max(values[i], values[i + 1]);
  return values;
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
  std::vector<double> way_after, load_after;  // largest from each sample on; made once asked for
  // Where a sensor drops out the curve is back where it was, in as long a step.
  const auto comes_back = [&](std::size_t from) {
    constexpr std::size_t kSoon = 20;
    for (std::size_t k = from + 1; k < std::min(way.size(), from + kSoon); ++k) {
      if (way[k] - way[k - 1] > far) return true;
    }
    return false;
  };
  double reached = 0.0, loaded = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    reached = std::max(reached, way[i - 1]);
    loaded = std::max(loaded, size[i - 1]);
    const bool jumps = way[i - 1] - way[i] > far && way[i] <= 0.05 * reached &&
                       way[i - 1] >= 0.5 * reached && reached > 0.1 * most_way;
    if (!jumps || size[i] > 0.1 * most_load || loaded < 0.3 * most_load) continue;
    if (way_after.empty()) {
      way_after = largest_after(way);
      load_after = largest_after(size);
    }
    const bool goes_on = way_after[i] > 0.1 * reached && load_after[i] > 0.5 * most_load;
    if (goes_on && !comes_back(i)) return i;
  }
  return std::nullopt;
}

}  // namespace plastica::calibrate
