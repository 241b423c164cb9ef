#pragma once

#include "plastica/theory/beam_ends.hpp"

namespace plastica::theory {

// Small undamped vibrations of an even, straight beam, in bending and in torsion. Bending without
// shear deformation: E I w'''' - rho I w''.. + rho A w.. = 0 (two primes: by x, two points: by
// time), Rayleigh's beam; without its middle term, the rotary inertia, Euler and Bernoulli's.

/// A beam that vibrates.
struct VibratingBeam {
  double length = 1.0;             ///< L [m], > 0
  double bending_stiffness = 1.0;  ///< E I [N m^2], > 0
  double mass_per_length = 1.0;    ///< rho A [kg/m], > 0
  double rotary_inertia = 0.0;     ///< rho I, per length [kg m], >= 0
};

/// beta L of a mode of an Euler-Bernoulli beam; omega = (beta L)^2 sqrt(E I/(rho A L^4)).
///
/// Roots of cos x cosh x = -1 (clamped-free), = +1 (clamped-clamped, and free-free without its
/// rigid-body modes), tan x = tanh x (clamped-pinned),
/// n pi (pinned-pinned). Source: Timoshenko, Vibration Problems in Engineering, lateral vibration
/// of bars with various end conditions.
/// @param mode  1, 2, …
double frequency_root(BeamEnds ends, int mode);

/// Circular frequency of a bending mode without rotary inertia [rad/s].
/// @param beam  its rotary inertia is not read
double circular_frequency(BeamEnds ends, int mode, const VibratingBeam& beam);

/// Circular frequency of a bending mode of a cantilever with rotary inertia [rad/s].
///
/// With w = W(x/L) cos(omega t), b = omega^2 rho A L^4/(E I) and r^2 = I/(A L^2):
/// W'''' + b r^2 W'' - b W = 0, so W is made of cos and sin of p x/L, cosh and sinh of q x/L, where
/// p^2 - q^2 = b r^2 and p q = sqrt(b); hence q = p/sqrt(1 + p^2 r^2), b = p^2 q^2. Clamped, W(0) =
/// W'(0) = 0, leaves
/// W = C (cosh qx - cos px) + D (sinh qx/q - sin px/p); at the free end the moment, W'', and the
/// shear force with the inertia of rotation, W''' + b r^2 W', vanish. That determinant is
///
///   2 p^2 q^2 + (p^4 + q^4) cosh q cos p - p q (p^2 - q^2) sinh q sin p = 0,
///
/// Euler and Bernoulli's 1 + cosh p cos p = 0 where r = 0. At p = n pi its sign is that of (-1)^n,
/// as p^4 + q^4 >= 2 p^2 q^2 and cosh q > 1: mode n is where it changes between (n - 1) pi and
/// n pi. Source: the equation of motion is Rayleigh's, The Theory of Sound, vol. 1, 1877, chap. 8.
/// @param mode  1, 2, …
double rayleigh_cantilever_frequency(int mode, const VibratingBeam& beam);

/// Circular frequency of a torsional mode of a bar that is clamped at one end [rad/s]:
/// (2n - 1) pi/(2 L) sqrt(G J/(rho I_p)), of the wave equation G J phi'' = rho I_p phi...
/// @param mode                1, 2, …
/// @param torsional_stiffness G J [N m^2]
/// @param polar_inertia       rho (I_x + I_y), per length [kg m]
double clamped_free_torsion_frequency(int mode, double length, double torsional_stiffness,
                                      double polar_inertia);

/// Tip deflection of a cantilever without rotary inertia that a sudden even acceleration across it,
/// as gravity, sets in motion from rest and straight [m].
///
/// The modes W_n = cosh bx - cos bx - s (sinh bx - sin bx), b = beta_n,
/// s = (cosh bL + cos bL)/(sinh bL + sin bL), have the integrals L of their square and 2 s/b of
/// themselves, and the tip 2 (-1)^(n+1). So mode n, an oscillator under the force g int W/int W^2,
/// moves the tip by (-1)^(n+1) 4 s g/(b L omega_n^2) (1 - cos omega_n t).
/// The terms fall as the fifth power of n; their sum swings about g rho A L^4/(8 E I).
/// @param acceleration  g [m/s^2]
/// @param time          [s], >= 0
/// @param modes         how many are summed, >= 1
double released_cantilever_tip(const VibratingBeam& beam, double acceleration, double time,
                               int modes);

}  // namespace plastica::theory
