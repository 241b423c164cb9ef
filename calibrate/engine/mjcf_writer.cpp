#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "calibrate/engine/engine_notes.hpp"
#include "calibrate/engine/hinge_numbers.hpp"
#include "calibrate/engine/writers.hpp"
#include "plastica/model/section_kind.hpp"
#include "plastica/report/xml_text.hpp"

namespace plastica::calibrate {
namespace {

/// What MuJoCo makes of the numbers, behind the comment that all formats have.
constexpr std::string_view kMjcfRemarks =
    "\n  MuJoCo: a joint is three hinges about x, y and z, in a row at one place. Its springs "
    "stay\n"
    "  elastic: MuJoCo has no joint that yields (frictionloss sits beside a spring, not in a row\n"
    "  with it) or breaks. The numeric elements NAME_yield_moment, NAME_hardened_stiffness and\n"
    "  NAME_break_angle belong to the hinge NAME, for a controller of yours; what has no such\n"
    "  element never yields or breaks.\n"
    "  MuJoCo's Euler takes springs explicitly, stable up to a step of 2 sqrt(inertia/stiffness).\n"
    "  armature = a x timestep x stiffness, with a the longer of timestep/2 and the damping time\n"
    "  (damping/stiffness), is inertia enough for the timestep, however stiff a joint is; it slows "
    "a\n"
    "  motion of frequency w by w^2 x a x timestep/2 at most. Change it together with the "
    "timestep.\n"
    "  A support off the start is a body of its own, joined to the beam as the support holds it "
    "and\n"
    "  welded to the world; as it stands still its mass does not matter.\n";

std::string of_vector(const std::array<double, 3>& v) { return digits(v, " "); }

std::string of_quaternion(const EngineAxes& axes) { return digits(quaternion(axes), " "); }

EngineAxes world_axes() { return {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}; }

/// Two geometries touch where the contype of one meets the conaffinity of the other; 1 and 1 are
/// MuJoCo's defaults.
std::string_view contact_flags(EngineContacts contacts) {
  switch (contacts) {
    case EngineContacts::None: break;
    case EngineContacts::Others: return "contype=\"2\" conaffinity=\"1\"";
    case EngineContacts::All: return "contype=\"1\" conaffinity=\"1\"";
  }
  return "contype=\"0\" conaffinity=\"0\"";
}

class MjcfWriter {
 public:
  explicit MjcfWriter(const EngineBeam& beam) : beam_(beam) {}

  std::string write() {
    text_ = written("<mujoco model=\"{}\">\n<!--\n", plastica::report::xml_text(beam_.name));
    text_ += comment(beam_, " ");
    text_ += kMjcfRemarks;
    text_ += "-->\n  <compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n";
    text_ += written("  <option timestep=\"{}\" integrator=\"Euler\" gravity=\"{}\"/>\n",
                     beam_.time_step, of_vector(beam_.gravity));
    add_numbers();
    text_ += "  <worldbody>\n";
    for (std::size_t i = 0; i < beam_.segments.size(); ++i) begin_segment(i);
    for (std::size_t i = beam_.segments.size(); i-- > 0;) text_ += "</body>";
    text_ += "\n  </worldbody>\n";
    add_welds();
    return text_ + "</mujoco>\n";
  }

 private:
  static std::string hinge_name(const EngineJoint& joint, std::size_t axis) {
    return written("{}_{}", joint.name, "xyz"[axis]);
  }

  void add_numbers() {
    std::string numbers;
    const auto add = [&](const std::string& name, std::string_view what, double value) {
      numbers += written("    <numeric name=\"{}_{}\" data=\"{}\"/>\n", name, what, value);
    };
    for (const EngineJoint& joint : beam_.joints) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (joint.rotation[k] != JointHold::Sprung) continue;
        const std::string name = hinge_name(joint, k);
        if (std::isfinite(joint.yield_moment[k])) {
          add(name, "yield_moment", joint.yield_moment[k]);
        }
        if (joint.hardened_stiffness[k] > 0.0) {
          add(name, "hardened_stiffness", joint.hardened_stiffness[k]);
        }
        if (std::isfinite(joint.break_angle[k])) add(name, "break_angle", joint.break_angle[k]);
      }
      if (joint.length > 0.0) add(joint.name, "tributary_length", joint.length);
    }
    if (!numbers.empty()) text_ += "  <custom>\n" + numbers + "  </custom>\n";
  }

