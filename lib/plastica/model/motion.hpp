#pragma once

#include <array>
#include <optional>

#include "plastica/model/place.hpp"

/// What a scene in time says of the beam's motion.
namespace plastica {

/// A rigid motion that the beam, or a part of it, has at time 0; several add up.
struct InitialMotion {
  Place from{};                      ///< the segments whose middles lie between `from` …
  Place to{1.0, {}};                 ///< … and here move
  std::array<double, 3> velocity{};  ///< in world axes [m/s]
  std::array<double, 3> spin{};      ///< about world axes through `about` [rad/s]
  Place about{0.5, {}};
};

/// A cut that is no break: the joint nearest to a place lets go at a time.
struct Cut {
  Place at{0.5, {}};
  double time = 0.0;  ///< [s], >= 0
};

/// Whether a scene is a path of equilibria or a motion.
enum class Analysis { Statics, Dynamics };

/// How a motion is stepped (solve/scheme.hpp says order, energy behaviour and reversibility).
enum class Scheme {
  LinearlyImplicitEuler,     ///< first order, one factorization a step: what real-time engines do
  LinearlyImplicitMidpoint,  ///< second order at the same cost
  GeneralizedAlpha,          ///< second order, damps what the step cannot follow by rho_infinity
  EnergyMomentum,            ///< second order, keeps momentum, angular momentum and energy
  ArticulatedEuler,     ///< first order: joint springs alone are implicit; a tenth of the cost,
                        ///< many scenarios at once; of beams held at their start alone
  ArticulatedMidpoint,  ///< second order at the same cost
};

constexpr bool is_articulated(Scheme scheme) {
  return scheme == Scheme::ArticulatedEuler || scheme == Scheme::ArticulatedMidpoint;
}

/// What damps the joints besides yielding.
enum class Damping {
  None,
  Stiffness,   ///< moment damping_time K dtheta/dt, K the elastic stiffness (Rayleigh)
  Relaxation,  ///< moment damping_time ds/dt, s the law's moment: elastic strain alone is damped,
               ///< plastic flow is not (the damping time of AGX's constraints)
};

/// Whether a segment resists bending rotation by its section's own inertia, rho I per length,
/// besides that of a thin rod.
enum class RotaryInertia { Off, On };

}  // namespace plastica
