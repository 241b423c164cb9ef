#pragma once

#include "plastica/base/always_inline.hpp"
#include "plastica/base/sine_cosine.hpp"
#include "plastica/lanes/triple.hpp"

/// Finite rotations of the spatial kernels: joints by rotation vectors, segments by unit
/// quaternions. With theta = t n, x = t^2, u = t/2:
///   exp(theta) = the quaternion (cos u, (sin u/t) theta);
///   d theta = T^-1 spin, T^-1 v = v - 1/2 theta x v + c theta x (theta x v), c = (1 - u cot u)/x,
/// for a spin in the axes from which theta turns; T^-T for one in those to which it turns (Cardona
/// & Geradin 1988; chain/rotation.hpp).
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

namespace detail {

/// Sum of (-x/4)^n/(2n + first)!: sin u/u for first = 1, cos u for 0; |u| <= 1/2.
template <class S>
PLASTICA_ALWAYS_INLINE inline S half_turn_series(const S& x, int first) {
  constexpr bool kDouble = sizeof(real_t<S>) == 8;
  const int terms = kDouble ? (first == 1 ? 7 : 8) : (first == 1 ? 4 : 5);
  double factor = 1.0;
  for (int n = 1; n < terms; ++n) factor *= -0.25 / ((2.0 * n + first) * (2.0 * n + first - 1.0));
  S sum = constant<S>(factor);
#pragma GCC unroll 16
  for (int n = terms - 1; n >= 1; --n) {
    factor *= -4.0 * (2.0 * n + first) * (2.0 * n + first - 1.0);
    sum = multiply_add(sum, x, constant<S>(factor));
  }
  return sum;
}

/// c: the sum of |B_2n| x^(n-1)/(2n)!, B the Bernoulli numbers; x <= 1.
template <class S>
PLASTICA_ALWAYS_INLINE inline S cotangent_series(const S& x) {
  S sum = constant<S>(1.0 / 1209600.0);
  if constexpr (sizeof(real_t<S>) == 8) {
    sum = constant<S>(174611.0 / 802857662698291200000.0);
    sum = multiply_add(sum, x, constant<S>(43867.0 / 5109094217170944000.0));
    sum = multiply_add(sum, x, constant<S>(3617.0 / 10670622842880000.0));
    sum = multiply_add(sum, x, constant<S>(1.0 / 74724249600.0));
    sum = multiply_add(sum, x, constant<S>(691.0 / 1307674368000.0));
    sum = multiply_add(sum, x, constant<S>(1.0 / 47900160.0));
    sum = multiply_add(sum, x, constant<S>(1.0 / 1209600.0));
  } else {
    sum = multiply_add(constant<S>(1.0 / 47900160.0), x, sum);
  }
  sum = multiply_add(sum, x, constant<S>(1.0 / 30240.0));
  sum = multiply_add(sum, x, constant<S>(1.0 / 720.0));
  return multiply_add(sum, x, constant<S>(1.0 / 12.0));
}

}  // namespace detail

/// The coefficients of a joint's turn.
template <class S>
struct TurnCoefficients {
  S c, cosine, sinc;  ///< cos u, sin u/u
};

template <class S>
PLASTICA_ALWAYS_INLINE inline TurnCoefficients<S> near_coefficients(const S& x) {
  return {detail::cotangent_series(x), detail::half_turn_series(x, 0),
          detail::half_turn_series(x, 1)};
}

/// The series up to x = 1, with the same bits as above, and the formulas beyond. Rare, so it is
/// called.
template <class S>
[[gnu::noinline]] TurnCoefficients<S> far_coefficients(const S& x) {
  const S one = constant<S>(1);
  const TurnCoefficients<S> near = near_coefficients(min(x, one));
  const S u = constant<S>(0.5) * sqrt(max(x, one));
  const SineCosine<S> at(u);
  const auto far = x > one;
  const S c = (one - u * at.cosine / at.sine) / (constant<S>(4) * u * u);
  return {select(far, c, near.c), select(far, at.cosine, near.cosine),
          select(far, at.sine / u, near.sinc)};
}

/// A joint's angle where the forces of a step act.
template <class S>
struct JointTurn {
  Triple<S> theta;
  TurnCoefficients<S> by;
};

template <class S>
PLASTICA_ALWAYS_INLINE inline JointTurn<S> joint_turn(const Triple<S>& theta) {
  const S x = dot(theta, theta);
  JointTurn<S> turn{theta, near_coefficients(x)};
  if (any(x > constant<S>(1))) {
    const S far = x;  // a copy, so that x may stay in a register
    turn.by = far_coefficients(far);
  }
  return turn;
}

/// A segment's frame as a unit quaternion (w, v).
template <class S>
struct Quaternion {
  S w;
  Triple<S> v;

  /// This frame turned by a joint.
  PLASTICA_ALWAYS_INLINE Quaternion then(const JointTurn<S>& turn) const {
    const Triple<S> sine = (constant<S>(0.5) * turn.by.sinc) * turn.theta;
    const S straight = multiply_add(w, turn.by.cosine, -dot(v, sine));
    return {straight, cross_add(v, sine, scale_add(w, sine, turn.by.cosine * v))};
  }

  /// The frame's axes.
  PLASTICA_ALWAYS_INLINE Columns<S> axes() const {
    const S one = constant<S>(1);
    const Triple<S> twice = v + v;
    const Triple<S> by_w = w * twice;
    const S xx = v.x * twice.x;
    const S yy = v.y * twice.y;
    const S zz = v.z * twice.z;
    return {
        {one - (yy + zz), multiply_add(v.x, twice.y, by_w.z), multiply_add(v.x, twice.z, -by_w.y)},
        {multiply_add(v.x, twice.y, -by_w.z), one - (xx + zz), multiply_add(v.y, twice.z, by_w.x)},
        {multiply_add(v.x, twice.z, by_w.y), multiply_add(v.y, twice.z, -by_w.x), one - (xx + yy)}};
  }
};

/// What turns a joint's rate in world axes into that of its angle, by rows: T^-1 R^T = (R T^-T)^T
/// with the axes R of its inner side, so that row k is R times column k of T^-T.
template <class S>
PLASTICA_ALWAYS_INLINE inline Columns<S> angle_rate_rows(const JointTurn<S>& turn,
                                                         const Columns<S>& inner) {
  const Triple<S>& t = turn.theta;
  const Triple<S> half = constant<S>(0.5) * t;
  const Triple<S> ct = turn.by.c * t;
  const S xx = ct.x * t.x;
  const S yy = ct.y * t.y;
  const S zz = ct.z * t.z;
  const S one = constant<S>(1);
  return {columns_times(inner, Triple<S>{one - (yy + zz), multiply_add(ct.x, t.y, half.z),
                                         multiply_add(ct.x, t.z, -half.y)}),
          columns_times(inner, Triple<S>{multiply_add(ct.x, t.y, -half.z), one - (xx + zz),
                                         multiply_add(ct.y, t.z, half.x)}),
          columns_times(inner, Triple<S>{multiply_add(ct.x, t.z, half.y),
                                         multiply_add(ct.y, t.z, -half.x), one - (xx + yy)})};
}

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
