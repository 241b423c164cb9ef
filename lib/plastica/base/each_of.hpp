#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/kernel_namespace.hpp"

/// Loops that are written out. An array that a loop indexes stays in memory, and small matrices or
/// dual numbers that do cost two to three times as much.
namespace plastica {
PLASTICA_KERNELS_BEGIN

/// f(0) … f(N-1).
template <std::size_t N, class F>
PLASTICA_ALWAYS_INLINE constexpr void for_each_of(const F& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) PLASTICA_ALWAYS_INLINE { (f(I), ...); }
  (std::make_index_sequence<N>{});
}

/// The array of f(0) … f(N-1).
template <std::size_t N, class F>
PLASTICA_ALWAYS_INLINE constexpr auto each_of(const F& f) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) PLASTICA_ALWAYS_INLINE {
    return std::array<decltype(f(0)), N>{f(I)...};
  }
  (std::make_index_sequence<N>{});
}

/// f(0) + f(1) + … + f(N-1), added from the left; 0 if there is none.
template <class S, std::size_t N, class F>
PLASTICA_ALWAYS_INLINE constexpr S sum_of(const F& f) {
  if constexpr (N == 0) {
    return S{};
  } else {
    S sum = f(0);
    for_each_of<N - 1>([&](std::size_t i) PLASTICA_ALWAYS_INLINE { sum = sum + f(i + 1); });
    return sum;
  }
}

PLASTICA_KERNELS_END
}  // namespace plastica
