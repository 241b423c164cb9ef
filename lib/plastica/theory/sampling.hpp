#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plastica::theory {

// Points that fill the unit cube more evenly than random ones, for sweeps over many axes and starts
// of fits. The generator is ours, so that a seed gives the same bits on every machine.

/// So many dimensions have direction numbers here.
inline constexpr std::size_t kSobolDimensions = 31;

/// A Latin hypercube: each of the `count` equal strata of each axis holds exactly one point, at a
/// random place within. The coordinates of an axis depend on the seed and on its index alone.
/// Source: McKay, Beckman, Conover, Technometrics 21 (1979) 239.
/// @param count       number of points, up to 2^31
/// @param dimensions  number of axes
/// @param seed        any number
/// @return coordinates in [0, 1), point by point (count x dimensions)
std::vector<double> latin_hypercube(std::size_t count, std::size_t dimensions, std::uint64_t seed);

/// Sobol's sequence from its first point on, in the order of the Gray code, with 32 binary digits.
/// It is most even where the count is a power of 2.
/// Source: Bratley & Fox, ACM Trans. Math. Softw. 14 (1988) 88; direction numbers: Joe & Kuo,
/// SIAM J. Sci. Comput. 30 (2008) 2635, their table new-joe-kuo-6; scrambling: Owen, Monte Carlo
/// and Quasi-Monte Carlo Methods in Scientific Computing, 1995, 299.
/// @param count       number of points, up to 2^32
/// @param dimensions  number of axes, up to kSobolDimensions
/// @param seed        0: the sequence itself, which begins with the origin; else each binary digit
///                    is turned or not by a draw that the digits before it choose, which keeps the
///                    evenness
/// @return coordinates in [0, 1), point by point (count x dimensions)
/// @throws InputError if there are more dimensions than direction numbers
std::vector<double> sobol(std::size_t count, std::size_t dimensions, std::uint64_t seed);

}  // namespace plastica::theory
