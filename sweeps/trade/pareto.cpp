#include "sweeps/trade/pareto.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>

namespace plastica::sweeps {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool ran(const TradePoint& point) {
  return std::isfinite(point.cost) && std::isfinite(point.error);
}

/// The point that comes first by a rank, of those that qualify; equal ranks keep the first.
template <typename Qualifies, typename Rank>
std::optional<std::size_t> first_by(std::span<const TradePoint> points, const Qualifies& qualifies,
                                    const Rank& rank) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!ran(points[i]) || !qualifies(i)) continue;
    if (!best || rank(i) < rank(*best)) best = i;
  }
  return best;
}

/// Whether a point is finer than another in one size at least, and coarser in none.
bool is_finer(const TradePoint& point, const TradePoint& other) {
  bool finer = false;
  for (std::size_t k = 0; k < point.sizes.size(); ++k) {
    if (point.sizes[k] > other.sizes[k]) return false;
    finer = finer || point.sizes[k] < other.sizes[k];
  }
  return finer;
}

NoChoice why_none(std::span<const TradePoint> points, NoChoice reason) {
  if (points.empty()) return NoChoice::NoPoints;
  return std::none_of(points.begin(), points.end(), ran) ? NoChoice::AllFailed : reason;
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const TradePoint> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ran(points[i])) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(points[a].cost, points[a].error, a) <
           std::tuple(points[b].cost, points[b].error, b);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || points[i].error < points[front.back()].error) front.push_back(i);
  }
  return front;
}

std::vector<double> assured_errors(std::span<const TradePoint> points) {
  std::vector<double> assured(points.size(), kInfinity);
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!ran(points[i])) continue;
    assured[i] = points[i].error;
    if (points[i].group) groups[*points[i].group].push_back(i);
  }
  for (const auto& [group, members] : groups) {
    for (const std::size_t i : members) {
      for (const std::size_t j : members) {
        if (is_finer(points[j], points[i])) assured[i] = std::max(assured[i], points[j].error);
      }
    }
  }
  return assured;
}

Recommendation recommend_for_error(std::span<const TradePoint> points, double wanted_error) {
  assert(wanted_error >= 0.0);
  const std::vector<double> assured = assured_errors(points);
  const auto accuracy = [&](std::size_t i) { return std::tuple(points[i].error, points[i].cost); };
  const auto cheapness = [&](std::size_t i) { return std::tuple(points[i].cost, points[i].error); };
  const auto meets = [&](std::size_t i) { return points[i].error <= wanted_error; };

  Recommendation result;
  const auto dependable = first_by(
      points, [&](std::size_t i) { return assured[i] <= wanted_error; }, cheapness);
  const auto cheapest = first_by(points, meets, cheapness);
  result.chosen = dependable ? dependable : cheapest;
  if (!result.chosen) {
    result.why_none = why_none(points, NoChoice::TooInaccurate);
    result.nearest = first_by(
        points, [](std::size_t) { return true; }, accuracy);
    if (result.nearest) {
      const std::size_t nearest = *result.nearest;
      result.margin = wanted_error / points[nearest].error;
      result.assured_error = assured[nearest];
      result.lucky = assured[nearest] > points[nearest].error;
    }
    return result;
  }
  const std::size_t chosen = *result.chosen;
  result.why_none = NoChoice::None;
  result.lucky = !dependable;
  if (cheapest != result.chosen) result.passed_over = cheapest;
  result.margin = points[chosen].error > 0.0 ? wanted_error / points[chosen].error : kInfinity;
  result.assured_error = assured[chosen];
  result.next = first_by(
      points, [&](std::size_t i) { return !meets(i) && points[i].cost < points[chosen].cost; },
      accuracy);
  return result;
}

Recommendation recommend_for_budget(std::span<const TradePoint> points, double budget) {
  assert(!std::isnan(budget));
  const std::vector<double> assured = assured_errors(points);
  const auto accuracy = [&](std::size_t i) {
    return std::tuple(assured[i], points[i].error, points[i].cost);
  };
  const auto cheapness = [&](std::size_t i) { return std::tuple(points[i].cost, points[i].error); };
  const auto affordable = [&](std::size_t i) { return points[i].cost <= budget; };

  Recommendation result;
  result.chosen = first_by(points, affordable, accuracy);
  if (!result.chosen) {
    result.why_none = why_none(points, NoChoice::TooCostly);
    result.nearest = first_by(
        points, [](std::size_t) { return true; }, cheapness);
    if (result.nearest) result.margin = budget / points[*result.nearest].cost;
    return result;
  }
  const std::size_t chosen = *result.chosen;
  result.why_none = NoChoice::None;
  result.margin = points[chosen].cost > 0.0 ? budget / points[chosen].cost : kInfinity;
  result.assured_error = assured[chosen];
  result.lucky = assured[chosen] > points[chosen].error;
  result.next = first_by(
      points, [&](std::size_t i) { return !affordable(i) && assured[i] < assured[chosen]; },
      cheapness);
  return result;
}

}  // namespace plastica::sweeps
