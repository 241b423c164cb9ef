#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sweeps/stability/base_scene.hpp"

namespace plastica::sweeps::stability {

/// An axis towards the edge: one number of a scene, and the values that it takes.
struct Axis {
  std::string_view name;  ///< "time step"
  std::string_view unit;  ///< of SI; "1"
  double Knobs::*knob = nullptr;
  std::vector<double> values;  ///< rising
};

/// All axes, in the order in which they are shown.
std::span<const Axis> axes();

/// @throws std::out_of_range for a name that is none
const Axis& axis_of(std::string_view name);

/// A value on an axis.
struct AxisValue {
  std::string_view axis;
  double value = 0.0;
};

/// One run of the study.
struct StabilityPoint {
  std::string id;  ///< of content: "planar tip force/modulus=1000"
  const BaseScene* scene = nullptr;
  std::vector<AxisValue> at;  ///< one or two; empty for the normal point
  Knobs knobs;
  double segment_steps = 0.0;  ///< estimate of segments times steps [1]
};

/// All points of all scans, none twice, in the order of scenes and axes. Points whose estimate is
/// beyond 1e9 segment-steps are left out.
std::vector<StabilityPoint> stability_points();

/// All base scenes.
std::span<const BaseScene> base_scenes();

}  // namespace plastica::sweeps::stability
