#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calibrate/engine/engine_notes.hpp"
#include "calibrate/engine/hinge_numbers.hpp"
#include "calibrate/engine/writers.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::string_view kBulletRemarks = R"(//
// Bullet 3: a btMultiBody on a fixed base. A joint is a row of hinges about its x, y and z at one
// place, a link each; the last one carries the segment, the others have no mass. Bullet's joints
// have no springs: AddSprings sets their torques, before each step. They are elastic; the yield
// moments, hardened stiffnesses and break angles of kLinks are for a program of yours. Bullet's step
// is explicit (v += h a, q += h v): springs are stable up to a step of 2/w, w the highest frequency
// of the chain. Compile with BT_USE_DOUBLE_PRECISION, and link the libraries that belong to it: in
// single precision the highest frequencies are lost in rounding.
//
//   btMultiBody* beam = plastica_beam::Build(world);
//   for (;;) {
//     plastica_beam::AddSprings(*beam);
//     world.stepSimulation(plastica_beam::kTimeStep, 0);
//   }

#pragma once

#include <limits>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

namespace plastica_beam {

struct Segment {
  double mass, inertia[3];  // about its center, in its axes
  double turn[4];           // w, x, y, z: from the axes before to its own
  double offset[3];         // of its inner end from the center before, in the axes before
  double center[3];         // of mass from its inner end, in its axes
};

enum Kind { kFixed, kSlide, kHinge };

struct Link {
  const char* joint;
  int segment;
  Kind kind;
  int about;       // 0, 1, 2: x, y, z of the joint
  double axis[3];  // in the axes of the segment
  double stiffness, damping, hardened_stiffness, yield_moment, break_angle;
};

constexpr double inf = std::numeric_limits<double>::infinity();  // never

)";

constexpr std::string_view kBulletCode = R"(};

constexpr int kNumberOfLinks = sizeof(kLinks) / sizeof(kLinks[0]);
constexpr double kStill[3] = {0, 0, 0};

inline btVector3 Vector(const double (&v)[3]) {
  return btVector3(btScalar(v[0]), btScalar(v[1]), btScalar(v[2]));
}

/// Adds the beam to a world, and sets its gravity. The beam is the caller's to delete, after
/// world.removeMultiBody.
inline btMultiBody* Build(btMultiBodyDynamicsWorld& world) {
  const btVector3 none(0, 0, 0);
  btMultiBody* beam = new btMultiBody(kNumberOfLinks, 0, none, true, false);
  for (int i = 0; i < kNumberOfLinks; ++i) {
    const Link& link = kLinks[i];
    const Segment& segment = kSegments[link.segment];
    const bool first = i == 0 || kLinks[i - 1].segment != link.segment;
    const bool last = i + 1 == kNumberOfLinks || kLinks[i + 1].segment != link.segment;
    const double* q = segment.turn;
    // Bullet asks for the turn of a point's coordinates, which is the inverse.
    const btQuaternion turn = first ? btQuaternion(btScalar(-q[1]), btScalar(-q[2]),
                                                   btScalar(-q[3]), btScalar(q[0]))
                                    : btQuaternion::getIdentity();
    const btVector3 offset = first ? Vector(segment.offset) : none;
    const btVector3 center = last ? Vector(segment.center) : none;
    const btScalar mass = last ? btScalar(segment.mass) : btScalar(0);
    const btVector3 inertia = last ? Vector(segment.inertia) : none;
    if (link.kind == kHinge) {
      beam->setupRevolute(i, mass, inertia, i - 1, turn, Vector(link.axis), offset, center, true);
    } else if (link.kind == kSlide) {
      beam->setupPrismatic(i, mass, inertia, i - 1, turn, Vector(link.axis), offset, center, true);
    } else {
      beam->setupFixed(i, mass, inertia, i - 1, turn, offset, center);
    }
  }
  beam->finalizeMultiDof();
  // Bullet damps and limits what it does not need to.
  beam->setLinearDamping(0);
  beam->setAngularDamping(0);
  beam->setMaxCoordinateVelocity(BT_LARGE_FLOAT);
  world.addMultiBody(beam);
  world.setGravity(Vector(kGravity));
  return beam;
}

