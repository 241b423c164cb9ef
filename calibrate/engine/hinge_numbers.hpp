#pragma once

#include <cstddef>

#include "calibrate/engine/engine_beam.hpp"

/// What engines are given of a beam's joints.
namespace plastica::calibrate {

/// Engines whose joints turn about three axes, with a spring and a damper about each.
enum class HingeEngine {
  Mujoco,  ///< its "Euler": damping implicit, armature
  Bullet,  ///< btMultiBody: springs and dampers are torques of the program, explicit
  Chrono,  ///< bushings between free bodies, by EULER_IMPLICIT_LINEARIZED: implicit
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

/// What of a joint's damping a bushing of Chrono gets: EULER_IMPLICIT_LINEARIZED has it in the
/// forces of the present velocity, and again in the matrix of the new one.
inline constexpr double kChronoDampingFraction = 0.5;

/// A hinge in an engine. Bullet and Chrono have no armature, and what the beam does not damp is not
/// damped there.
/// @param axis  0 … 2: about x, y, z of the joint
HingeNumbers hinge_numbers(HingeEngine engine, const EngineBeam& beam, const EngineJoint& joint,
                           std::size_t axis);

}  // namespace plastica::calibrate
