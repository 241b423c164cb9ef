#pragma once

#include <optional>
#include <string>

#include "sweeps/trade/setting.hpp"

namespace plastica::sweeps {

/// What was asked for: one of both.
struct Wish {
  std::optional<double> within{};  ///< the error [1]
  std::optional<double> budget{};  ///< the cost, in the unit of its kind
};

/// A choice in words: the setting with its error, margin and cost; the next cheaper that does not
/// meet the wish, or the next more accurate that is beyond the budget; and what else to know.
std::string recommendation_text(const SweepRecord& record, CostKind cost, const Wish& wish,
                                const Recommendation& choice);

}  // namespace plastica::sweeps
