#include "plastica/solve/speed_jump.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::solve {

bool speed_jumps(const History& history, const StepEnd& end, bool midpoint) {
  if (!history.slope.empty() && !midpoint) {
    // A smooth one at its ends alone, where its acceleration jumps if its speed does not: Newmark's
    // and Euler's velocities follow it by themselves, but the midpoint's, if left alone, swing
    // about it.
    const auto is_there = [&](double time, double slope, double curvature) {
      return (slope != 0.0 || curvature != 0.0) &&
             time > end.time - end.length + std::fabs(end.reach) && time <= end.time + end.reach;
    };
    const double first = history.time.front();
    const double last = history.time.back();
    const double before_last = std::nextafter(last, first);
    return is_there(first, history.slope.front(), history.curvature_at(first)) ||
           is_there(last, history.slope.back(), history.curvature_at(before_last));
  }
  const double before = (history.at(end.time) - history.at(end.time - end.length)) / end.length;
  const double after = history.slope_at(end.time + end.reach);
  return std::fabs(after - before) > 1e-9 * std::max(std::fabs(after), std::fabs(before));
}

}  // namespace plastica::solve
