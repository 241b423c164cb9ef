#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <memory>

namespace plastica {

/// beta of J = beta c s^3, the torsion constant of a rectangle with sides c >= s.
///
/// beta = 1/3 - (64/pi^5)(s/c) sum over odd n of tanh(n pi c/2s)/n^5; at most 1e-14 off.
/// Source: Saint-Venant's series, Timoshenko & Goodier, Theory of Elasticity, sec. 109.
/// @param ratio  c/s [1], >= 1
double saint_venant_beta(double ratio);

/// alpha of W_t = alpha c s^2: the largest shear stress, mid long side, is T/(alpha c s^2).
/// Source: as saint_venant_beta.
/// @param ratio  c/s [1], >= 1
double saint_venant_alpha(double ratio);

/// eta: shear stress at the middle of the short side over that at the middle of the long side.
/// Source: as saint_venant_beta.
/// @param ratio  c/s [1], >= 1
double saint_venant_eta(double ratio);

/// Shear stress at a point of a rectangle's perimeter over the largest, that at the middle of the
/// long sides; 0 at the corners. Within 1e-4 next to a corner, 1e-6 elsewhere.
/// Source: as saint_venant_beta.
/// @param ratio      c/s [1], >= 1
/// @param long_side  whether the point is on a long side or on a short one
/// @param position   distance from the middle of the side over half its length [1], 0..1
double saint_venant_perimeter_stress(double ratio, bool long_side, double position);

/// Shear stress at a point of a rectangle over G theta [m], theta the twist per length: the slope
/// of Prandtl's stress function. Within 1e-7 of the largest, but for points nearer to the end of
/// the longer dimension than 1e-3 of the section. Source: as saint_venant_beta.
/// @param width, height  sides in either order [m]
/// @param x, y           from the middle, along the width and along the height [m]
double saint_venant_shear(double width, double height, double x, double y);

/// T_p/tau_y [m^3] of a rectangle: twice the volume of Nadai's sand heap, s^2 (3c - s)/6.
/// @param width, height  sides in either order [m]
double sand_heap_modulus_rectangle(double width, double height);

/// A rectangle with a centred rectangular hole [m].
struct BoxDimensions {
  double width = 0.0;
  double height = 0.0;
  double inner_width = 0.0;
  double inner_height = 0.0;
  auto operator<=>(const BoxDimensions&) const = default;
};

/// Torsion of a rectangular tube.
struct BoxTorsion {
  double constant = 0.0;  ///< J [m^4]
  double modulus = 0.0;   ///< W_t [m^3]: J over the largest shear stress, per unit twist and G, at
                          ///< the middles of the outer sides (at the sharp corners of the hole
                          ///< elasticity has no finite stress)
};

/// A rectangular tube, solved: `solved_box`.
struct SolvedBox {
  virtual ~SolvedBox() = default;
  /// Shear stress over G theta [m] at a point (x, y) of the wall, from the middle [m]. The elements
  /// are coarser than `torsion` (1 %, more at the sharp corners of the hole, where it is infinite).
  virtual double shear_at(const std::array<double, 2>& point) const = 0;

  BoxTorsion torsion;
  double plastic_modulus = 0.0;  ///< `sand_heap_modulus_box` [m^3]
};

/// Solves Prandtl's stress function of a rectangular tube, or finds the box among the last thousand
/// that were solved.
///
/// laplace(phi) = -2 in the wall, 0 on the outer boundary, an unknown constant on the hole that
/// follows from the circulation of the shear stress, 2 G theta A_i. Bilinear finite elements on a
/// quarter of the section, graded towards the re-entrant corner, two grids and Richardson's
/// extrapolation; the circulation condition is the natural one of the constant over the hole.
/// Within 0.01 % (against grids three times as fine) for walls from 1e-4 to 0.5 of a side.
/// @throws std::invalid_argument for a side that is not finite
std::shared_ptr<const SolvedBox> solved_box(const BoxDimensions& box);

/// How many boxes have been solved so far, by all threads: for tests.
std::size_t boxes_solved();

/// J and W_t of a rectangular tube by Bredt's thin-wall formulas on the middle lines.
BoxTorsion bredt_box(const BoxDimensions& box);

/// T_p/tau_y [m^3] of a rectangular tube: Nadai's sand heap with a hole.
///
/// The heap is the highest surface of slope <= 1 that is zero on the outer boundary and constant
/// over the hole: phi = min(distance to the outer boundary, t + distance to the hole), t the
/// thinner wall. With walls of one thickness it is the frustum, so the modulus is the difference
/// of the two solid rectangles'; with two thicknesses it is integrated (1e-5).
double sand_heap_modulus_box(const BoxDimensions& box);

}  // namespace plastica
