#pragma once

#include <cstddef>

#include "plastica/base/matrix.hpp"
#include "plastica/law/closest_point.hpp"
#include "plastica/law/gauge.hpp"
#include "plastica/law/linear_facet.hpp"
#include "plastica/law/section_response.hpp"

/// Closest-point projection onto a yield surface.
///
/// Of all z with phi(z) <= 1 the one that minimizes sum over i of (z_i - target_i)^2/(2 c_i). With
/// c_i the stiffness over the square of the cap this is the distance in elastic energy, and the
/// projection is the implicit (backward Euler) return of ideal associated plasticity.
///
/// In the orthant of `gauge.hpp` it is a convex problem with inequalities phi_k(u) <= 1 and u >= 0.
/// One method is right for every target on every surface (`closest_point.hpp`). Two cases that are
/// common have a form of their own: a target on an axis, and a surface that is one circle of
/// torsion and a sum of the others (`linear_facet.hpp`). README.md says what each of them takes.
namespace plastica::law {
namespace detail {

/// Slope of a component that a kink keeps at zero. Exactly it is zero as well: while |m_x| + |m_y|
/// = 1 flows along its axis x, a small m_y meets no resistance, and the tangent of a beam that
/// bends in a plane would be singular across it. With this slope, rounding errors stay there what
/// they are; the force is not changed.
inline constexpr double kMinSlope = 1e-5;

/// Projects in the orthant where the mask holds.
///
/// A target on an axis returns along it: the point is known, and so is the slope. It is the only
/// case that bending in a plane knows.
template <class Gauge>
inline Projection<typename Gauge::Scalar> project_orthant(
    const Gauge& gauge, const SectionForce<typename Gauge::Scalar>& compliance,
    const SectionForce<typename Gauge::Scalar>& target, const typename Gauge::Scalar& overshoot,
    const mask_t<typename Gauge::Scalar>& mask) {
  using S = typename Gauge::Scalar;
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  S count = zero;
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    count += select(target[i] > zero, one, zero);
  }
  const auto alone = count < constant<S>(1.5);
  Projection<S> now;
  const SectionTangent<S> curvature = gauge.axis_curvature();
  for (std::size_t j = 0; j < kSectionAxes; ++j) {
    const auto on_axis = target[j] > zero;
    now.point[j] = select(on_axis, one, zero);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      if (i == j) continue;
      // u_i + multiplier c_i curvature u_i = target_i.
      const S bent = overshoot * compliance[i] / compliance[j] * curvature(j, i);
      now.slope(i, i) = select(on_axis, one / (one + bent), now.slope(i, i));
    }
  }
  auto hard = mask & !alone;
  const auto take = [&](const Projection<S>& other, const mask_t<S>& where) {
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      now.point[i] = select(where, other.point[i], now.point[i]);
      for (std::size_t j = 0; j < kSectionAxes; ++j) {
        now.slope(i, j) = select(where, other.slope(i, j), now.slope(i, j));
      }
    }
  };
  if constexpr (requires { gauge.linear_facet(target); }) {
    if (any(hard)) {
      const LinearFacet<S> facet = gauge.linear_facet(target);
      const auto simple = hard & facet.applies;
      if (any(simple)) {
        take(project_on_line<Gauge::kRound>(facet, compliance, target, simple), simple);
      }
      hard = hard & !simple;
    }
  }
  if (any(hard)) {
    take(
        ClosestPoint<Gauge>(gauge, compliance, target, select(hard, overshoot, one), hard).result(),
        hard);
  }
  return now;
}

