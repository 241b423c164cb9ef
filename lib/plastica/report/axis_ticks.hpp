#pragma once

#include <array>
#include <string>
#include <vector>

/// Numbers along an axis that is narrow, or whose numbers are long; not installed.
namespace plastica::report {

struct AxisTick {
  double at = 0.0;
  std::string text;
};

/// Multiples of 1, 2 or 5 times a power of ten within a range, as many as have room side by side
/// and two at least, with as many digits as tell them apart. The last is left out where its text
/// would leave the page, unless it is one of two.
/// @param range  low < high @param panel  width of the panel [units of a page]
std::vector<AxisTick> ticks_with_room(const std::array<double, 2>& range, double panel);

}  // namespace plastica::report
