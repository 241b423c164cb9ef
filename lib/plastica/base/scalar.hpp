#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "plastica/base/kernel_namespace.hpp"

/// The operations that kernels use on a scalar, for double and float.
///
/// Kernels are templates on the scalar: double, float, `Pack` (a lane is a scenario) and `Dual`
/// (carries derivatives). They never write `if` on a scalar but `select(mask, a, b)`, and call
/// the functions of this header unqualified from namespace plastica, where `pack.hpp` and
/// `dual.hpp` overload them.
namespace plastica {
PLASTICA_KERNELS_BEGIN

/// What a kernel may need to know of a scalar type. `Mask` is what its comparisons give.
template <class S>
struct ScalarTraits;

template <>
struct ScalarTraits<double> {
  using Real = double;
  using Mask = bool;
};

template <>
struct ScalarTraits<float> {
  using Real = float;
  using Mask = bool;
};

/// The floating-point type beneath a scalar: double for double, Pack<double, W>, Dual<double, N>.
template <class S>
using real_t = typename ScalarTraits<S>::Real;

template <class S>
using mask_t = typename ScalarTraits<S>::Mask;

/// Whether a scalar's numbers are double; tolerances depend on it.
template <class S>
inline constexpr bool kIsDouble = sizeof(real_t<S>) == 8;

/// Whether a scalar carries derivatives: a root that its value has reached has them one Newton step
/// later.
template <class S>
inline constexpr bool kCarriesDerivatives = false;

/// Whether a scalar is many numbers, each with a course of its own.
template <class S>
inline constexpr bool kHasLanes = false;

/// A scalar without its derivatives.
template <class S>
inline auto value_of(const S& x) {
  if constexpr (kCarriesDerivatives<S>) {
    return x.value();
  } else {
    return x;
  }
}

/// A constant as a scalar; the only way in which kernels write literals.
template <class S>
constexpr S constant(double value) {
  return S(static_cast<real_t<S>>(value));
}

/// A mask that holds in all lanes, or in none.
template <class S>
constexpr mask_t<S> in_all_lanes(bool holds) {
  return constant<S>(holds ? 1.0 : 0.0) > constant<S>(0.0);
}

/// `a` where the mask holds, `b` elsewhere.
constexpr double select(bool mask, double a, double b) { return mask ? a : b; }
constexpr float select(bool mask, float a, float b) { return mask ? a : b; }

/// Whether a mask holds in any lane; for loops that run until all lanes are done.
constexpr bool any(bool mask) { return mask; }

inline double abs(double x) { return std::fabs(x); }
inline float abs(float x) { return std::fabs(x); }
inline double sqrt(double x) { return std::sqrt(x); }
inline float sqrt(float x) { return std::sqrt(x); }

/// a b + c; rounded once where the instruction set of the file has it, else twice.
inline double multiply_add(double a, double b, double c) {
#if defined(__FMA__)
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}
inline float multiply_add(float a, float b, float c) {
#if defined(__FMA__)
  return __builtin_fmaf(a, b, c);
#else
  return a * b + c;
#endif
}

/// The larger of two; of equal ones the first. A NaN in `b` is dropped, one in `a` stays.
template <class S>
inline S max(const S& a, const S& b) {
  return select(b > a, b, a);
}

/// The smaller of two; of equal ones the first.
template <class S>
inline S min(const S& a, const S& b) {
  return select(b < a, b, a);
}

/// -1 for negative numbers, 1 for all others.
template <class S>
inline S sign(const S& x) {
  return select(x < constant<S>(0), constant<S>(-1), constant<S>(1));
}

/// 2^k for the integer k that was added to detail::kRound<Real>; by bits, so exact. For `exp`.
inline double power_of_two(double k_plus_round) {
  const auto bits = std::bit_cast<std::uint64_t>(k_plus_round);
  return std::bit_cast<double>((bits + 1023U) << 52U);
}
inline float power_of_two(float k_plus_round) {
  const auto bits = std::bit_cast<std::uint32_t>(k_plus_round);
  return std::bit_cast<float>((bits + 127U) << 23U);
}

namespace detail {

/// Adding and subtracting it rounds to an integer, which is then left in the lowest bits:
/// 1.5 * 2^52 (2^23 for float).
template <class Real>
constexpr Real kRound = static_cast<Real>(sizeof(Real) == 8 ? 6755399441055744.0 : 12582912.0);

/// sum c_i r^i, in pairs, pairs of pairs and so on (Estrin 1960): a step waits for log2(N) others
/// where Horner's scheme waits for N.
template <class S, std::size_t N>
inline S polynomial(const std::array<S, N>& c, const S& r) {
  if constexpr (N == 1) {
    return c[0];
  } else {
    std::array<S, (N + 1) / 2> pairs;
    for (std::size_t i = 0; i < N / 2; ++i) pairs[i] = c[2 * i] + c[2 * i + 1] * r;
    if constexpr (N % 2 == 1) pairs[N / 2] = c[N - 1];
    return polynomial(pairs, S(r * r));
  }
}

}  // namespace detail

/// e^x; the same bits on every machine (the C library chooses its code by the CPU).
///
/// x = k ln 2 + r with |r| <= ln 2 / 2 (ln 2 in two parts, Cody and Waite 1980), then the Taylor
/// series of e^r up to r^13 (r^7 for float; the rest is below 5e-18, 6e-9), as 1 + (r + r^2 q(r)).
/// Largest error measured: 1 unit in the last place. Below -708 (float: -87) the result is 0, above
/// 709 (88) infinite.
template <class S>
inline S exp(const S& x) {
  using Real = real_t<S>;
  constexpr bool kDouble = sizeof(Real) == 8;
  const S lowest = constant<S>(kDouble ? -708.0 : -87.0);
  const S highest = constant<S>(kDouble ? 709.0 : 88.0);
  const S inside = min(max(x, lowest), highest);
  const S shifted = inside * constant<S>(1.4426950408889634074) + S(detail::kRound<Real>);
  const S k = shifted - S(detail::kRound<Real>);
  const S r = (inside - k * constant<S>(kDouble ? 0x1.62e42feep-1 : 0x1.63p-1)) -
              k * constant<S>(kDouble ? 0x1.a39ef35793c76p-33 : -0x1.bd0106p-13);
  constexpr int kDegree = kDouble ? 13 : 7;
  std::array<S, kDegree - 1> of_square;
  double factorial = 1.0;
  for (int n = 2; n <= kDegree; ++n) {
    factorial *= n;
    of_square[static_cast<std::size_t>(n - 2)] = constant<S>(1.0 / factorial);
  }
  const S sum = constant<S>(1) + (r + r * r * detail::polynomial(of_square, r));
  const S value = sum * power_of_two(shifted);
  const S zero = constant<S>(0);
  const S infinite = S(std::numeric_limits<Real>::infinity());
  return select(x > highest, infinite, select(x < lowest, zero, value));
}

namespace detail {

/// Taylor polynomial of sin (odd = true) or cos at r, |r| <= pi/4; the rest is below 1e-19 for
/// double, 3e-9 for float.
template <class S>
inline S sine_series(const S& r, bool odd) {
  constexpr bool kDouble = sizeof(real_t<S>) == 8;
  const int lowest = odd ? 1 : 0;
  const int degree = (kDouble ? 16 : 8) + lowest;
  double factorial = 1.0;
  for (int n = 2; n <= degree; ++n) factorial *= n;
  const S square = r * r;
  double sign_of_term = (degree - lowest) % 4 == 0 ? 1.0 : -1.0;
  S sum = constant<S>(sign_of_term / factorial);
  for (int n = degree; n > lowest; n -= 2) {
    factorial /= static_cast<double>(n) * (n - 1);
    sign_of_term = -sign_of_term;
    sum = sum * square + constant<S>(sign_of_term / factorial);
  }
  return odd ? sum * r : sum;
}

/// sin(x + quarter_turns pi/2).
template <class S>
inline S sine_shifted(const S& x, double quarter_turns) {
  using Real = real_t<S>;
  constexpr bool kDouble = sizeof(Real) == 8;
  const S round = S(kRound<Real>);
  const S k = (x * constant<S>(0.63661977236758134308) + round) - round;
  // pi/2 in three parts, so that k times the first two is exact (Cody and Waite 1980).
  const S r = ((x - k * constant<S>(kDouble ? 0x1.921fb544p0 : 0x1.92p0)) -
               k * constant<S>(kDouble ? 0x1.0b4611ap-34 : 0x1.fb4p-12)) -
              k * constant<S>(kDouble ? 0x1.3198a2e037073p-69 : 0x1.4442d2p-24);
  const S turns = k + constant<S>(quarter_turns);
  // Quadrant in -2 … 2.
  const S quadrant = turns - constant<S>(4) * ((turns * constant<S>(0.25) + round) - round);
  const auto odd = abs(abs(quadrant) - constant<S>(1)) < constant<S>(0.5);
  const S value = select(odd, sine_series(r, false), sine_series(r, true));
  const auto negative = (quadrant < constant<S>(-0.5)) | (abs(quadrant) > constant<S>(1.5));
  return select(negative, -value, value);
}

}  // namespace detail

/// sin x, |x| up to 1e5 (float: 1e3); the same bits on every machine.
template <class S>
inline S sin(const S& x) {
  return detail::sine_shifted(x, 0.0);
}

/// cos x, |x| up to 1e5 (float: 1e3); the same bits on every machine.
template <class S>
inline S cos(const S& x) {
  return detail::sine_shifted(x, 1.0);
}

/// Natural logarithm of a number above 0; the same bits on every machine.
///
/// x = m 2^k with m in [sqrt(1/2), sqrt(2)); ln m = 2 atanh s, s = (m-1)/(m+1), |s| < 0.172, as a
/// series up to s^21 (the rest is below 1e-18).
inline double log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.70710678118654752440) {
    m *= 2.0;
    --exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double square = s * s;
  double sum = 1.0 / 21.0;
  for (int n = 19; n >= 1; n -= 2) sum = sum * square + 1.0 / n;
  const double k = exponent;
  return k * 0x1.62e42feep-1 + (2.0 * s * sum + k * 0x1.a39ef35793c76p-33);
}
inline float log(float x) { return static_cast<float>(log(static_cast<double>(x))); }

PLASTICA_KERNELS_END
}  // namespace plastica
