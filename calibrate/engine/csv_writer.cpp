#include <cmath>

#include <fmt/format.h>

#include "calibrate/engine/engine_notes.hpp"
#include "calibrate/engine/writers.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::array<std::string_view, 3> kRotation{"free", "sprung", "rigid"};

/// The number of a segment as files name it, from 1; 0 is the ground.
std::size_t segment_number(const std::optional<std::size_t>& segment) {
  return segment ? *segment + 1 : 0;
}

std::string held(const std::array<bool, 3>& holds) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    if (holds[k]) text += "xyz"[k];
  }
  return text;
}

/// What a joint never reaches is an empty cell.
void add_cells(const OfJointAxes& values, std::string& row) {
  for (const double value : values) row += ',' + (std::isfinite(value) ? digits(value) : "");
}

}  // namespace

std::string csv_text(const EngineBeam& beam) {
  std::string text = comment(beam, "#");
  text +=
      "# A segment from 1, 0 the ground; empty: never yields, never breaks. hold: translations "
      "that "
      "the joint holds.\n";
  text += "joint,at [m],from segment,to segment,half joint,hold,tributary length [m]";
  for (const std::string_view what :
       {"rotation {}", "stiffness {} [N m/rad]", "hardened stiffness {} [N m/rad]",
        "yield moment {} [N m]", "break angle {} [rad]"}) {
    for (const char axis : {'x', 'y', 'z'}) text += ',' + written(what, axis);
  }
  text += '\n';
  for (const EngineJoint& joint : beam.joints) {
    std::string row =
        written("{},{},{},{},{:d},{},{}", joint.name, joint.at, segment_number(joint.parent),
                joint.child + 1, joint.half_joint, held(joint.holds), joint.length);
    for (const JointHold rotation : joint.rotation) {
      row += written(",{}", kRotation[static_cast<std::size_t>(rotation)]);
    }
    add_cells(joint.stiffness, row);
    add_cells(joint.hardened_stiffness, row);
    add_cells(joint.yield_moment, row);
    add_cells(joint.break_angle, row);
    text += row + '\n';
  }
  return text;
}

}  // namespace plastica::calibrate
