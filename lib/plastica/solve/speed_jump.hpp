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

/// What becomes of the speed of what a history moves.
enum class SupportSpeed {
  Kept,   ///< the scheme's velocities follow it by themselves
  Turns,  ///< it goes on smoothly, but they do not: they are to be fitted to it
  Jumps,  ///< it jumps; of a smooth history where it begins or ends, or the acceleration does
};

/// What it does at the end of a step, as the step's scheme sees it.
/// @param midpoint  whether forces act half way
SupportSpeed speed_of_support(const History& history, const StepEnd& end, bool midpoint);

}  // namespace plastica::solve
