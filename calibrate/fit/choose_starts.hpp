#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace plastica::calibrate {

/// The best of the points that a global stage has looked at, each in a basin of its own as far as
/// the points show: one with a better one nearby is passed over, until none else is left.
///
/// Nearby is the critical distance of multi-level single linkage in the unit cube, within which so
/// many even points would have a better one in the same basin:
/// r = (Gamma(1 + n/2) 2 ln(N)/N)^(1/n)/sqrt(pi).
/// Source: Rinnooy Kan & Timmer, Mathematical Programming 39 (1987) 57, sigma = 2.
/// @param points  in the unit cube (n_points x n), row by row
/// @param costs  of these; not finite where there is nothing (n_points)
/// @param count  how many at most
/// @return indices in rising order of their costs, ties in that of the points; fewer than `count`
///         if fewer have a cost
std::vector<std::size_t> choose_starts(std::span<const double> points,
                                       std::span<const double> costs, std::size_t count);

}  // namespace plastica::calibrate
