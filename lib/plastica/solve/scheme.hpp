#pragma once

#include "plastica/model/motion.hpp"

namespace plastica::solve {

/// What a scheme does to the energy of an elastic beam on which nothing else acts.
enum class EnergyBehaviour {
  Loses,     ///< it falls with the step, most of all at high frequencies
  Wanders,   ///< neither kept nor lost on purpose: off by the scheme's order
  Conserves  ///< kept to the tolerance of Newton's method
};

/// What a scheme promises; tests/lib/run/motion_schemes_test.cpp holds it to that.
struct SchemeClaims {
  int order = 1;  ///< in the time step
  EnergyBehaviour energy = EnergyBehaviour::Wanders;
  bool momentum = false;    ///< linear and angular momentum kept to the tolerance
  bool reversible = false;  ///< back to the start when the velocities are turned round
  bool one_solve = false;   ///< one factorization a step
};

/// - Linearly implicit Euler: the implicit Euler step (Hairer & Wanner, Solving Ordinary
///   Differential Equations II), one Newton iteration from where the velocities point to.
/// - Linearly implicit midpoint: the energy-momentum step below, one such iteration. Its error is
/// of
///   third order in the step, so that second order is kept; what it leaves of a free fragment's
///   momentum is given back (fragment_momentum.hpp).
/// - Generalized-alpha (Chung & Hulbert, J. Appl. Mech. 60, 1993, 371) on the rotation group
///   (Bruls & Cardona, J. Comput. Nonlinear Dyn. 5, 2010, 031002), with Cayley's map; Newton's
///   method to its end.
/// - Energy-momentum: midpoint in conservation form (Simo & Wong, Int. J. Numer. Meth. Eng. 31,
///   1991, 19), joint moments as discrete gradients (Gonzalez, J. Nonlinear Sci. 6, 1996, 449);
///   Newton's method to its end.
/// - Articulated: joint springs alone are implicit, and the geometry of a step is that which the
///   velocities foretell (lanes/README.md).
/// @param rho_infinity  of generalized-alpha [1]
constexpr SchemeClaims claims_of(Scheme scheme, double rho_infinity) {
  switch (scheme) {
    case Scheme::LinearlyImplicitEuler: return {1, EnergyBehaviour::Loses, false, false, true};
    case Scheme::LinearlyImplicitMidpoint: return {2, EnergyBehaviour::Wanders, true, false, true};
    case Scheme::GeneralizedAlpha: {
      const bool damps = rho_infinity < 1.0;  // else it is the trapezoidal rule
      return {2, damps ? EnergyBehaviour::Loses : EnergyBehaviour::Wanders, false, !damps, false};
    }
    case Scheme::EnergyMomentum: return {2, EnergyBehaviour::Conserves, true, true, false};
    case Scheme::ArticulatedEuler: return {1, EnergyBehaviour::Loses, false, false, true};
    case Scheme::ArticulatedMidpoint: return {2, EnergyBehaviour::Wanders, false, false, true};
  }
  return {};
}

/// How a scheme ties the motion x of a segment (or the angle of a joint) in a step h to its
/// velocity v and acceleration a, all at the step's end:
///   v = velocity dx/h + velocity_v v0 + velocity_a h a0,
///   a = acceleration dx/h^2 + acceleration_v v0/h + acceleration_a a0;
/// and to the acceleration with which the segment resists,
///   resisting = (a + weight_a a0 - weight_r r0) scale, r0 the one before.
struct StepRule {
  bool midpoint = false;  ///< forces act at the midpoint, and a is the mean over the step
  bool conserves =
      true;  ///< moments change the angular momentum; else Euler's equations at the end
  double velocity = 1.0, velocity_v = 0.0, velocity_a = 0.0;
  double acceleration = 1.0, acceleration_v = -1.0, acceleration_a = 0.0;
  double scale = 1.0, weight_a = 0.0, weight_r = 0.0;
  /// Fraction of the forces at the end in the work of a step; the rest is that of its begin.
  double end_work = 1.0;
};

/// Euler: v = dx/h, a = (v - v0)/h. Midpoint: v = 2 dx/h - v0, a = (v - v0)/h.
/// Generalized-alpha: alpha_m = (2 rho - 1)/(rho + 1), alpha_f = rho/(rho + 1),
/// gamma = 1/2 - alpha_m + alpha_f, beta = (gamma + 1/2)^2/4; Newmark's v and a, and
/// (1 - alpha_m) a + alpha_m a0 = (1 - alpha_f) r + alpha_f r0.
constexpr StepRule step_rule(Scheme scheme, double rho_infinity) {
  StepRule rule;
  switch (scheme) {
    case Scheme::LinearlyImplicitEuler:
    case Scheme::ArticulatedEuler:  // its kernels know its rule; this one is of its start
    case Scheme::ArticulatedMidpoint: break;
    case Scheme::LinearlyImplicitMidpoint:
    case Scheme::EnergyMomentum:
      rule.midpoint = true;
      rule.velocity = 2.0;
      rule.velocity_v = -1.0;
      rule.acceleration = 2.0;
      rule.acceleration_v = -2.0;
      break;
    case Scheme::GeneralizedAlpha: {
      const double alpha_m = (2.0 * rho_infinity - 1.0) / (rho_infinity + 1.0);
      const double alpha_f = rho_infinity / (rho_infinity + 1.0);
      const double gamma = 0.5 - alpha_m + alpha_f;
      const double beta = 0.25 * (gamma + 0.5) * (gamma + 0.5);
      rule.conserves = false;
      rule.velocity = gamma / beta;
      rule.velocity_v = 1.0 - gamma / beta;
      rule.velocity_a = 1.0 - 0.5 * gamma / beta;
      rule.acceleration = 1.0 / beta;
      rule.acceleration_v = -1.0 / beta;
      rule.acceleration_a = 1.0 - 0.5 / beta;
      rule.scale = (1.0 - alpha_m) / (1.0 - alpha_f);
      rule.weight_a = alpha_m / (1.0 - alpha_m);
      rule.weight_r = alpha_f / (1.0 - alpha_m);
      rule.end_work = 0.5;
      break;
    }
  }
  return rule;
}

/// A rule for steps of one length h, as `StepRule` has it.
struct StepFactors {
  StepFactors() = default;
  StepFactors(const StepRule& rule, double h)
      : midpoint(rule.midpoint),
        conserves(rule.conserves),
        remembers(rule.velocity_a != 0.0 || rule.acceleration_a != 0.0 || rule.weight_a != 0.0 ||
                  rule.weight_r != 0.0),
        rate(1.0 / h),
        velocity(rule.velocity / h),
        velocity_v(rule.velocity_v),
        velocity_a(rule.velocity_a * h),
        acceleration(rule.acceleration / (h * h)),
        acceleration_v(rule.acceleration_v / h),
        acceleration_a(rule.acceleration_a),
        scale(rule.scale),
        weight_a(rule.weight_a),
        weight_r(rule.weight_r),
        resisting(rule.scale * rule.acceleration / (h * h)) {}

  bool midpoint = false;
  bool conserves = true;
  bool remembers = false;  ///< whether accelerations before the step count
  double rate = 0.0;       ///< 1/h [1/s]
  double velocity = 0.0, velocity_v = 0.0, velocity_a = 0.0;
  double acceleration = 0.0, acceleration_v = 0.0, acceleration_a = 0.0;
  double scale = 1.0, weight_a = 0.0, weight_r = 0.0;
  double resisting = 0.0;  ///< of the acceleration with which a segment resists, per motion [1/s^2]
};

}  // namespace plastica::solve