/// Adds the torques of springs and dampers; Bullet forgets them after each step.
/// @param turned  how far the ground of the first joint has turned about its x, y, z [rad]
inline void AddSprings(btMultiBody& beam, const double (&turned)[3] = kStill) {
  for (int i = 0; i < kNumberOfLinks; ++i) {
    const Link& link = kLinks[i];
    if (link.kind != kHinge) continue;
    const double rest = link.segment == 0 ? turned[link.about] : 0.0;
    beam.addJointTorque(i, btScalar(-link.stiffness * (beam.getJointPos(i) - rest) -
                                    link.damping * beam.getJointVel(i)));
  }
}

}  // namespace plastica_beam
)";

std::string in_braces(const std::array<double, 3>& v) { return "{" + digits(v, ", ") + "}"; }

std::array<double, 3> from_to(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

/// The joint that carries a segment. @throws InputError if nothing holds the beam
const EngineJoint& carrier_of(const EngineBeam& beam, std::size_t segment) {
  const auto joint = std::ranges::find_if(
      beam.joints, [&](const auto& one) { return !one.off_start && one.child == segment; });
  if (joint != beam.joints.end()) return *joint;
  throw InputError({}, "support", "",
                   "is missing: the beam for bullet is a multibody on a fixed base, and nothing "
                   "holds this one at its start");
}

std::string segment_row(const EngineBeam& beam, std::size_t i) {
  static constexpr EngineAxes kWorld{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  const EngineSegment& segment = beam.segments[i];
  const EngineAxes& before = i == 0 ? kWorld : beam.segments[i - 1].axes;
  const std::array<double, 3> from =
      i == 0 ? std::array<double, 3>{} : beam.segments[i - 1].center();
  return written("    {{{}, {}, {{{}}},\n     {}, {}}},\n", segment.mass,
                 in_braces(segment.inertia),
                 digits(quaternion(seen_from(before, segment.axes)), ", "),
                 in_braces(seen_from(before, from_to(from, segment.start))),
                 in_braces(seen_from(segment.axes, from_to(segment.start, segment.center()))));
}

/// A link for each freedom that a joint leaves, or one that is fixed.
std::string link_rows(const EngineBeam& beam, std::size_t i) {
  const EngineJoint& joint = carrier_of(beam, i);
  const EngineAxes& axes = beam.segments[i].axes;
  std::string rows;
  const auto add = [&](std::string_view kind, std::size_t about, const std::array<double, 3>& axis,
                       const std::string& numbers) {
    rows += written("    {{\"{}\", {}, {}, {}, {}, {}}},\n", joint.name, i, kind, about,
                    in_braces(seen_from(axes, axis)), numbers);
  };
  const std::string none = "0, 0, 0, inf, inf";
  for (std::size_t k = 0; k < 3; ++k) {
    if (!joint.holds[k]) add("kSlide", k, beam.scene_axes[k], none);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (joint.rotation[k] == JointHold::Rigid) continue;
    const HingeNumbers hinge = hinge_numbers(HingeEngine::Bullet, beam, joint, k);
    add("kHinge", k, joint.axes[k],
        written("{}, {}, {}, {}, {}", hinge.stiffness, hinge.damping, joint.hardened_stiffness[k],
                joint.yield_moment[k], joint.break_angle[k]));
  }
  if (rows.empty()) add("kFixed", 0, axes[0], none);
  return rows;
}

}  // namespace

std::string bullet_step_note(const EngineBeam& beam) {
  return fmt::format(
      "the step is {:.3g} s, {}. Bullet takes springs explicitly, and blows up at steps that are "
      "too long for them; plastica advise --for bullet finds one",
      beam.time_step, beam.time_step_of);
}

std::string bullet_text(const EngineBeam& beam) {
  for (const EngineJoint& joint : beam.joints) {
    if (!joint.off_start) continue;
    throw InputError({}, joint.name, "",
                     "is off the beam's start, where the multibody for bullet cannot be held");
  }
  std::string text = comment(beam, "//");
  text += kBulletRemarks;
  text += written("constexpr double kTimeStep = {};\n", beam.time_step);
  text += "const double kGravity[3] = " + in_braces(beam.gravity) + ";\n\n";
  text += "const Segment kSegments[] = {\n";
  for (std::size_t i = 0; i < beam.segments.size(); ++i) text += segment_row(beam, i);
  text += "};\n\nconst Link kLinks[] = {\n";
  for (std::size_t i = 0; i < beam.segments.size(); ++i) text += link_rows(beam, i);
  text += kBulletCode;
  return text;
}

}  // namespace plastica::calibrate
