#pragma once

#include <vector>

#include "plastica/model/motion.hpp"
#include "plastica/solve/newton_work.hpp"

namespace plastica::solve {

/// How a motion is to be stepped; see SolverOptions.
struct MotionOptions {
  NewtonOptions newton{};
  Scheme scheme = Scheme::GeneralizedAlpha;
  double rho_infinity = 0.8;
  Damping damping = Damping::None;
  double damping_time = 0.0;      ///< [s]
  double time_step = 1e-3;        ///< [s]; the largest one if steps are adaptive
  double step_error = 0.0;        ///< of a step, over the beam's length [1]; 0: fixed steps
  double smallest_step = 1e-6;    ///< of `time_step` [1]
  double largest_rotation = 0.2;  ///< of a joint in a step [rad]
  std::vector<double> stops{};    ///< times at which a step must end, rising; the last is the end
  std::vector<bool> recorded{};   ///< which of them are samples
  std::vector<double> restitution{};  ///< of each constraint that is one-sided [1] (constraints)
};

/// A segment may turn by no more than this in a step [rad]: Cayley's map ends at pi.
inline constexpr double kLargestStepSpin = 1.5;

/// Newton's method goes no further than this: below is the rounding of positions (see
/// MotionStep::set_force_floor).
inline constexpr double kMinTolerance = 1e-11;

/// How far a contact may be crossed when its impact is found, over the beam's length [1].
template <class S>
inline constexpr double kContactTolerance = kIsDouble<S> ? 1e-7 : 1e-5;

/// An approach that is slower than this, times the largest speed so far, is rest and does not
/// bounce [1].
inline constexpr double kRestingSpeed = 1e-3;

/// What has flowed into and out of a beam in motion [J]; each from its own formula.
/// @tparam E  double; in lanes each has its own
template <class E>
struct EnergyFlowsOf {
  E external{};
  E damping{};
  E numerical_dissipation{};
  E impact{};
  E fracture{};
};
using EnergyFlows = EnergyFlowsOf<double>;

}  // namespace plastica::solve
