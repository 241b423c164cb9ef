#pragma once

#include <cstdint>
#include <type_traits>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/base/scalar.hpp"

namespace plastica {
PLASTICA_KERNELS_BEGIN

namespace detail {

/// Sine and cosine of r + n pi/2 from those of r, by bits: no branch that an angle could flip.
/// @tparam Bits  unsigned integers as wide as the numbers: one, or a register of them
/// @param shifted  n, added to kRound, so that it stands in the lowest bits
template <class Bits, int kSignBit, class Float>
PLASTICA_ALWAYS_INLINE inline void turn_bits(const Float& shifted, Float& sine, Float& cosine) {
  Bits n, s, c;
  __builtin_memcpy(&n, &shifted, sizeof(Float));
  __builtin_memcpy(&s, &sine, sizeof(Float));
  __builtin_memcpy(&c, &cosine, sizeof(Float));
  const Bits swapped = (s ^ c) & (Bits{} - (n & 1));
  s = s ^ swapped ^ ((n & 2) << (kSignBit - 1));
  c = c ^ swapped ^ (((n + 1) & 2) << (kSignBit - 1));
  __builtin_memcpy(&sine, &s, sizeof(Float));
  __builtin_memcpy(&cosine, &c, sizeof(Float));
}

template <class Real>
using BitsOf = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;

inline void turn_by_quarters(double shifted, double& sine, double& cosine) {
  turn_bits<std::uint64_t, 63>(shifted, sine, cosine);
}
inline void turn_by_quarters(float shifted, float& sine, float& cosine) {
  turn_bits<std::uint32_t, 31>(shifted, sine, cosine);
}
template <class T, int W>
PLASTICA_ALWAYS_INLINE inline void turn_by_quarters(const Pack<T, W>& shifted, Pack<T, W>& sine,
                                                    Pack<T, W>& cosine) {
  using P = Pack<T, W>;
  using Bits [[gnu::vector_size(P::kPartBytes)]] = BitsOf<T>;
  for (std::size_t i = 0; i < P::kParts; ++i) {
    turn_bits<Bits, sizeof(T) * 8 - 1>(shifted.part[i], sine.part[i], cosine.part[i]);
  }
}

/// a b + c; rounded twice on every instruction set if not fused.
template <bool kFused, class S>
PLASTICA_ALWAYS_INLINE inline S times_plus(const S& a, const S& b, const S& c) {
  if constexpr (kFused) {
    return multiply_add(a, b, c);
  } else {
    return a * b + c;
  }
}

/// Sum of (-1)^n x^n first!/(2n + first)!, n = 0 … kTerms - 1.
template <int kTerms, bool kFused, class S>
PLASTICA_ALWAYS_INLINE inline S alternating_series(const S& x, int first) {
  double factor = 1.0;
  for (int n = 1; n < kTerms; ++n) factor /= -(2.0 * n + first) * (2.0 * n + first - 1.0);
  S sum = constant<S>(factor);
#pragma GCC unroll 16
  for (int n = kTerms - 1; n >= 1; --n) {
    factor *= -(2.0 * n + first) * (2.0 * n + first - 1.0);
    sum = times_plus<kFused>(sum, x, constant<S>(factor));
  }
  return sum;
}

}  // namespace detail

/// sin x and cos x at the cost of little more than one, |x| up to 1e5 (float: 1e3); if `kFused`
/// with fused multiply-adds where the instruction set has them, so that its levels differ in the
/// last place; else with the same bits on every machine.
///
/// x = r + n pi/2, |r| <= pi/4 (pi/2 in three parts, Cody and Waite 1980), then Taylor series: the
/// rest is below 5e-17 (float: 4e-8).
template <class S, bool kFused = true>
struct SineCosine {
  S sine, cosine;

  PLASTICA_ALWAYS_INLINE explicit SineCosine(const S& x) {
    constexpr bool kDouble = sizeof(real_t<S>) == 8;
    const S round = S(detail::kRound<real_t<S>>);
    const S shifted = detail::times_plus<kFused>(x, constant<S>(0.63661977236758134308), round);
    const S n = shifted - round;
    S r = detail::times_plus<kFused>(n, constant<S>(kDouble ? -0x1.921fb544p0 : -0x1.92p0), x);
    r = detail::times_plus<kFused>(n, constant<S>(kDouble ? -0x1.0b4611ap-34 : -0x1.fb4p-12), r);
    r = detail::times_plus<kFused>(
        n, constant<S>(kDouble ? -0x1.3198a2e037073p-69 : -0x1.4442d2p-24), r);
    const S square = r * r;
    sine = r * detail::alternating_series < kDouble ? 8 : 5, kFused > (square, 1);
    cosine = detail::alternating_series < kDouble ? 9 : 5, kFused > (square, 0);
    detail::turn_by_quarters(shifted, sine, cosine);
  }
};

PLASTICA_KERNELS_END
}  // namespace plastica
