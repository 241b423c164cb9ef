#include <cmath>

#include <fmt/format.h>

#include "calibrate/engine/engine_notes.hpp"
#include "calibrate/engine/writers.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::string_view kOpenseesRemarks = R"(#
# OpenSees: a joint is a zeroLength element between two nodes that move together (equalDOF), with a
# uniaxialMaterial about each axis: Elastic, ElasticPP (epsyP = yield moment/stiffness) or Steel01
# (b = hardened stiffness/stiffness; its hardening is kinematic), inside of MinMax where it breaks.
# MinMax counts the whole angle, so its bound is the permanent break angle and the elastic angle of
# the moment there; after a turn back and forth it counts anew what plastica adds up.
# The axes of a zeroLength element stand still: turns of a joint by more than some 0.1 rad about
# several axes are not what plastica has.
# A segment is an elasticBeamColumn $rigid times as stiff as the section, with its mass, so that the
# beam is softer by that fraction. Supports are nodes that are fixed.
)";

class TclWriter {
 public:
  explicit TclWriter(const EngineBeam& beam) : beam_(beam) {}

  std::string write() {
    text_ = comment(beam_, "#");
    text_ += kOpenseesRemarks;
    text_ += "\nwipe\nmodel BasicBuilder -ndm 3 -ndf 6\nset rigid 1e4\n";
    for (std::size_t i = 0; i < beam_.segments.size(); ++i) add_segment(i);
    for (const EngineJoint& joint : beam_.joints) add_joint(joint);
    return text_;
  }

 private:
  static std::size_t start_node(std::size_t segment) { return 2 * segment + 1; }
  static std::size_t end_node(std::size_t segment) { return 2 * segment + 2; }

  std::size_t add_node(const std::array<double, 3>& point) {
    text_ += written("node {} {}\n", next_node_, digits(point, " "));
    return next_node_++;
  }

  /// Local x runs along the segment, local z along its own x: bending about that is EI_x.
  void add_bar(const EngineSegment& segment, std::size_t from, std::size_t to, bool has_mass) {
    const EngineRegion& region = beam_.regions[segment.region];
    const SectionProperties& p = region.properties;
    ++next_element_;
    text_ +=
        written("geomTransf Corotational {} {}\n", next_element_, digits(segment.axes[0], " "));
    text_ += written(
        "element elasticBeamColumn {0} {1} {2} {3} [expr $rigid*{4}] [expr $rigid*{5}] {6} {7} {8} "
        "{0}",
        next_element_, from, to, p.area, region.material.youngs_modulus,
        resolved_shear_modulus(region.material), p.second_moment_x + p.second_moment_y,
        p.second_moment_y, p.second_moment_x);
    if (has_mass) text_ += written(" -mass {} -cMass", segment.mass / segment.length);
    text_ += '\n';
  }

  void add_segment(std::size_t i) {
    const EngineSegment& segment = beam_.segments[i];
    text_ += written("# segment_{}\n", i + 1);
    add_node(segment.start);
    add_node(segment.end);
    add_bar(segment, start_node(i), end_node(i), true);
  }

  /// The node of a segment at a support; one of its own inside of the segment.
  std::size_t node_at(const EngineJoint& joint) {
    const EngineSegment& segment = beam_.segments[joint.child];
    if (!joint.off_start) return start_node(joint.child);
    const auto near = [&](const std::array<double, 3>& end) {
      double gap = 0.0;
      for (std::size_t k = 0; k < 3; ++k) gap = std::hypot(gap, joint.point[k] - end[k]);
      return gap < 1e-9 * segment.length;
    };
    if (near(segment.end)) return end_node(joint.child);
    if (near(segment.start)) return start_node(joint.child);
    const std::size_t node = add_node(joint.point);
    add_bar(segment, start_node(joint.child), node, false);
    return node;
  }

  void add_joint(const EngineJoint& joint) {
    text_ +=
        written("# {}{}\n", joint.name, joint.half_joint ? ", a half joint to the ground" : "");
    const std::size_t child = node_at(joint);
    const std::size_t parent = joint.parent ? end_node(*joint.parent) : add_ground(joint);
    if (joint.parent) {
      text_ += written("equalDOF {} {} 1 2 3\n", parent, child);
    } else {
      fix(joint, child);
    }
    std::string materials;
    std::string directions;
    for (std::size_t k = 0; k < 3; ++k) {
      if (joint.rotation[k] != JointHold::Sprung) continue;
      materials += written(" {}", add_material(joint, k));
      directions += written(" {}", 4 + k);
    }
    if (materials.empty()) return;
    text_ += written("element zeroLength {} {} {} -mat{} -dir{} -orient {} {}\n", ++next_element_,
                     parent, child, materials, directions, digits(joint.axes[0], " "),
                     digits(joint.axes[1], " "));
  }

  std::size_t add_ground(const EngineJoint& joint) {
    const std::size_t node = add_node(joint.point);
    text_ += written("fix {} 1 1 1 1 1 1\n", node);
    return node;
  }

  /// What the ground holds rigidly.
  void fix(const EngineJoint& joint, std::size_t node) {
    std::string flags;
    for (const bool holds : joint.holds) flags += holds ? " 1" : " 0";
    for (const JointHold rotation : joint.rotation) {
      flags += rotation == JointHold::Rigid ? " 1" : " 0";
    }
    if (flags.find('1') != std::string::npos) text_ += written("fix {}{}\n", node, flags);
  }

  /// @return the tag of the material
  std::size_t add_material(const EngineJoint& joint, std::size_t k) {
    const double stiffness = joint.stiffness[k];
    const double moment = joint.yield_moment[k];
    const double hardened = joint.hardened_stiffness[k];
    const std::size_t law = ++next_material_;
    if (!std::isfinite(moment)) {
      text_ += written("uniaxialMaterial Elastic {} {}\n", law, stiffness);
      return law;
    }
    if (hardened > 0.0) {
      text_ += written("uniaxialMaterial Steel01 {} {} {} {}\n", law, moment, stiffness,
                       hardened / stiffness);
    } else {
      text_ += written("uniaxialMaterial ElasticPP {} {} {}\n", law, stiffness, moment / stiffness);
    }
    const double permanent = joint.break_angle[k];
    if (!std::isfinite(permanent)) return law;
    // The moment has grown by H theta_p, with the hardened stiffness k H/(k + H).
    const double slope = hardened > 0.0 ? stiffness * hardened / (stiffness - hardened) : 0.0;
    const double whole = permanent + (moment + slope * permanent) / stiffness;
    text_ += written("uniaxialMaterial MinMax {} {} -min {} -max {}\n", ++next_material_, law,
                     -whole, whole);
    return next_material_;
  }

  const EngineBeam& beam_;
  std::string text_;
  std::size_t next_node_ = 1;
  std::size_t next_element_ = 0;
  std::size_t next_material_ = 0;
};

}  // namespace

std::string opensees_text(const EngineBeam& beam) { return TclWriter(beam).write(); }

}  // namespace plastica::calibrate
