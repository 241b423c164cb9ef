#pragma once

#include "plastica/base/scalar.hpp"

/// Permanent strain of a joint, which breaks when one exceeds its limit.
///
/// Angles theta are permanent joint angles [rad], l is the joint's tributary length [m], h the
/// depth of the section across the bending axis [m]. All strains are >= 0 [1]. A joint angle is
/// smeared over l: the permanent curvature is theta/l, and the extreme fibre is h/2 away from the
/// axis (small strains; plane sections).
namespace plastica::law {

/// Bending about one axis: (h/2) |theta| / l.
template <class S>
inline S permanent_bending_strain(const S& theta, const S& depth, const S& length) {
  return constant<S>(0.5) * depth * abs(theta) / length;
}

/// Bending about both axes of a circle of radius R: the axis of the resultant counts,
/// R |(theta_x, theta_y)| / l.
template <class S>
inline S permanent_biaxial_strain_circle(const S& theta_x, const S& theta_y, const S& radius,
                                         const S& length) {
  return radius * sqrt(theta_x * theta_x + theta_y * theta_y) / length;
}

/// Bending about both axes of a rectangle: its corner counts, (h |theta_x| + b |theta_y|) / 2 l.
template <class S>
inline S permanent_biaxial_strain_rectangle(const S& theta_x, const S& theta_y, const S& width,
                                            const S& height, const S& length) {
  return constant<S>(0.5) * (height * abs(theta_x) + width * abs(theta_y)) / length;
}

/// Torsion: (J/W_t) |theta| / l. With T = G J theta/l and tau = T/W_t the largest shear strain is
/// tau/G; J/W_t is R for a circle, 0.675 s for a square of side s.
/// @param lever J/W_t [m]
template <class S>
inline S permanent_torsion_strain(const S& theta, const S& lever, const S& length) {
  return lever * abs(theta) / length;
}

/// Stretching: permanent elongation / l.
template <class S>
inline S permanent_stretch_strain(const S& elongation, const S& length) {
  return abs(elongation) / length;
}

/// Bending after Wendelius' report, its equation (24): the chord of the angle,
/// sqrt(2 (h/2)^2 (1 - cos theta)) / l = (h/l) sin(|theta|/2).
/// As printed it falls again beyond pi and the joint would heal; it is held at its maximum there.
template <class S>
inline S report_bending_strain(const S& theta, const S& depth, const S& length) {
  const S angle = min(abs(theta), constant<S>(3.14159265358979323846));
  return depth / length * sin(constant<S>(0.5) * angle);
}

/// Torsion after Wendelius' report, its equation (8): (c/2) |theta| / l, c the longer side (or the
/// diameter).
template <class S>
inline S report_torsion_strain(const S& theta, const S& longer_side, const S& length) {
  return constant<S>(0.5) * longer_side * abs(theta) / length;
}

}  // namespace plastica::law
