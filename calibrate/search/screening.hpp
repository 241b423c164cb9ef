#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace plastica::calibrate {

/// Bounds of coordinates.
struct Box {
  std::vector<double> lower;  ///< (n), finite
  std::vector<double> upper;  ///< (n), finite, not below lower
};

/// Sobol's points within a box. The first of seed 0 is a corner; with another all are scrambled.
/// More coordinates than Sobol's sequence has dimensions stay in the middle of the box.
/// @return (count, n)
std::vector<std::vector<double>> sobol_points(const Box& box, std::size_t count,
                                              std::uint64_t seed);

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

/// The same for points of a box: the starts themselves (at most count, n).
std::vector<std::vector<double>> starts_among(const std::vector<std::vector<double>>& points,
                                              std::span<const double> costs, const Box& box,
                                              std::size_t count);

/// Indices of the least finite costs in rising order, ties in their order; at most `count`.
std::vector<std::size_t> ranked(std::span<const double> costs, std::size_t count);

}  // namespace plastica::calibrate
