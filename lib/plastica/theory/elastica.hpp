#pragma once

namespace plastica::theory {

// Inextensible, unshearable elastic cantilever in a plane, displacements of any size. Lengths over
// L, angles [rad]; the clamp is at the origin, the undeformed beam lies along x.

/// Where the tip of a bent cantilever is.
struct ElasticaTip {
  double slope = 0.0;       ///< angle of the tip's tangent [rad]
  double deflection = 0.0;  ///< y/L, along the load [1]
  double position = 1.0;    ///< x/L [1]
};

/// Carlson's symmetric elliptic integral of the first kind, relative error below 1e-14.
///
/// R_F = 1/2 int_0^inf dt / sqrt((t+x)(t+y)(t+z)); none negative, at most one zero.
/// Source: Carlson, Numer. Algorithms 10 (1995) 13: duplication.
double carlson_rf(double x, double y, double z);

/// Carlson's symmetric elliptic integral of the second kind, relative error below 1e-14.
///
/// R_D = 3/2 int_0^inf dt / (sqrt((t+x)(t+y)) (t+z)^(3/2)); z > 0. Source: as carlson_rf.
double carlson_rd(double x, double y, double z);

/// Tip under a dead load P at the tip, at right angles to the undeformed beam.
///
/// From E I theta'' = -P cos theta: (theta' L)^2 = 2 alpha (s - sin theta), s the sine of the tip
/// slope. Integrated over the beam with sin theta = s x/(1+x):
///   alpha = 2 s F^2,  F = R_F(1-s, 1-s^2, 1+s),
///   deflection = sqrt(2/alpha) s^(3/2) (F - (1-s^2)/3 R_D(1-s, 1+s, 1-s^2)),
///   position = sqrt(2 s/alpha).
/// The first is solved for s = tanh u by bisection to the last bit of u; the relative error of each
/// result is below 1e-13. First found, in other variables, by Bisshopp & Drucker,
/// Q. Appl. Math. 3 (1945) 272. For small alpha the deflection is alpha/3 - 4 alpha^3/105, the
/// position 1 - alpha^2/15.
/// @param load  alpha = P L^2/(E I) [1], 0 <= alpha <= 1e4
ElasticaTip elastica_tip_force(double load);

/// Tip under a moment M at the tip: the beam is an arc of a circle.
/// @param angle  M L/(E I) [rad], the tip slope; 2 pi closes the circle
ElasticaTip elastica_tip_moment(double angle);

}  // namespace plastica::theory
