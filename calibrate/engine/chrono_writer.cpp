#include <cmath>

#include <fmt/format.h>

#include "calibrate/engine/engine_notes.hpp"
#include "calibrate/engine/writers.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::string_view kChronoRemarks = R"(//
// Project Chrono 9: a joint is a ChLinkMateGeneric, which holds what is rigid, and beside it a
// ChLoadBodyBodyBushingMate with the springs about x, y and z. Both are elastic: Chrono has no
// rotational bushing that yields or breaks; the yield moments, hardened stiffnesses and break angles
// of kJoints are for a callback of yours. Bushings are forces: take an implicit timestepper (HHT,
// Euler implicit) and a direct sparse solver, as for finite elements.
//
//   auto bodies = plastica_beam::Build(system, ground);

#pragma once

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
  bool held[3];     // translations
  int rotation[3];   // 0 free, 1 sprung, 2 rigid
  double tributary_length;
  double stiffness[3], hardened_stiffness[3], yield_moment[3], break_angle[3];
};

constexpr double inf = std::numeric_limits<double>::infinity();  // never

)";

constexpr std::string_view kChronoCode = R"(};

inline chrono::ChVector3d Vector(const double (&v)[3]) { return {v[0], v[1], v[2]}; }
inline chrono::ChQuaterniond Rotation(const double (&q)[4]) { return {q[0], q[1], q[2], q[3]}; }

/// Adds the beam to a system; gives its bodies.
/// @param ground  a fixed body of the system
inline std::vector<std::shared_ptr<chrono::ChBody>> Build(
    chrono::ChSystem& system, const std::shared_ptr<chrono::ChBody>& ground) {
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
        joint.held[0], joint.held[1], joint.held[2], joint.rotation[0] == 2, joint.rotation[1] == 2,
        joint.rotation[2] == 2);
    mate->Initialize(child, parent, frame);
    system.AddLink(mate);
    const chrono::ChVector3d none(0, 0, 0);
    springs->Add(chrono_types::make_shared<chrono::ChLoadBodyBodyBushingMate>(
        child, parent, frame, none, none, Vector(joint.stiffness), none));
  }
  return bodies;
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

std::string joint_row(const EngineJoint& joint) {
  std::array<int, 3> rotation{};
  for (std::size_t k = 0; k < 3; ++k) rotation[k] = static_cast<int>(joint.rotation[k]);
  return written(
      "    {{\"{}\", {}, {}, {}, {}, {},\n     {{{}}}, {{{}}}, {}, {},\n     {}, {}, {}}},\n",
      joint.name, joint.parent ? static_cast<long>(*joint.parent) : -1L, joint.child,
      joint.half_joint, braced(joint.point), braced_rotation(joint.axes),
      fmt::join(joint.holds, ", "), fmt::join(rotation, ", "), joint.length,
      braced(joint.stiffness), braced(joint.hardened_stiffness), braced(joint.yield_moment),
      braced(joint.break_angle));
}

}  // namespace

std::string chrono_text(const EngineBeam& beam) {
  std::string text = comment(beam, "//");
  text += kChronoRemarks;
  text += "const double kGravity[3] = " + braced(beam.gravity) + ";\n\n";
  text += "const Segment kSegments[] = {\n";
  for (const EngineSegment& segment : beam.segments) text += chrono_row(segment);
  text += "};\n\nconst Joint kJoints[] = {\n";
  for (const EngineJoint& joint : beam.joints) text += joint_row(joint);
  text += kChronoCode;
  return text;
}

}  // namespace plastica::calibrate
