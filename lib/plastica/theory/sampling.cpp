#include "plastica/theory/sampling.hpp"

#include <array>
#include <bit>
#include <numeric>
#include <string>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/base/domain.hpp"

namespace plastica::theory {
namespace {

constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;

/// The finalizer of splitmix64: Steele, Lea, Flood, Proc. OOPSLA 2014, 453.
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// One number for each axis of each seed.
std::uint64_t key_of(std::uint64_t seed, std::size_t axis) {
  return mixed(mixed(seed + kGolden) + kGolden * (axis + 1));
}

/// The splitmix64 sequence.
class Generator {
 public:
  explicit Generator(std::uint64_t key) : state_(key) {}

  std::uint64_t next() { return mixed(state_ += kGolden); }

  /// Evenly from 0 to bound - 1: draws of as many digits as the bound has, until one is below it.
  std::uint64_t below(std::uint64_t bound) {
    if (bound < 2) return 0;
    const int unused = std::countl_zero(bound - 1);
    std::uint64_t draw = 0;
    do {
      draw = next() >> static_cast<unsigned>(unused);
    } while (draw >= bound);
    return draw;
  }

 private:
  std::uint64_t state_;
};

constexpr unsigned kDigits = 32;

/// A primitive polynomial over the two-element field and the first direction numbers.
struct Direction {
  unsigned degree;                 // s
  unsigned coefficients;           // a: the inner ones, the highest power first
  std::array<std::uint32_t, 7> m;  // m_1 … m_s
};

/// Of the dimensions from the second on; the first has all m = 1.
constexpr std::array<Direction, kSobolDimensions - 1> kDirections{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
}};

/// v_k = m_k/2^k as binary digits behind the point, for k = 1 … kDigits:
/// v_k = a_1 v_(k-1) + … + a_(s-1) v_(k-s+1) + v_(k-s) + v_(k-s)/2^s, sums without carry.
std::array<std::uint32_t, kDigits> direction_digits(std::size_t axis) {
  std::array<std::uint32_t, kDigits> v{};
  if (axis == 0) {
    for (unsigned k = 0; k < kDigits; ++k) v[k] = 1U << (kDigits - 1 - k);
    return v;
  }
  const Direction& from = kDirections[axis - 1];
  const unsigned s = from.degree;
  for (unsigned k = 0; k < s; ++k) v[k] = from.m[k] << (kDigits - 1 - k);
  for (unsigned k = s; k < kDigits; ++k) {
    v[k] = v[k - s] ^ (v[k - s] >> s);
    for (unsigned i = 1; i < s; ++i) {
      if ((from.coefficients >> (s - 1 - i) & 1U) != 0) v[k] ^= v[k - i];
    }
  }
  return v;
}

/// Turns each digit by a draw of the tree's node that the digits before it lead to.
std::uint32_t scrambled(std::uint32_t digits, std::uint64_t key) {
  std::uint32_t flipped = 0;
  for (unsigned level = 0; level < kDigits; ++level) {
    const std::uint64_t before = level == 0 ? 0 : digits >> (kDigits - level);
    const std::uint64_t node = (std::uint64_t{1} << level) | before;
    const std::uint64_t draw = mixed(key + node * kGolden) >> 63U;
    flipped |= static_cast<std::uint32_t>(draw) << (kDigits - 1 - level);
  }
  return digits ^ flipped;
}

}  // namespace

std::vector<double> latin_hypercube(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  require_domain(count <= std::size_t{1} << 31U, "count <= 2^31");
  std::vector<double> points(count * dimensions);
  std::vector<std::size_t> strata(count);
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    Generator random(key_of(seed, axis));
    std::iota(strata.begin(), strata.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(strata[i - 1], strata[random.below(i)]);
    for (std::size_t i = 0; i < count; ++i) {
      // The middle of one of 2^20 cells: stratum and place make an exact sum, and rounding of the
      // quotient cannot reach the next stratum.
      const double place = (static_cast<double>(random.next() >> 44U) + 0.5) * 0x1p-20;
      points[i * dimensions + axis] =
          (static_cast<double>(strata[i]) + place) / static_cast<double>(count);
    }
  }
  return points;
}

std::vector<double> sobol(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  if (dimensions > kSobolDimensions) {
    throw InputError({}, "dimensions", std::to_string(dimensions),
                     "must be at most " + std::to_string(kSobolDimensions) + " for Sobol points");
  }
  require_domain(count <= std::size_t{1} << kDigits, "count <= 2^kDigits");
  std::vector<double> points(count * dimensions);
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    const auto v = direction_digits(axis);
    const std::uint64_t key = key_of(seed, axis);
    std::uint32_t digits = 0;
    for (std::size_t i = 0; i < count; ++i) {
      // From point i - 1 to i the Gray code turns the digit that is the lowest 1 of i.
      if (i > 0) digits ^= v[static_cast<std::size_t>(std::countr_zero(i))];
      const std::uint32_t shown = seed == 0 ? digits : scrambled(digits, key);
      points[i * dimensions + axis] = static_cast<double>(shown) * 0x1p-32;
    }
  }
  return points;
}

}  // namespace plastica::theory
