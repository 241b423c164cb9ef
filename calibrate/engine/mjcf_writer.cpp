#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "calibrate/engine/engine_notes.hpp"
#include "calibrate/engine/writers.hpp"
#include "plastica/model/section_kind.hpp"

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
    "  damping = timestep x stiffness: MuJoCo's Euler takes springs explicitly and damping\n"
    "  implicitly, and so both together are a linearly implicit step, stable however stiff a "
    "joint\n"
    "  is. It is numerical: change it together with the timestep.\n"
    "  A support off the start is a body of its own, joined to the beam as the support holds it "
    "and\n"
    "  welded to the world; as it stands still its mass does not matter.\n";

std::string of_vector(const std::array<double, 3>& v) { return exact(v, " "); }

std::string of_quaternion(const EngineAxes& axes) {
  return fmt::format("{}", fmt::join(quaternion(axes), " "));
}

std::string attribute_text(std::string_view text) {
  std::string safe(text);
  for (char& c : safe) {
    if (c == '"' || c == '<' || c == '>' || c == '&') c = '_';
  }
  return safe;
}

EngineAxes world_axes() { return {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}; }

class MjcfWriter {
 public:
  explicit MjcfWriter(const EngineBeam& beam) : beam_(beam), time_step_(mjcf_time_step(beam)) {}

  std::string write() {
    text_ = fmt::format("<mujoco model=\"{}\">\n<!--\n", attribute_text(one_line(beam_.name)));
    text_ += comment(beam_, " ");
    text_ += kMjcfRemarks;
    text_ += "-->\n  <compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n";
    text_ += fmt::format("  <option timestep=\"{}\" integrator=\"Euler\" gravity=\"{}\"/>\n",
                         time_step_, of_vector(beam_.gravity));
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
    return fmt::format("{}_{}", joint.name, "xyz"[axis]);
  }

  void add_numbers() {
    std::string numbers;
    const auto add = [&](const std::string& name, std::string_view what, double value) {
      numbers += fmt::format("    <numeric name=\"{}_{}\" data=\"{}\"/>\n", name, what, value);
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
    text_ += fmt::format("<body name=\"segment_{}\" pos=\"{}\" quat=\"{}\">\n", i + 1,
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
      text_ += fmt::format(
          "{}  <joint name=\"{}\" type=\"hinge\" axis=\"{}\" stiffness=\"{}\" damping=\"{}\"/>\n",
          indent, hinge_name(joint, k), of_vector(seen_from(axes, joint.axes[k])),
          joint.stiffness[k], time_step_ * joint.stiffness[k]);
    }
    if (joint.off_start) add_slides(joint, axes, indent);
  }

  void add_slides(const EngineJoint& joint, const EngineAxes& axes, std::string_view indent) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (joint.holds[k]) continue;
      text_ += fmt::format("{}  <joint name=\"{}_move_{}\" type=\"slide\" axis=\"{}\"/>\n", indent,
                           joint.name, "xyz"[k], of_vector(seen_from(axes, world_axes()[k])));
    }
  }

  void add_mass(const EngineSegment& segment) {
    const SectionProperties& p = beam_.regions[segment.region].properties;
    const auto at = [&](std::array<double, 3> point) {
      for (std::size_t k = 0; k < 3; ++k) point[k] -= segment.start[k];
      return of_vector(seen_from(segment.axes, point));
    };
    text_ += fmt::format("  <inertial pos=\"{}\" mass=\"{}\" diaginertia=\"{}\"/>\n",
                         at(segment.center()), segment.mass, of_vector(segment.inertia));
    const bool round = section_kind(beam_.regions[segment.region].section).round();
    const std::string size = round ? fmt::format("{} {}", p.outer_distance_x, 0.5 * segment.length)
                                   : fmt::format("{} {} {}", p.outer_distance_y, p.outer_distance_x,
                                                 0.5 * segment.length);
    text_ += fmt::format(
        "  <geom type=\"{}\" pos=\"{}\" size=\"{}\" contype=\"0\" conaffinity=\"0\"/>\n",
        round ? "cylinder" : "box", at(segment.point(0.5)), size);
  }

  void add_support(const EngineJoint& support, const EngineSegment& segment) {
    std::array<double, 3> offset = support.point;
    for (std::size_t k = 0; k < 3; ++k) offset[k] -= segment.start[k];
    text_ += fmt::format("  <body name=\"{}\" pos=\"{}\">\n", support.name,
                         of_vector(seen_from(segment.axes, offset)));
    add_freedoms(support, segment.axes, "  ");
    text_ +=
        fmt::format("    <inertial pos=\"0 0 0\" mass=\"{}\" diaginertia=\"{}\"/>\n  </body>\n",
                    segment.mass, of_vector(segment.inertia));
  }

  void add_welds() {
    std::string welds;
    for (const EngineJoint& joint : beam_.joints) {
      if (!joint.off_start) continue;
      welds +=
          fmt::format("    <weld body1=\"{}\" solref=\"{} 1\" solimp=\"0.9999 0.9999 0.001\"/>\n",
                      joint.name, 2.0 * time_step_);
    }
    if (!welds.empty()) text_ += "  <equality>\n" + welds + "  </equality>\n";
  }

  const EngineBeam& beam_;
  double time_step_;
  std::string text_;
};

}  // namespace

double mjcf_time_step(const EngineBeam& beam, std::string* limiting) {
  double step = beam.time_step;
  const bool welds = std::any_of(beam.joints.begin(), beam.joints.end(),
                                 [](const EngineJoint& joint) { return joint.off_start; });
  if (!welds) return step;
  for (const EngineJoint& joint : beam.joints) {
    for (const std::size_t segment : {joint.child, joint.parent.value_or(joint.child)}) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (joint.stiffness[k] == 0.0) continue;
        const double own = 0.1 * std::sqrt(beam.segments[segment].inertia[k] / joint.stiffness[k]);
        if (own >= step) continue;
        step = own;
        if (limiting != nullptr) *limiting = fmt::format("{} about {}", joint.name, "xyz"[k]);
      }
    }
  }
  return step;
}

std::string mjcf_text(const EngineBeam& beam) { return MjcfWriter(beam).write(); }

}  // namespace plastica::calibrate
