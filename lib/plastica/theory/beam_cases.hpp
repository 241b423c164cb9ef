#pragma once

#include "plastica/theory/beam_ends.hpp"

namespace plastica::theory {

// Elementary cases of the Euler-Bernoulli beam of even section: small displacements, elastic. x
// runs from one end to the other; deflections and forces are positive one way across the beam, a
// moment on the beam is positive when it turns the beam's slope dv/dx up, the bending moment is
// E I d2v/dx2. Sources: the reactions of the statically indeterminate beams are those of
// Timoshenko, Strength of Materials, part 1, and Roark, Formulas for Stress and Strain, table of
// shear, moment, slope and deflection; derived here by the force method, see each function.

/// What acts on a beam; the parts add up.
struct BeamLoad {
  double position = 0.0;     ///< a: of force and moment, from x = 0 [m], 0 … L
  double force = 0.0;        ///< P [N]
  double moment = 0.0;       ///< C [N m]
  double distributed = 0.0;  ///< w: even, over the whole length [N/m]
};

/// A beam under a load.
struct BeamCase {
  BeamEnds ends = BeamEnds::ClampedFree;  ///< any but FreeFree
  double length = 1.0;                    ///< L [m], > 0
  double bending_stiffness = 1.0;         ///< E I [N m^2], > 0
  BeamLoad load{};
};

/// Forces [N] and moments [N m] of the supports on the beam.
struct BeamReactions {
  double start_force = 0.0;
  double start_moment = 0.0;
  double end_force = 0.0;
  double end_moment = 0.0;
};

/// Reactions, with b = L - a:
/// - clamped-free: by equilibrium;
/// - pinned-pinned: the end force is -(P a + C)/L - w L/2;
/// - clamped-pinned: the end force takes back the tip deflection of the cantilever,
///   -P a^2 (3L - a)/(2 L^3) - 3 C a (2L - a)/(2 L^3) - 3 w L/8;
/// - clamped-clamped: end force and moment take back its tip's deflection and slope,
///   force -P a^2 (a + 3b)/L^3 - 6 C a b/L^3 - w L/2,
///   moment P a^2 b/L^2 + C a (2b - a)/L^2 + w L^2/12;
/// the start by equilibrium.
BeamReactions beam_reactions(const BeamCase& beam);

/// Bending moment at x [N m]: R x - M + P <x-a> - C <x-a>^0 + w x^2/2 with the reactions R, M of
/// the start and <d> = max(d, 0); at x = a, where C jumps, the value beyond.
double beam_moment(const BeamCase& beam, double x);

/// Slope dv/dx at x [rad]: the moment over E I integrated once; at x = 0 it is zero, or, pinned,
/// such that the far end stays where it is.
double beam_slope(const BeamCase& beam, double x);

/// Deflection v at x [m]: the moment over E I integrated twice, from v(0) = 0.
double beam_deflection(const BeamCase& beam, double x);

/// What shear adds to the tip deflection of a cantilever with tip force and even load [m]:
/// (P L + w L^2/2)/(kappa G A), the shear force over kappa G A integrated along the beam.
/// Source: Timoshenko, Phil. Mag. 41 (1921) 744.
/// @param force            P at the tip [N]
/// @param distributed      w [N/m]
/// @param length           L [m]
/// @param shear_stiffness  kappa G A [N], > 0
double cantilever_shear_deflection(double force, double distributed, double length,
                                   double shear_stiffness);

}  // namespace plastica::theory
