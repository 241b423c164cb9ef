#pragma once

#include <vector>

namespace plastica::theory {

// A cantilever of N joints or segments that are rigid, small rotations: what its tip does, over
// what that of the continuous beam does. h = L/N. A joint at the distance s L from the tip with
// the tributary length w L turns by w L times the curvature that the moment there gives the
// continuous beam, and moves the tip by s L times that. So with a tip force the ratio is
// 3 sum w s^2, with self-weight 4 sum w s^3, with a tip moment 2 sum w s; the closed forms are
// these sums over powers of integers.

/// How the joints of a cantilever sit and how long the part is that each stands for.
enum class ChainConvention {
  Clamp,            ///< A: N segments, the first clamped; N - 1 joints of length h
  FullJoint,        ///< B: N segments; N joints of length h, the first at the clamp
  HalfJoint,        ///< C: N segments; N joints, that at the clamp of length h/2
  HalfEnds,         ///< D: N joints of length h at the middles of N parts; end links of h/2
  ThreeHalvesEnds,  ///< A with the end segments whole at their only joint: l = 3h/2, N = 2: 2h
};

/// One joint of a chain.
struct ChainJoint {
  double lever = 0.0;   ///< s: distance from the tip over L [1]
  double length = 0.0;  ///< w: tributary length over L [1]
};

/// All joints of a chain, from the clamp to the tip.
/// @param count  N >= 2
std::vector<ChainJoint> chain_joints(ChainConvention convention, int count);

/// Tip deflection under a tip force, chain over continuum [1].
///
/// A (N-1)(2N-1)/(2N^2), B (N+1)(2N+1)/(2N^2), C 1 + 1/(2N^2), D 1 - 1/(4N^2),
/// three halves 1 - 5/(2N^2) + 3/N^3.
/// @param count  N >= 2
double tip_force_ratio(ChainConvention convention, int count);

/// Tip deflection under an even load, chain over continuum [1].
///
/// A (1 - 1/N)^2, B (1 + 1/N)^2, C 1 + 1/N^2, D 1 - 1/(2N^2), three halves 1 - 5/N^2 + 6/N^3.
/// @param count  N >= 2
double self_weight_ratio(ChainConvention convention, int count);

/// Tip deflection under a tip moment, chain over continuum [1].
///
/// A 1 - 1/N, B 1 + 1/N, all others 1: the half joint and its like make the chain the polygon of
/// the circle (polygon.hpp).
/// @param count  N >= 2
double tip_moment_ratio(ChainConvention convention, int count);

/// Frequency of a bending mode of a chain with pinned ends, over that of the continuous beam [1].
///
/// N segments of length h with the mass of a thin rod, m = rho A h, joints of length h between
/// them. The node displacements w_j = sin(j x), x = pi mode/N, make the joints turn by
/// -(2 sin(x/2))^2 w_j/h, and a rod whose ends move by a and b has the kinetic energy of
/// m (a^2 + a b + b^2)/3. With s = sin(x/2) then
/// omega^2 = E I/(rho A h^4) 16 s^4/(1 - 2 s^2/3), x^4 (1 + O(x^4)) of it: order four.
/// @param count  N >= 2
/// @param mode   1 … N - 1
double pinned_chain_frequency_ratio(int count, int mode);

/// Load along a cantilever of N segments, the joint at the clamp of length h/2, at which it buckles
/// [N]: 4 N^2 sin^2(pi/(4 N)) E I/L^2, Euler's pi^2 E I/(4 L^2) as N grows.
///
/// Segments at the slopes phi_i under P are in balance if E I/h (2 phi_i - phi_{i-1} - phi_{i+1}) =
/// P h phi_i, so phi_i = sin((i + 1/2) t) with 2 - 2 cos t = P h^2/(E I). The half joint is a whole
/// one to the clamp's mirror image, phi_{-1} = -phi_0; the free end, phi_N = phi_{N-1}, takes
/// N t = pi/2.
/// @param count  N >= 1
double buckling_load(int count, double bending_stiffness, double length);

/// Tip deflection of a chain whose joints follow the elastic-perfectly-plastic moment-curvature
/// law of the rectangle, over that at first yield of the continuous beam, delta_y = P_y L^3/(3EI).
///
/// 3 sum w s k(p s), k = curvature_ratio_rectangle (bending.hpp); tends to tip_deflection_ratio(p)
/// (cantilever.hpp).
/// @param load_ratio  p = P/P_y [1], 0 <= p < 1.5
double elastoplastic_tip_ratio(ChainConvention convention, int count, double load_ratio);

/// A plastic hinge when its extreme fibre reaches the break strain.
struct HingeBreak {
  double angle = 0.0;       ///< [rad]
  double tip_travel = 0.0;  ///< plastic part [m]
  double energy = 0.0;      ///< plastic work [J]
};

/// Break of a perfectly plastic cantilever whose rotation gathers in one hinge.
///
/// The strain (depth/2) angle/hinge_length reaches the limit at angle = 2 break_strain
/// hinge_length/depth; the tip travels lever times that, the work is M_p times that. With the
/// length of a joint for that of the hinge, all of it falls as 1/N and means nothing for the
/// material; with a length of the material (Scott & Fenves, J. Struct. Eng. 132, 2006, 244) it is
/// a property of the beam.
/// @param break_strain    permanent [1], > 0
/// @param depth           h [m], > 0
/// @param hinge_length    the joint's tributary length, or L_p [m], > 0
/// @param plastic_moment  M_p [N m]
/// @param lever           from the hinge to the tip [m]
HingeBreak hinge_break(double break_strain, double depth, double hinge_length,
                       double plastic_moment, double lever);

}  // namespace plastica::theory
