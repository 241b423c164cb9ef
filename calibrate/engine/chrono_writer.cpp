#include <cmath>

#include <fmt/format.h>

#include "calibrate/engine/engine_notes.hpp"
#include "calibrate/engine/hinge_numbers.hpp"
#include "calibrate/engine/writers.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::string_view kChronoRemarks = R"(//
// Project Chrono 9: a joint is a ChLinkMateGeneric, which holds what is rigid, and beside it a
// ChLoadBodyBodyBushingMate with the springs and dampers about x, y and z. Both are elastic: Chrono
// has no rotational bushing that yields or breaks; the yield moments, hardened stiffnesses and break
// angles of kJoints are for a callback of yours.
//
// The numbers are for the timestepper EULER_IMPLICIT_LINEARIZED, which is the default, with a direct
// solver. It has a bushing's damping in the forces and again in its matrix, so the damping of kJoints
// is half of the beam's; for another timestepper (HHT) give Build 2 as the last argument. Step and
// damping are from Chrono's published sources (src/chrono/timestepper/ChTimestepper.cpp, Advance of
// ChTimestepperEulerImplicitLinearized; physics/ChLoadsBody.cpp, ChLinkMate.cpp), and were not
// verified in Chrono itself.
//
//   chrono::ChSystemNSC system;
//   system.SetGravitationalAcceleration(plastica_beam::Vector(plastica_beam::kGravity));
//   system.SetTimestepperType(chrono::ChTimestepper::Type::EULER_IMPLICIT_LINEARIZED);
//   system.SetSolver(chrono_types::make_shared<chrono::ChSolverSparseLU>());
//   auto ground = chrono_types::make_shared<chrono::ChBody>();
//   ground->SetFixed(true);
//   system.AddBody(ground);
//   auto bodies = plastica_beam::Build(system, ground);
//   for (;;) system.DoStepDynamics(plastica_beam::kTimeStep);
//
// Chrono looks at forces, gravity and the ground's pose at the end of a step: after a change between
// two steps call system.ForceUpdate(), else it acts a step late.

#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <chrono/physics/ChBody.h>
#include <chrono/physics/ChLinkMate.h>
#include <chrono/physics/ChLoadContainer.h>
#include <chrono/physics/ChLoadsBody.h>
#include <chrono/physics/ChSystem.h>

namespace plastica_beam {

struct Segment {
  double length, mass;
  double inertia[3], center[3];
  double rotation[4];  // w, x, y, z
};

struct Joint {
  const char* name;
  int parent, child;  // parent -1: the ground
  bool half_joint;
  double point[3], rotation[4];
  bool held[3];          // translations
  int rotation_hold[3];  // 0 free, 1 sprung, 2 rigid
  double tributary_length;
  double stiffness[3], hardened_stiffness[3], yield_moment[3], break_angle[3];
  double damping[3];  // half of the beam's: see above
};

constexpr double inf = std::numeric_limits<double>::infinity();  // never

)";

constexpr std::string_view kChronoCode = R"(};

inline chrono::ChVector3d Vector(const double (&v)[3]) { return {v[0], v[1], v[2]}; }
inline chrono::ChQuaterniond Rotation(const double (&q)[4]) { return {q[0], q[1], q[2], q[3]}; }

/// Adds the beam to a system; gives its bodies.
/// @param ground  a fixed body of the system
/// @param damping_factor  on the damping of kJoints: 1 for EULER_IMPLICIT_LINEARIZED, 2 for others
inline std::vector<std::shared_ptr<chrono::ChBody>> Build(
    chrono::ChSystem& system, const std::shared_ptr<chrono::ChBody>& ground,
    double damping_factor = 1.0) {
  std::vector<std::shared_ptr<chrono::ChBody>> bodies;
  for (const Segment& segment : kSegments) {
    auto body = chrono_types::make_shared<chrono::ChBody>();
    body->SetMass(segment.mass);
    body->SetInertiaXX(Vector(segment.inertia));
    body->SetPos(Vector(segment.center));
    body->SetRot(Rotation(segment.rotation));
    system.AddBody(body);
    bodies.push_back(body);
  }
  auto springs = chrono_types::make_shared<chrono::ChLoadContainer>();
  system.Add(springs);
  for (const Joint& joint : kJoints) {
    const auto& child = bodies[joint.child];
    const auto& parent = joint.parent < 0 ? ground : bodies[joint.parent];
    const chrono::ChFrame<> frame(Vector(joint.point), Rotation(joint.rotation));
    auto mate = chrono_types::make_shared<chrono::ChLinkMateGeneric>(
        joint.held[0], joint.held[1], joint.held[2], joint.rotation_hold[0] == 2,
        joint.rotation_hold[1] == 2, joint.rotation_hold[2] == 2);
    mate->Initialize(child, parent, frame);
    system.AddLink(mate);
    const chrono::ChVector3d none(0, 0, 0);
    springs->Add(chrono_types::make_shared<chrono::ChLoadBodyBodyBushingMate>(
        child, parent, frame, none, none, Vector(joint.stiffness),
        Vector(joint.damping) * damping_factor));
  }
  return bodies;
}

