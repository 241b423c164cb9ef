#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/matrix.hpp"

/// Finite rotations by rotation vectors: theta = angle x unit axis, exp(theta) the rotation.
///
/// With x = |theta|^2, t = |theta|:
///   exp(theta)  = I + a [theta] + b [theta]^2,   a = sin t/t, b = (1 - cos t)/x;
///   exp(theta + d theta) = exp(spin) exp(theta) to first order, d theta = T^-1 spin,
///   T^-1(theta) = I - 1/2 [theta] + c [theta]^2,  c = (1 - (t/2) cot(t/2))/x.
/// Source: Cardona & Geradin, Int. J. Numer. Meth. Eng. 26 (1988) 2403. Below t = 1 the
/// coefficients are power series in x (exact to rounding, and differentiable at 0), above it the
/// formulas. c is the sum of |B_2n| x^(n-1)/(2n)!, B the Bernoulli numbers.
namespace plastica::chain {

namespace detail {
PLASTICA_KERNELS_BEGIN
/// Sum of coefficients[n] x^n.
template <class S, std::size_t N>
inline S polynomial(const std::array<double, N>& coefficients, const S& x) {
  S sum = constant<S>(coefficients[N - 1]);
  for (std::size_t n = N - 1; n-- > 0;) sum = sum * x + constant<S>(coefficients[n]);
  return sum;
}

/// (-1)^n / (2n + first)!
template <std::size_t N>
constexpr std::array<double, N> alternating_factorials(int first) {
  std::array<double, N> coefficients{};
  double factorial = first == 1 ? 1.0 : 2.0;
  double sign = 1.0;
  for (std::size_t n = 0; n < N; ++n) {
    coefficients[n] = sign / factorial;
    const double k = 2.0 * static_cast<double>(n) + first;
    factorial *= (k + 1.0) * (k + 2.0);
    sign = -sign;
  }
  return coefficients;
}

inline constexpr std::array<double, 10> kSinc = alternating_factorials<10>(1);
inline constexpr std::array<double, 10> kVersine = alternating_factorials<10>(2);
/// |B_2n|/(2n)!, n = 1 … 11 = 2 zeta(2n)/(2 pi)^2n.
inline constexpr std::array<double, 11> kCotangent{1.0 / 12.0,
                                                   1.0 / 720.0,
                                                   1.0 / 30240.0,
                                                   1.0 / 1209600.0,
                                                   1.0 / 47900160.0,
                                                   691.0 / 1307674368000.0,
                                                   1.0 / 74724249600.0,
                                                   3617.0 / 10670622842880000.0,
                                                   43867.0 / 5109094217170944000.0,
                                                   174611.0 / 802857662698291200000.0,
                                                   77683.0 / 14101100039391805440000.0};

/// Of the derivative.
inline constexpr std::array<double, 10> kCotangentSlope = [] {
  std::array<double, 10> slope{};
  for (std::size_t n = 0; n < slope.size(); ++n) {
    slope[n] = kCotangent[n + 1] * static_cast<double>(n + 1);
  }
  return slope;
}();
PLASTICA_KERNELS_END
}  // namespace detail

/// The coefficients a, b above at x = |theta|^2.
template <class S>
struct ExponentialCoefficients {
  S a, b;

  explicit ExponentialCoefficients(const S& x) {
    const S one = constant<S>(1);
    const S near = min(x, one);
    a = detail::polynomial(detail::kSinc, near);
    b = detail::polynomial(detail::kVersine, near);
    const auto far = x > one;
    if (!any(far)) return;
    const ExponentialCoefficients beyond = at_angle(sqrt(max(x, one)));
    a = select(far, beyond.a, a);
    b = select(far, beyond.b, b);
  }
  /// By the formulas, for an angle t > 0.
  static ExponentialCoefficients at_angle(const S& t) {
    ExponentialCoefficients k;
    const S half = constant<S>(0.5) * t;
    const S sine = sin(half) / t;
    k.a = sin(t) / t;
    k.b = constant<S>(2) * sine * sine;
    return k;
  }

 private:
  ExponentialCoefficients() = default;
};

/// The coefficient c above at x = |theta|^2, and dc/dx.
template <class S>
struct RotationCoefficients {
  S c, c_slope;

  explicit RotationCoefficients(const S& x) {
    const S one = constant<S>(1);
    const S near = min(x, one);
    c = detail::polynomial(detail::kCotangent, near);
    c_slope = detail::polynomial(detail::kCotangentSlope, near);
    const auto far = x > one;
    if (any(far)) take_far(far, max(x, one));
  }

