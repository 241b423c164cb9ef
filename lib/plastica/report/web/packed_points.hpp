#pragma once

#include <array>
#include <vector>

#include "plastica/report/json_values.hpp"

/// Points of a curve as a page of HTML holds them; not installed.
namespace plastica::report {

/// Points that a screen cannot tell apart are left out, and each column is rounded to one of 65 535
/// steps between its least and its largest number: finer than a screen shows. A gap stays a gap.
/// @param points  rows of one size: (x, y), (x, y, low, high), …; what is not finite is a gap
/// @param logarithmic  whether x, and whether all other columns, are shown by their logarithms:
///                     they are rounded as these, and numbers that have none are gaps
/// @param spots  that are told apart along each axis; 0: every point is kept
/// @return {"n", "low" and "high" of each column, "logarithmic", "columns": base64 of n unsigned
///         numbers of 16 bits, little-endian, for each column; 65535 is a gap}
Json packed_points(const std::vector<std::vector<double>>& points,
                   std::array<bool, 2> logarithmic = {}, int spots = 1500);

}  // namespace plastica::report
