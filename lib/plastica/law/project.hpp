#pragma once

#include <cstddef>

#include "plastica/base/matrix.hpp"
#include "plastica/law/gauge.hpp"
#include "plastica/law/interior_point.hpp"
#include "plastica/law/linear_piece.hpp"
#include "plastica/law/section_response.hpp"

/// Closest-point projection onto a yield surface.
///
/// Of all z with phi(z) <= 1 the one that minimizes sum over i of (z_i - target_i)^2/(2 c_i). With
/// c_i the stiffness over the square of the cap this is the distance in elastic energy, and the
/// projection is the implicit (backward Euler) return of ideal associated plasticity.
///
/// In the orthant of `gauge.hpp` it is a smooth convex problem with inequalities f_k(u) <= 1/2 and
/// u >= 0. Three ways, from the cheapest: along an axis; onto one piece that is linear in moments
/// and axial force (`linear_piece.hpp`), if no other is in the way; by interior points
/// (`interior_point.hpp`).
namespace plastica::law {
namespace detail {

/// Slope of a component that a kink keeps at zero. Exactly it is zero as well: while |m_x| + |m_y|
/// = 1 flows along its axis x, a small m_y meets no resistance, and the tangent of a beam that
/// bends in a plane would be singular across it. With this slope, rounding errors stay there what
/// they are; the force is not changed.
inline constexpr double kLeastSlope = 1e-5;

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
  const LinearPiece<S> piece = gauge.linear_piece(target);
  const auto simple = hard & piece.applies;
  if (any(simple)) {
    const Projection<S> found = project_on_line<Gauge::kRound>(piece, compliance, target, simple);
    const S within = constant<S>(sizeof(real_t<S>) == 8 ? 1.0 + 1e-13 : 1.0 + 1e-6);
    const auto fits = simple & (orthant_gauge(gauge, found.point) < within);
    take(found, fits);
    hard = hard & !fits;
  }
  if (any(hard)) {
    take(InteriorPoint<Gauge>(gauge, compliance, target, select(hard, overshoot, one), hard)
             .result(),
         hard);
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
    const auto gone = inside.point[i] < constant<S>(sizeof(real_t<S>) == 8 ? 1e-9 : 1e-5);
    const S slope = max(inside.slope(i, i), constant<S>(detail::kLeastSlope));
    inside.slope(i, i) = select(gone, slope, inside.slope(i, i));
  }
  const SectionTangent<S> axes = axes_of<Gauge>(target, u);
  // Column i of `axes` is the direction of u_i; the size of what is across a resultant shrinks with
  // the resultant.
  Projection<S> now;
  now.point = axes * inside.point;
  now.slope = axes * inside.slope * transpose(axes);
  if constexpr (Gauge::kRound) {
    const auto some = u[kBendingX] > constant<S>(0);
    const S ratio =
        select(some, inside.point[kBendingX] / select(some, u[kBendingX], constant<S>(1)),
               inside.slope(kBendingX, kBendingX));
    const S ex = axes(kBendingX, kBendingX);
    const S ey = axes(kBendingY, kBendingX);
    now.slope(kBendingX, kBendingX) += ratio * ey * ey;
    now.slope(kBendingX, kBendingY) -= ratio * ex * ey;
    now.slope(kBendingY, kBendingX) -= ratio * ex * ey;
    now.slope(kBendingY, kBendingY) += ratio * ex * ex;
  }
  return now;
}

}  // namespace plastica::law
