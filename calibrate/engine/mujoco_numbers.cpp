#include "calibrate/engine/mujoco_numbers.hpp"

#include <algorithm>

namespace plastica::calibrate {

double mujoco_damping_time(const EngineBeam& beam) {
  return beam.damping_time.value_or(0.1 * beam.time_step);
}

double mujoco_armature_time(const EngineBeam& beam) {
  return std::max(0.5 * beam.time_step, mujoco_damping_time(beam));
}

double mujoco_damping(const EngineBeam& beam, const EngineJoint& joint, std::size_t axis) {
  return mujoco_damping_time(beam) * joint.stiffness[axis];
}

double mujoco_armature(const EngineBeam& beam, const EngineJoint& joint, std::size_t axis) {
  return mujoco_armature_time(beam) * beam.time_step * joint.stiffness[axis];
}

}  // namespace plastica::calibrate
