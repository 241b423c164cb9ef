#include "plastica/solve/speed_jump.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::solve {

namespace {

/// Whether a smooth history begins or ends in a step, and not at rest.
bool begins_or_ends(const History& history, const StepEnd& end) {
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

}  // namespace

SupportSpeed speed_of_support(const History& history, const StepEnd& end, bool midpoint) {
  const bool is_smooth = !history.slope.empty();
  if (is_smooth && begins_or_ends(history, end)) return SupportSpeed::Jumps;
  // Newmark's and Euler's velocities follow a smooth one by themselves, but the midpoint's, if left
  // alone, swing about it.
  if (is_smooth && !midpoint) return SupportSpeed::Kept;
  const double before = (history.at(end.time) - history.at(end.time - end.length)) / end.length;
  const double after = history.slope_at(end.time + end.reach);
  if (std::fabs(after - before) <= 1e-9 * std::max(std::fabs(after), std::fabs(before))) {
    return SupportSpeed::Kept;
  }
  return is_smooth ? SupportSpeed::Turns : SupportSpeed::Jumps;
}

}  // namespace plastica::solve
