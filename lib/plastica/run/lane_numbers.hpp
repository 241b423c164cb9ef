#pragma once

#include <bit>
#include <cstdint>

/// How the kernels' numbers follow from a chain's.
namespace plastica {

/// A number to 40 bits, the last half rounded away from zero; infinity stays: even segments differ
/// by the rounding of where their ends are, and would be kinds of their own.
inline double without_noise(double number) {
  constexpr std::uint64_t kDropped = 12;  // of the 52 bits after the leading one
  constexpr std::uint64_t kHalf = std::uint64_t{1} << (kDropped - 1);
  constexpr std::uint64_t kKept = ~((std::uint64_t{1} << kDropped) - 1);
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(number) + kHalf) & kKept);
}

}  // namespace plastica