 private:
  template <class Mask>
  void take_far(const Mask& far, const S& x) {
    const S one = constant<S>(1);
    const S half = constant<S>(0.5);
    const S t = sqrt(x);
    const auto [sinc, versine] = ExponentialCoefficients<S>::at_angle(t);
    const S cotangent = (one - half * sinc / versine) / x;
    const S sinc_slope = half * (cos(t) - sinc) / x;
    const S versine_slope = half * (sinc - versine - versine) / x;
    const S ratio_slope = (sinc_slope * versine - sinc * versine_slope) / (versine * versine);
    c = select(far, cotangent, c);
    c_slope = select(far, (-(half * ratio_slope) - cotangent) / x, c_slope);
  }
};

/// I + p [theta] + q [theta]^2.
template <class S>
inline Mat<S, 3, 3> polynomial_in_skew(const Vec<S, 3>& theta, const S& p, const S& q) {
  const S one = constant<S>(1);
  const Vec<S, 3> axial = p * theta;
  const S xx = theta[0] * theta[0];
  const S yy = theta[1] * theta[1];
  const S zz = theta[2] * theta[2];
  const S xy = q * (theta[0] * theta[1]);
  const S xz = q * (theta[0] * theta[2]);
  const S yz = q * (theta[1] * theta[2]);
  return {{one - q * (yy + zz), xy - axial[2], xz + axial[1],  //
           xy + axial[2], one - q * (xx + zz), yz - axial[0],  //
           xz - axial[1], yz + axial[0], one - q * (xx + yy)}};
}

/// exp(theta).
template <class S>
inline Mat<S, 3, 3> rotation_matrix(const Vec<S, 3>& theta) {
  const ExponentialCoefficients<S> k(dot(theta, theta));
  return polynomial_in_skew(theta, k.a, k.b);
}

/// T^-1(theta): d theta = T^-1 spin.
template <class S>
inline Mat<S, 3, 3> inverse_tangent_map(const Vec<S, 3>& theta, const RotationCoefficients<S>& k) {
  return polynomial_in_skew(theta, constant<S>(-0.5), k.c);
}

/// d(T^-T s)/d theta at constant s. T^-T s = s + 1/2 theta x s + c theta x (theta x s).
template <class S>
inline Mat<S, 3, 3> moment_slope(const Vec<S, 3>& theta, const Vec<S, 3>& s,
                                 const RotationCoefficients<S>& k) {
  const S along = dot(theta, s);
  const Vec<S, 3> twice = along * theta - dot(theta, theta) * s;  // theta x (theta x s)
  Mat<S, 3, 3> slope = k.c * (outer(theta, s) - constant<S>(2) * outer(s, theta)) -
                       constant<S>(0.5) * skew(s) +
                       (constant<S>(2) * k.c_slope) * outer(twice, theta);
  for (std::size_t i = 0; i < 3; ++i) slope(i, i) = slope(i, i) + k.c * along;
  return slope;
}

/// The rotation vector of a rotation matrix, |theta| <= pi; the inverse of `rotation_matrix`.
///
/// By the quaternion with the largest component (Shepperd 1978), its angle by
/// t/2 = atan(|v|/w) = 2 atan(|v|/(w + 1)) = 4 atan(r), so that |r| <= tan(pi/8), as a series.
template <class S>
inline Vec<S, 3> rotation_vector(const Mat<S, 3, 3>& m) {
  const S one = constant<S>(1);
  const S zero = constant<S>(0);
  // Four times the squares of the quaternion (w, x, y, z), and the matching rows of 4 q q^T.
  const std::array<S, 4> square{
      one + m(0, 0) + m(1, 1) + m(2, 2), one + m(0, 0) - m(1, 1) - m(2, 2),
      one - m(0, 0) + m(1, 1) - m(2, 2), one - m(0, 0) - m(1, 1) + m(2, 2)};
  const S wx = m(2, 1) - m(1, 2);
  const S wy = m(0, 2) - m(2, 0);
  const S wz = m(1, 0) - m(0, 1);
  const S xy = m(0, 1) + m(1, 0);
  const S xz = m(0, 2) + m(2, 0);
  const S yz = m(1, 2) + m(2, 1);
  std::array<S, 4> row{square[0], wx, wy, wz};
  S largest = square[0];
  const auto take = [&](std::size_t i, const std::array<S, 4>& other) {
    const auto better = square[i] > largest;
    for (std::size_t k = 0; k < 4; ++k) row[k] = select(better, other[k], row[k]);
    largest = select(better, square[i], largest);
  };
  take(1, {wx, square[1], xy, xz});
  take(2, {wy, xy, square[2], yz});
  take(3, {wz, xz, yz, square[3]});
  const S scale = select(row[0] < zero, -one, one) / (constant<S>(2) * sqrt(largest));
  const S w = row[0] * scale;
  const Vec<S, 3> v{{row[1] * scale, row[2] * scale, row[3] * scale}};
  // sine = |v|; where it is zero its root has no derivative, and the factor tends to 2.
  const S square_of_sine = dot(v, v);
  const auto tiny = square_of_sine < constant<S>(sizeof(real_t<S>) == 8 ? 1e-30 : 1e-14);
  const S sine = sqrt(select(tiny, one, square_of_sine));
  const S quarter = sine / (w + one);                                // tan(t/4)
  const S eighth = quarter / (one + sqrt(one + quarter * quarter));  // tan(t/8) <= 0.415
  const S y = eighth * eighth;
  constexpr int kDegree = 45;
  S sum = constant<S>(1.0 / kDegree);
  for (int n = kDegree - 2; n >= 1; n -= 2) sum = constant<S>(1.0 / n) - y * sum;
  const S angle = constant<S>(8) * eighth * sum;
  return select(tiny, constant<S>(2), angle / sine) * v;
}

}  // namespace plastica::chain
