#include "calibrate/search/screening.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plastica/theory/sampling.hpp"

namespace plastica::calibrate {
namespace {

double critical_distance(std::size_t points, std::size_t n) {
  const auto count = static_cast<double>(points);
  const auto dimensions = static_cast<double>(n);
  const double ball = std::tgamma(1.0 + 0.5 * dimensions) * 2.0 * std::log(count) / count;
  return std::pow(ball, 1.0 / dimensions) * std::numbers::inv_sqrtpi;
}

}  // namespace

std::vector<std::vector<double>> sobol_points(const Box& box, std::size_t count,
                                              std::uint64_t seed) {
  const std::size_t n = box.lower.size();
  const std::size_t moved = std::min(n, theory::kSobolDimensions);
  const std::vector<double> fractions = theory::sobol(count, moved, seed);
  std::vector<std::vector<double>> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const double fraction = i < moved ? fractions[k * moved + i] : 0.5;
      points[k].push_back(box.lower[i] + fraction * (box.upper[i] - box.lower[i]));
    }
  }
  return points;
}

std::vector<std::size_t> choose_starts(std::span<const double> points,
                                       std::span<const double> costs, std::size_t count) {
  const std::vector<std::size_t> order = ranked(costs, costs.size());
  if (order.empty()) return {};
  const std::size_t n = points.size() / costs.size();
  const double near = critical_distance(costs.size(), n);
  const auto close = [&](std::size_t a, std::size_t b) {
    double squares = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      const double difference = points[a * n + k] - points[b * n + k];
      squares += difference * difference;
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

std::vector<std::vector<double>> starts_among(const std::vector<std::vector<double>>& points,
                                              std::span<const double> costs, const Box& box,
                                              std::size_t count) {
  std::vector<double> fractions;
  for (const std::vector<double>& x : points) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double width = box.upper[i] - box.lower[i];
      fractions.push_back(width > 0.0 ? (x[i] - box.lower[i]) / width : 0.0);
    }
  }
  std::vector<std::vector<double>> starts;
  for (const std::size_t k : choose_starts(fractions, costs, count)) starts.push_back(points[k]);
  return starts;
}

std::vector<std::size_t> ranked(std::span<const double> costs, std::size_t count) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (std::isfinite(costs[i])) order.push_back(i);
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return costs[i]; });
  order.resize(std::min(order.size(), count));
  return order;
}

}  // namespace plastica::calibrate
