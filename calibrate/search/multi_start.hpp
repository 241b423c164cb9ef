#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "calibrate/search/descend.hpp"

namespace plastica::calibrate {

/// How many of several searches go to their ends.
struct MultiStartOptions {
  int short_evaluations = 10;  ///< of each search before the best are chosen, >= 1
  std::size_t polished = 2;    ///< how many go on
  /// Past kinks go those alone that come down to so many times the least cost that is known.
  double near = 1.5;
  double known = std::numeric_limits<double>::infinity();  ///< such a cost, of elsewhere
};

/// Short searches by "gauss-newton" from several points, of which the best `descend` to their ends.
/// @param problem  with cost and squares; its start does not count
/// @param starts  within its box (n_starts, n)
/// @param how  of the descents
/// @return the least end; without a point if no start has a cost
/// @throws whatever the problem's functions threw
Minimum search_from(const Problem& problem, const std::vector<std::vector<double>>& starts,
                    const MultiStartOptions& options, const MinimizeOptions& how,
                    const StageListener& tell);

}  // namespace plastica::calibrate
