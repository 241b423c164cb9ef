#pragma once

#include <array>
#include <vector>

#include "plastica/report/json_values.hpp"

/// Points of a curve as a page of HTML holds them; not installed.
namespace plastica::report {

/// How points are thinned: those of a line that stay within half a spot of the line through the
/// others are left out (Ramer 1972, Douglas and Peucker 1973), of all others those that fall on the
/// spot of the one before.
enum class Thinning { Line, Points };

/// What a screen does not show is left out, and each column is rounded to one of 65 535
/// steps between its least and its largest number: finer than a screen shows. A gap stays a gap.
/// @param points  rows of one size: (x, y), (x, y, low, high), …; what is not finite is a gap
/// @param logarithmic  whether x, and whether all other columns, are shown by their logarithms:
///                     they are rounded as these, and numbers that have none are gaps
/// @param spots  that are told apart along each axis; 0: every point is kept
/// @return {"n", "low" and "high" of each column, "logarithmic" where either is, "columns": base64
/// of
///         n unsigned numbers of 16 bits, little-endian, for each column; 65535 is a gap}
Json packed_points(const std::vector<std::vector<double>>& points,
                   std::array<bool, 2> logarithmic = {}, int spots = 1500,
                   Thinning thinning = Thinning::Points);

}  // namespace plastica::report
