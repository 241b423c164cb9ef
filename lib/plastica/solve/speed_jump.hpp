#pragma once

#include "plastica/model/history.hpp"

namespace plastica::solve {

/// Where a step ends.
struct StepEnd {
  double time = 0.0;    ///< [s]
  double length = 0.0;  ///< of the step [s]
  /// How far behind the end is after it, but for rounding [s]; negative: nothing follows.
  double reach = 0.0;
};

/// Whether the speed of what a history moves jumps at the end of a step, as its scheme sees it; of
/// a smooth history where it begins or ends, whether the speed or the acceleration does.
/// @param midpoint  whether forces act half way
bool speed_jumps(const History& history, const StepEnd& end, bool midpoint);

}  // namespace plastica::solve