/// Turns the ground about x, y, z of the first joint, at its place: before each step of a clamp that
/// turns. It was at the origin, not turned, when the beam was built.
/// @param turned  rotation vector [rad]
inline void TurnGround(chrono::ChSystem& system, chrono::ChBody& ground,
                       const double (&turned)[3]) {
  const chrono::ChVector3d point = Vector(kJoints[0].point);
  const chrono::ChVector3d about = Rotation(kJoints[0].rotation).Rotate(Vector(turned));
  const double angle = std::sqrt(turned[0] * turned[0] + turned[1] * turned[1] +
                                 turned[2] * turned[2]);
  const double part = angle > 0.0 ? std::sin(0.5 * angle) / angle : 0.5;
  const chrono::ChQuaterniond turn(std::cos(0.5 * angle), part * about.x(), part * about.y(),
                                   part * about.z());
  ground.SetRot(turn);
  ground.SetPos(point - turn.Rotate(point));
  system.ForceUpdate();
}

}  // namespace plastica_beam
)";

std::string braced(const std::array<double, 3>& v) { return "{" + digits(v, ", ") + "}"; }

std::string braced_rotation(const EngineAxes& axes) {
  return "{" + digits(quaternion(axes), ", ") + "}";
}

std::string chrono_row(const EngineSegment& segment) {
  return written("    {{{}, {}, {}, {}, {}}},\n", segment.length, segment.mass,
                 braced(segment.inertia), braced(segment.center()), braced_rotation(segment.axes));
}

std::string bushing_row(const EngineBeam& beam, const EngineJoint& joint) {
  std::array<int, 3> rotation{};
  std::array<double, 3> damping{};
  for (std::size_t k = 0; k < 3; ++k) {
    rotation[k] = static_cast<int>(joint.rotation[k]);
    damping[k] = hinge_numbers(HingeEngine::Chrono, beam, joint, k).damping;
  }
  return written(
      "    {{\"{}\", {}, {}, {}, {}, {},\n     {{{}}}, {{{}}}, {}, {},\n     {}, {}, {}, {}}},\n",
      joint.name, joint.parent ? static_cast<long>(*joint.parent) : -1L, joint.child,
      joint.half_joint, braced(joint.point), braced_rotation(joint.axes),
      fmt::join(joint.holds, ", "), fmt::join(rotation, ", "), joint.length,
      braced(joint.stiffness), braced(joint.hardened_stiffness), braced(joint.yield_moment),
      braced(joint.break_angle), braced(damping));
}

}  // namespace

std::string chrono_step_note(const EngineBeam& beam) {
  return fmt::format(
      "the step is {:.3g} s, {}; advice for chrono, which finds one for an error, is by Chrono's "
      "published rule and was not verified in Chrono itself",
      beam.time_step, beam.time_step_of);
}

std::string chrono_text(const EngineBeam& beam) {
  std::string text = comment(beam, "//");
  text += kChronoRemarks;
  text += written("constexpr double kTimeStep = {};\n", beam.time_step);
  text += "const double kGravity[3] = " + braced(beam.gravity) + ";\n\n";
  text += "const Segment kSegments[] = {\n";
  for (const EngineSegment& segment : beam.segments) text += chrono_row(segment);
  text += "};\n\nconst Joint kJoints[] = {\n";
  for (const EngineJoint& joint : beam.joints) text += bushing_row(beam, joint);
  text += kChronoCode;
  return text;
}

}  // namespace plastica::calibrate
