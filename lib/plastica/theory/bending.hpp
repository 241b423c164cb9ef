#pragma once

namespace plastica::theory {

// Moment-curvature curves of elastic-perfectly-plastic sections, plane sections staying plane,
// from the virgin state. k = curvature over the curvature at first yield, sigma_y/(E y_max); the
// result is M/M_y with M_y the moment at first yield. All are odd in k; |k| <= 1 is elastic.

/// M/M_y of a rectangle: 1.5 (1 - 1/(3 k^2)); tends to 1.5.
/// Source: Prager & Hodge, Theory of Perfectly Plastic Solids, 1951.
double moment_ratio_rectangle(double curvature_ratio);

/// The inverse: curvature ratio k = 1/sqrt(3 - 2 m) of a rectangle.
/// @param moment_ratio  m = M/M_y [1], |m| < 1.5
double curvature_ratio_rectangle(double moment_ratio);

/// M/M_y of a solid circle; tends to 16/(3 pi).
///
/// With c = 1/k: (16/pi) ((asin c - c sqrt(1-c^2)(1-2c^2))/(8c) + (1-c^2)^(3/2)/3), the elastic
/// core |y| <= cR and the plastic rest integrated over the circle.
double moment_ratio_circle(double curvature_ratio);

/// M/M_y of a round tube: the outer circle less the inner one at the same curvature.
/// @param radius_ratio  inner over outer radius [1], >= 0, < 1
double moment_ratio_round_tube(double curvature_ratio, double radius_ratio);

/// M/M_y of a rectangular tube: the outer rectangle less the inner one at the same curvature.
/// @param depth_ratio    inner over outer side in the plane of bending [1], >= 0, < 1
/// @param breadth_ratio  inner over outer side across it [1], >= 0, < 1
double moment_ratio_rectangular_tube(double curvature_ratio, double depth_ratio,
                                     double breadth_ratio);

}  // namespace plastica::theory
