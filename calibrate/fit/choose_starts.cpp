#include "calibrate/fit/choose_starts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plastica::calibrate {
namespace {

double critical_distance(std::size_t points, std::size_t n) {
  const auto count = static_cast<double>(points);
  const auto dimensions = static_cast<double>(n);
  const double ball = std::tgamma(1.0 + 0.5 * dimensions) * 2.0 * std::log(count) / count;
  return std::pow(ball, 1.0 / dimensions) * std::numbers::inv_sqrtpi;
}

}  // namespace

std::vector<std::size_t> choose_starts(std::span<const double> points,
                                       std::span<const double> costs, std::size_t count) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (std::isfinite(costs[i])) order.push_back(i);
  }
  if (order.empty()) return order;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return costs[i]; });
  const std::size_t n = points.size() / costs.size();
  const double near = critical_distance(costs.size(), n);
  const auto close = [&](std::size_t a, std::size_t b) {
    double squares = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      const double way = points[a * n + k] - points[b * n + k];
      squares += way * way;
    }
    return squares <= near * near;
  };
  std::vector<std::size_t> chosen, passed;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto better = order.begin() + static_cast<std::ptrdiff_t>(i);
    const bool alone =
        std::none_of(order.begin(), better, [&](std::size_t j) { return close(order[i], j); });
    (alone ? chosen : passed).push_back(order[i]);
  }
  chosen.insert(chosen.end(), passed.begin(), passed.end());
  chosen.resize(std::min(chosen.size(), count));
  std::ranges::stable_sort(chosen, {}, [&](std::size_t i) { return costs[i]; });
  return chosen;
}

}  // namespace plastica::calibrate
