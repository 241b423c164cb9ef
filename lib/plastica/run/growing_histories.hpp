#pragma once

#include <algorithm>
#include <vector>

#include "plastica/model/history.hpp"

namespace plastica {

/// Whether a history goes away from 0 just before a time.
inline bool grows(const History& history, double before) {
  const double slope = history.slope_at(before);
  const double factor = history.at(before);
  return factor == 0.0 ? slope != 0.0 : slope * factor > 0.0;
}

/// Lets histories grow at a time at which none does: in proportion to what they are there, by as
/// much in `reach`. Those that are constant from the beginning stay, unless all are.
/// @param before  the time, or just before
/// @return whether none grew
inline bool let_held_grow(double before, double time, double reach,
                          std::vector<History>& histories) {
  const auto is_constant = [](const History& history) { return history.factor.size() < 2; };
  if (std::any_of(histories.begin(), histories.end(),
                  [&](const History& history) { return grows(history, before); })) {
    return false;
  }
  const bool all_constant = std::all_of(histories.begin(), histories.end(), is_constant);
  for (History& history : histories) {
    if (is_constant(history) && !all_constant) continue;
    const double factor = history.at(time);
    history = {{time, time + reach}, {factor, 2.0 * factor}, true};
  }
  return true;
}

}  // namespace plastica
