#include <cmath>

#include <fmt/format.h>

#include "calibrate/engine/engine_notes.hpp"
#include "calibrate/engine/writers.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::string_view kAgxRemarks = R"(#
# AGX Dynamics: a joint is an agx.LockJoint whose compliance about each axis is 1/stiffness
# [rad/(N m)]; about an axis that is free its force range is nothing. A lock joint is elastic: the
# yield moments, hardened stiffnesses and break angles of JOINTS are for a listener of yours (a
# force range alone would cap the moment, and keep nothing of the rotation). AGX damps a constraint
# over its damping time [s] (`setDamping`): left at its default.
#
#   beam = build(simulation)        # segments and joints, as this module was exported

)";

constexpr std::string_view kSegmentHead =
    "# length, mass, inertia about x, y, z of the segment, center, rotation (x, y, z, w)\n"
    "SEGMENTS = [\n";

constexpr std::string_view kJointHead =
    "# name, parent (-1: the ground), child, half joint, the joint's frame in the parent and in "
    "the\n"
    "# child (point, rotation), translations held, rotation (0 free, 1 sprung, 2 rigid),\n"
    "# tributary length, stiffness, hardened stiffness, yield moment, break angle; inf: never\n"
    "JOINTS = [\n";

constexpr std::string_view kCode = R"(]

TRANSLATIONS = (agx.LockJoint.TRANSLATIONAL_1, agx.LockJoint.TRANSLATIONAL_2,
                agx.LockJoint.TRANSLATIONAL_3)
ROTATIONS = (agx.LockJoint.ROTATIONAL_1, agx.LockJoint.ROTATIONAL_2, agx.LockJoint.ROTATIONAL_3)


def frame_of(point, rotation):
    frame = agx.Frame()
    frame.setLocalTranslate(agx.Vec3(*point))
    frame.setLocalRotate(agx.Quat(*rotation))
    return frame


def build(simulation):
    """Adds the beam to a simulation; gives its bodies and, by name, its joints.

    The simulation's gravity is not touched: the scene's is GRAVITY."""
    bodies = []
    for length, mass, inertia, center, rotation in SEGMENTS:
        body = agx.RigidBody()
        body.getMassProperties().setMass(mass)
        body.getMassProperties().setInertiaTensor(agx.Vec3(*inertia))
        body.setPosition(agx.Vec3(*center))
        body.setRotation(agx.Quat(*rotation))
        simulation.add(body)
        bodies.append(body)
    joints = {}
    for (name, parent, child, half, in_parent, in_child, held, rotation, length, stiffness,
         hardened, yield_moment, break_angle) in JOINTS:
        if parent < 0:
            joint = agx.LockJoint(bodies[child], frame_of(*in_child))
        else:
            joint = agx.LockJoint(bodies[child], frame_of(*in_child), bodies[parent],
                                  frame_of(*in_parent))
        for k in range(3):
            if not held[k]:
                joint.setForceRange(agx.RangeReal(0.0, 0.0), TRANSLATIONS[k])
            if rotation[k] == 0:
                joint.setForceRange(agx.RangeReal(0.0, 0.0), ROTATIONS[k])
            elif rotation[k] == 1:
                joint.setCompliance(1.0 / stiffness[k], ROTATIONS[k])
        simulation.add(joint)
        joints[name] = joint
    return bodies, joints
)";

std::string triple(const std::array<double, 3>& v) { return "(" + digits(v, ", ") + ")"; }

std::string rotation(const EngineAxes& axes) {
  const auto q = quaternion(axes);
  return "(" + digits(std::array{q[1], q[2], q[3], q[0]}, ", ") + ")";
}

std::string segment_row(const EngineSegment& segment) {
  return written("    ({}, {}, {}, {}, {}),\n", segment.length, segment.mass,
                 triple(segment.inertia), triple(segment.center()), rotation(segment.axes));
}

/// The joint's frame as a body sees it, whose origin is its center.
std::string frame_in(const EngineSegment& body, const EngineJoint& joint) {
  std::array<double, 3> offset = joint.point;
  for (std::size_t k = 0; k < 3; ++k) offset[k] -= body.center()[k];
  return written("({}, {})", triple(seen_from(body.axes, offset)),
                 rotation(seen_from(body.axes, joint.axes)));
}

std::string joint_row(const EngineBeam& beam, const EngineJoint& joint) {
  std::array<int, 3> held{};
  std::array<int, 3> rotates{};
  for (std::size_t k = 0; k < 3; ++k) {
    held[k] = joint.holds[k] ? 1 : 0;
    rotates[k] = static_cast<int>(joint.rotation[k]);
  }
  const std::string in_parent =
      joint.parent ? frame_in(beam.segments[*joint.parent], joint)
                   : written("({}, {})", triple(joint.point), rotation(joint.axes));
  return written(
      "    (\"{}\", {}, {}, {},\n     {},\n     {},\n     ({}), ({}), {}, {},\n     {}, {}, "
      "{}),\n",
      joint.name, joint.parent ? static_cast<long>(*joint.parent) : -1L, joint.child,
      joint.half_joint ? 1 : 0, in_parent, frame_in(beam.segments[joint.child], joint),
      fmt::join(held, ", "), fmt::join(rotates, ", "), joint.length, triple(joint.stiffness),
      triple(joint.hardened_stiffness), triple(joint.yield_moment), triple(joint.break_angle));
}

}  // namespace

std::string agx_text(const EngineBeam& beam) {
  std::string text = comment(beam, "#");
  text += kAgxRemarks;
  text += "import agx\n\ninf = float(\"inf\")\n";
  text += "GRAVITY = " + triple(beam.gravity) + '\n';
  text += kSegmentHead;
  for (const EngineSegment& segment : beam.segments) text += segment_row(segment);
  text += "]\n";
  text += kJointHead;
  for (const EngineJoint& joint : beam.joints) text += joint_row(beam, joint);
  text += kCode;
  return text;
}

}  // namespace plastica::calibrate