/// What was found in the orthant, for the force itself: the sizes' directions are signs.
template <class Gauge>
inline Projection<typename Gauge::Scalar> with_signs(
    const SectionForce<typename Gauge::Scalar>& target,
    const SectionForce<typename Gauge::Scalar>& u,
    const Projection<typename Gauge::Scalar>& inside) requires(!Gauge::kRound) {
  using S = typename Gauge::Scalar;
  Projection<S> now;
  SectionForce<S> side;
  for_each_of<kSectionAxes>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
    side[i] = sign(target[i]);
    now.point[i] = side[i] * inside.point[i];
  });
  for_each_of<kSectionAxes * kSectionAxes>([&](std::size_t at) PLASTICA_ALWAYS_INLINE {
    now.slope.at[at] = side[at / kSectionAxes] * side[at % kSectionAxes] * inside.slope.at[at];
  });
  static_cast<void>(u);
  return now;
}

/// The same of a round section, whose resultant moment keeps its direction: what is across it
/// shrinks with it.
template <class Gauge>
inline Projection<typename Gauge::Scalar> with_signs(
    const SectionForce<typename Gauge::Scalar>& target,
    const SectionForce<typename Gauge::Scalar>& u,
    const Projection<typename Gauge::Scalar>& inside) requires(Gauge::kRound) {
  using S = typename Gauge::Scalar;
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  const auto some = u[kBendingX] > zero;
  const S inverse = one / select(some, u[kBendingX], one);
  const S along_x = select(some, target[kBendingX] * inverse, one);
  const S along_y = select(some, target[kBendingY] * inverse, zero);
  const S stays = inside.slope(kBendingX, kBendingX);
  const S across = select(some, inside.point[kBendingX] * inverse, stays);
  Projection<S> now;
  now.point[kBendingX] = along_x * inside.point[kBendingX];
  now.point[kBendingY] = along_y * inside.point[kBendingX];
  now.slope(kBendingX, kBendingX) = along_x * along_x * stays + along_y * along_y * across;
  now.slope(kBendingX, kBendingY) = along_x * along_y * (stays - across);
  now.slope(kBendingY, kBendingX) = now.slope(kBendingX, kBendingY);
  now.slope(kBendingY, kBendingY) = along_y * along_y * stays + along_x * along_x * across;
  for (const std::size_t i : {kTorsion, kAxial}) {
    const S side = sign(target[i]);
    now.point[i] = side * inside.point[i];
    for (const std::size_t j : {kTorsion, kAxial}) {
      now.slope(i, j) = side * sign(target[j]) * inside.slope(i, j);
    }
    now.slope(i, kBendingX) = side * along_x * inside.slope(i, kBendingX);
    now.slope(i, kBendingY) = side * along_y * inside.slope(i, kBendingX);
    now.slope(kBendingX, i) = side * along_x * inside.slope(kBendingX, i);
    now.slope(kBendingY, i) = side * along_y * inside.slope(kBendingX, i);
  }
  return now;
}

}  // namespace detail

/// Projects onto phi(z) <= 1.
///
/// @param compliance  c: weights of the distance; of a round section c_x = c_y
/// @param target      z before
/// @param overshoot   phi(target) - 1
/// @param mask        where the target is outside; elsewhere the result means nothing
template <class Gauge>
inline Projection<typename Gauge::Scalar> project(
    const Gauge& gauge, const SectionForce<typename Gauge::Scalar>& compliance,
    const SectionForce<typename Gauge::Scalar>& target, const typename Gauge::Scalar& overshoot,
    const mask_t<typename Gauge::Scalar>& mask) {
  using S = typename Gauge::Scalar;
  const SectionForce<S> u = orthant_of<Gauge>(target);
  Projection<S> inside = detail::project_orthant(gauge, compliance, u, overshoot, mask);
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    const auto vanishes = inside.point[i] < constant<S>(sizeof(real_t<S>) == 8 ? 1e-9 : 1e-5);
    const S slope = max(inside.slope(i, i), constant<S>(detail::kMinSlope));
    inside.slope(i, i) = select(vanishes, slope, inside.slope(i, i));
  }
  return detail::with_signs<Gauge>(target, u, inside);
}

}  // namespace plastica::law
