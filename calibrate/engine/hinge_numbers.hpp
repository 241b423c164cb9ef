#pragma once

#include <cstddef>

#include "calibrate/engine/engine_beam.hpp"

/// What engines whose coordinates are the turns of hinges are given of a beam's joints.
namespace plastica::calibrate {

/// Engines that step the coordinates of hinges.
enum class HingeEngine {
  Mujoco,  ///< its "Euler": damping implicit, armature
  Bullet,  ///< btMultiBody: springs and dampers are torques of the program, explicit
};

/// How many segments MuJoCo 2 reads: its reader of XML (tinyxml2) takes 100 elements inside of each
/// other, and each segment is inside of the last.
inline constexpr std::size_t kMujocoSegments = 96;

/// A hinge beside its place.
struct HingeNumbers {
  double stiffness = 0.0;  ///< [N m/rad]
  double damping = 0.0;    ///< [N m s/rad]
  double armature = 0.0;   ///< inertia that the engine adds to this turn alone [kg m^2]
};

/// The damping of a joint over its stiffness in MuJoCo [s]: the beam's. What nothing damps would
/// ring for ever at its highest frequencies; where the beam says nothing, a tenth of a step calms
/// these and leaves those that the step resolves.
double mujoco_damping_time(const EngineBeam& beam);

/// The armature of a joint over step times stiffness [s]. Half the step keeps springs stable; the
/// constraint solver, which does not know that damping is implicit, needs as much inertia as that
/// adds.
double mujoco_armature_time(const EngineBeam& beam);

/// A hinge in an engine. Bullet has no armature, and what the beam does not damp is not damped
/// there.
/// @param axis  0 … 2: about x, y, z of the joint
HingeNumbers hinge_numbers(HingeEngine engine, const EngineBeam& beam, const EngineJoint& joint,
                           std::size_t axis);

}  // namespace plastica::calibrate
