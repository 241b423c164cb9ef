#pragma once

#include <cstddef>

#include "calibrate/engine/engine_beam.hpp"

/// What MuJoCo is given of a beam besides its segments and stiffness.
namespace plastica::calibrate {

/// How many segments MuJoCo 2 reads: its reader of XML (tinyxml2) takes 100 elements inside of each
/// other, and each segment is inside of the last.
inline constexpr std::size_t kMujocoSegments = 96;

/// The damping of a joint over its stiffness [s]: the beam's. What nothing damps would ring for
/// ever at its highest frequencies; where the beam says nothing, a tenth of a step calms these and
/// leaves those that the step resolves.
double mujoco_damping_time(const EngineBeam& beam);

/// The armature of a joint over step times stiffness [s]. Half the step keeps springs stable; the
/// constraint solver, which does not know that damping is implicit, needs as much inertia as that
/// adds.
double mujoco_armature_time(const EngineBeam& beam);

/// The damping of a hinge [N m s/rad].
/// @param axis  0 … 2: about x, y, z of the joint
double mujoco_damping(const EngineBeam& beam, const EngineJoint& joint, std::size_t axis);

/// Its armature [kg m^2]: inertia that MuJoCo adds to the turning of this joint alone.
double mujoco_armature(const EngineBeam& beam, const EngineJoint& joint, std::size_t axis);

}  // namespace plastica::calibrate
