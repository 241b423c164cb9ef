#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace plastica::sweeps {

// What accuracy costs: the settings of a sweep that no other beats, and the one to take. All
// choices are deterministic: of equal settings the one with the lower index.

/// A setting of a sweep.
struct TradePoint {
  double cost = 0.0;   ///< of any kind and unit, as seconds; not finite: the case failed
  double error = 0.0;  ///< >= 0, of any kind and unit; not finite: the case failed
  /// Points of a group differ in the sizes alone. Empty: alone.
  std::optional<std::size_t> group{};
  /// h of each axis that is refined, as many for all points of a group; the smaller, the finer.
  std::vector<double> sizes{};
};

/// The Pareto front: the indices of the points which no other one matches in both cost and error
/// and beats in one; by rising cost, hence by falling error. A point that failed is never on it; of
/// several equal ones only the first is.
std::vector<std::size_t> pareto_front(std::span<const TradePoint> points);

/// The largest error of each point and of all of its group that are finer: in one size at least,
/// and coarser in none (n); infinite if it failed.
///
/// Errors do not always fall with refinement: one that changes its sign is small, for once, at a
/// coarse size. That is luck, and another load or material will not have it. Failed finer points do
/// not count.
std::vector<double> assured_errors(std::span<const TradePoint> points);

/// Why there is no choice.
enum class NoChoice {
  None,           ///< there is one
  NoPoints,       ///< nothing to choose from
  AllFailed,      ///< no point has both cost and error
  TooInaccurate,  ///< every error is above the wanted one
  TooCostly,      ///< every cost is above the budget
};

struct Recommendation {
  std::optional<std::size_t> chosen;
  NoChoice why_none = NoChoice::NoPoints;
  /// Without a choice: the most accurate point for a wanted error, the cheapest one for a budget.
  std::optional<std::size_t> nearest;
  /// Wanted error over error, or budget over cost [1], >= 1; below 1 it is the nearest point's.
  double margin = std::numeric_limits<double>::quiet_NaN();
  /// Of the chosen point, for a wanted error without a choice of the nearest, in the error's unit.
  double assured_error = std::numeric_limits<double>::quiet_NaN();
  /// A finer point of its group misses the wanted error, or, for a budget or of the nearest point,
  /// is less accurate than it.
  bool lucky = false;
  /// For a wanted error: the cheapest point that meets it by luck and was passed over for that.
  std::optional<std::size_t> passed_over;
  /// What the next step would be: for a wanted error the most accurate of the cheaper points that
  /// miss it, for a budget the cheapest of the more accurate points that exceed it.
  std::optional<std::size_t> next;
};

/// The cheapest point whose assured error is at most the wanted one; if there is none, the cheapest
/// whose own error is, which is lucky.
/// @param wanted_error  >= 0, in the errors' unit
Recommendation recommend_for_error(std::span<const TradePoint> points, double wanted_error);

/// The point of the least assured error that costs at most the budget; of several such the one of
/// the least error, then of the least cost.
/// @param budget  in the costs' unit
Recommendation recommend_for_budget(std::span<const TradePoint> points, double budget);

}  // namespace plastica::sweeps