  void begin_segment(std::size_t i) {
    const EngineSegment& segment = beam_.segments[i];
    const EngineAxes before = i == 0 ? world_axes() : beam_.segments[i - 1].axes;
    std::array<double, 3> offset = segment.start;
    if (i > 0) {
      for (std::size_t k = 0; k < 3; ++k) offset[k] -= beam_.segments[i - 1].start[k];
    }
    text_ += written("<body name=\"segment_{}\" pos=\"{}\" quat=\"{}\">\n", i + 1,
                     of_vector(seen_from(before, offset)),
                     of_quaternion(seen_from(before, segment.axes)));
    const auto joint = std::find_if(beam_.joints.begin(), beam_.joints.end(),
                                    [&](const auto& j) { return !j.off_start && j.child == i; });
    if (joint == beam_.joints.end()) {
      text_ += "  <freejoint name=\"joint_0_free\"/>\n";
    } else {
      add_freedoms(*joint, segment.axes, "");
    }
    add_mass(segment);
    for (const EngineJoint& support : beam_.joints) {
      if (support.off_start && support.child == i) add_support(support, segment);
    }
  }

  /// The freedoms that a joint leaves, as joints of a body at its place. What comes first carries
  /// the others, so shifts along the world's axes stand on the side of the ground.
  /// @param axes  of the body
  void add_freedoms(const EngineJoint& joint, const EngineAxes& axes, std::string_view indent) {
    if (!joint.off_start) add_slides(joint, axes, indent);
    for (std::size_t k = 0; k < 3; ++k) {
      if (joint.rotation[k] == JointHold::Rigid) continue;
      const HingeNumbers hinge = hinge_numbers(HingeEngine::Mujoco, beam_, joint, k);
      text_ += written(
          "{}  <joint name=\"{}\" type=\"hinge\" axis=\"{}\" stiffness=\"{}\" damping=\"{}\" "
          "armature=\"{}\"/>\n",
          indent, hinge_name(joint, k), of_vector(seen_from(axes, joint.axes[k])), hinge.stiffness,
          hinge.damping, hinge.armature);
    }
    if (joint.off_start) add_slides(joint, axes, indent);
  }

  void add_slides(const EngineJoint& joint, const EngineAxes& axes, std::string_view indent) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (joint.holds[k]) continue;
      text_ += written("{}  <joint name=\"{}_move_{}\" type=\"slide\" axis=\"{}\"/>\n", indent,
                       joint.name, "xyz"[k], of_vector(seen_from(axes, beam_.scene_axes[k])));
    }
  }

  void add_mass(const EngineSegment& segment) {
    const SectionProperties& p = beam_.regions[segment.region].properties;
    const auto at = [&](std::array<double, 3> point) {
      for (std::size_t k = 0; k < 3; ++k) point[k] -= segment.start[k];
      return of_vector(seen_from(segment.axes, point));
    };
    text_ += written("  <inertial pos=\"{}\" mass=\"{}\" diaginertia=\"{}\"/>\n",
                     at(segment.center()), segment.mass, of_vector(segment.inertia));
    const bool round = section_kind(beam_.regions[segment.region].section).round();
    const std::string size =
        round ? written("{} {}", p.outer_distance_x, 0.5 * segment.length)
              : written("{} {} {}", p.outer_distance_y, p.outer_distance_x, 0.5 * segment.length);
    text_ +=
        written("  <geom type=\"{}\" pos=\"{}\" size=\"{}\" {}/>\n", round ? "cylinder" : "box",
                at(segment.point(0.5)), size, contact_flags(beam_.contacts));
  }

  void add_support(const EngineJoint& support, const EngineSegment& segment) {
    std::array<double, 3> offset = support.point;
    for (std::size_t k = 0; k < 3; ++k) offset[k] -= segment.start[k];
    text_ += written("  <body name=\"{}\" pos=\"{}\">\n", support.name,
                     of_vector(seen_from(segment.axes, offset)));
    add_freedoms(support, segment.axes, "  ");
    text_ += written("    <inertial pos=\"0 0 0\" mass=\"{}\" diaginertia=\"{}\"/>\n  </body>\n",
                     segment.mass, of_vector(segment.inertia));
  }

  void add_welds() {
    std::string welds;
    for (const EngineJoint& joint : beam_.joints) {
      if (!joint.off_start) continue;
      welds += written("    <weld body1=\"{}\" solref=\"{} 1\" solimp=\"0.9999 0.9999 0.001\"/>\n",
                       joint.name, 2.0 * beam_.time_step);
    }
    if (!welds.empty()) text_ += "  <equality>\n" + welds + "  </equality>\n";
  }

  const EngineBeam& beam_;
  std::string text_;
};

}  // namespace

std::string mjcf_step_note(const EngineBeam& beam) {
  const std::string damping =
      beam.damping_time
          ? fmt::format("{:.3g} s times its stiffness", *beam.damping_time)
          : fmt::format("{:.3g} s times its stiffness, a tenth of the step, which is numerical",
                        mujoco_damping_time(beam));
  return fmt::format(
      "the step is {:.3g} s, {}; each joint's armature, {:.3g} s times the step and its "
      "stiffness, keeps it stable. The damping of a joint is {}",
      beam.time_step, beam.time_step_of, mujoco_armature_time(beam), damping);
}

std::string mjcf_text(const EngineBeam& beam) { return MjcfWriter(beam).write(); }

}  // namespace plastica::calibrate
