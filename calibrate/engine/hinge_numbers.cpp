#include "calibrate/engine/hinge_numbers.hpp"

#include <algorithm>

namespace plastica::calibrate {

double mujoco_damping_time(const EngineBeam& beam) {
  return beam.damping_time.value_or(0.1 * beam.time_step);
}

double mujoco_armature_time(const EngineBeam& beam) {
  return std::max(0.5 * beam.time_step, mujoco_damping_time(beam));
}

HingeNumbers hinge_numbers(HingeEngine engine, const EngineBeam& beam, const EngineJoint& joint,
                           std::size_t axis) {
  const double stiffness = joint.stiffness[axis];
  if (engine != HingeEngine::Mujoco) {
    const double fraction = engine == HingeEngine::Chrono ? kChronoDampingFraction : 1.0;
    return {stiffness, fraction * beam.damping_time.value_or(0.0) * stiffness, 0.0};
  }
  return {stiffness, mujoco_damping_time(beam) * stiffness,
          mujoco_armature_time(beam) * beam.time_step * stiffness};
}

}  // namespace plastica::calibrate
