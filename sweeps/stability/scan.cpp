#include "sweeps/stability/scan.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "plastica/report/format.hpp"

namespace plastica::sweeps::stability {
namespace {

constexpr double kMaxSegmentSteps = 1e9;

/// A motion of many segments takes fewer steps than its scene's: so many segment-steps.
constexpr double kManySegmentSteps = 2e6;
constexpr double kMinSteps = 20.0;

/// Powers of ten between two of them, both included, every `by`-th.
std::vector<double> decades(int from, int to, int by = 1) {
  std::vector<double> values;
  for (int exponent = from; exponent <= to; exponent += by) {
    values.push_back(std::stod("1e" + std::to_string(exponent)));
  }
  return values;
}

std::vector<double> joined(std::vector<double> first, const std::vector<double>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<Axis> make_axes() {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  return {
      {"modulus", "Pa", &Knobs::youngs_modulus, decades(3, 12)},
      {"segments", "1", &Knobs::segments, {2, 3, 4, 6, 8, 32, 64, 128, 300, 1000, 10000, 100000}},
      {"time step", "s", &Knobs::time_step, decades(-8, 0)},
      {"slenderness", "1", &Knobs::slenderness, {3, 5, 10, 20, 100, 300, 1e3, 1e4, 1e5}},
      {"mass ratio", "1", &Knobs::mass_ratio, decades(-6, 6)},
      {"load", "1", &Knobs::load,
       joined(decades(-6, 0, 2), {0.2, 0.9, 1.1, 3, 10, 30, 1e2, 1e3, 1e4, 1e5, 1e6})},
      {"yield",
       "Pa",
       &Knobs::yield_stress,
       {0.0, 1.0, 1e3, 1e6, 1e7, 1e8, 1e9, 1e10, 1e12, kInfinite}},
      {"poisson", "1", &Knobs::poisson_ratio, {-0.99, 0.0, 0.45, 0.49, 0.499, 0.4999, 0.5}},
      {"damping", "1", &Knobs::damping, decades(-3, 4)},
      {"length", "m", &Knobs::length, decades(-6, 4)},
      {"spin", "rad/s", &Knobs::spin, decades(-2, 5)},
      {"steps", "1", &Knobs::steps, decades(1, 7)},
      {"reversal", "1", &Knobs::reversal, {1, 2, 3, 5, 10, 20}},
      {"scheme", "1", &Knobs::scheme, {0, 1, 2, 3}},
      {"path steps", "1", &Knobs::path_steps, {1, 2, 5, 10, 50, 100}},
      {"flexibility", "1", &Knobs::flexibility, {1, 100, 500, 1e3, 2e3, 5e3, 1e4}},
      {"critical", "1", &Knobs::critical, {0.5, 1.1, 1.2, 1.5, 2, 3, 5}},
      {"axial", "1", &Knobs::axial, {0, 0.1, 0.25, 0.4, 0.6, 0.75, 0.9, 0.95, 1.05, 1.5, 2}},
      {"place",
       "1",
       &Knobs::place,
       {0.0214, 0.0265, 0.1649, 0.234, 0.2449, 0.268, 0.285, 0.3413, 0.6777, 0.704, 0.7313, 0.8502,
        0.8719, 0.9559, 0.9766, 0.9898}},
  };
}

/// Every `by`-th value of an axis, its ends among them: for pairs.
std::vector<double> sparse(const Axis& axis) {
  const std::size_t by = axis.values.size() > 8 ? 2 : 1;
  std::vector<double> values;
  for (std::size_t i = 0; i < axis.values.size(); i += by) values.push_back(axis.values[i]);
  if (values.back() != axis.values.back()) values.push_back(axis.values.back());
  return values;
}

/// Steps of a path, recorded ones and those between, and iterations make about so many.
constexpr double kStepsOfAPath = 100.0;

StabilityPoint point_of(const BaseScene& scene, std::vector<AxisValue> at) {
  StabilityPoint point;
  point.scene = &scene;
  point.knobs = scene.normal;
  point.id = std::string(scene.name) + "/";
  for (const AxisValue& value : at) {
    point.knobs.*axis_of(value.axis).knob = value.value;
    point.id += (&value == at.data() ? "" : ",") + std::string(value.axis) + "=" +
                report::brief(value.value);
  }
  if (at.empty()) point.id += "normal";
  point.at = std::move(at);
  const bool moves = scene.analysis == Analysis::Dynamics;
  const bool counts = std::any_of(point.at.begin(), point.at.end(),
                                  [](const AxisValue& value) { return value.axis == "steps"; });
  if (moves && !counts && point.knobs.segments * point.knobs.steps > kManySegmentSteps) {
    point.knobs.steps = std::max(kMinSteps, kManySegmentSteps / point.knobs.segments);
  }
  point.segment_steps = scene.level == Level::Coupon
                            ? 6.0
                            : point.knobs.segments * (moves ? point.knobs.steps : kStepsOfAPath);
  return point;
}

}  // namespace

std::span<const Axis> axes() {
  static const std::vector<Axis> kAxes = make_axes();
  return kAxes;
}

const Axis& axis_of(std::string_view name) {
  for (const Axis& axis : axes()) {
    if (axis.name == name) return axis;
  }
  throw std::out_of_range("no axis " + std::string(name));
}

std::span<const BaseScene> base_scenes() {
  static const std::vector<BaseScene> kScenes = [] {
    std::vector<BaseScene> all;
    for (auto scenes : {coupon_scenes(), twist_scenes(), planar_path_scenes(),
                        planar_motion_scenes(), spatial_scenes(), critical_scenes()}) {
      for (BaseScene& scene : scenes) all.push_back(std::move(scene));
    }
    return all;
  }();
  return kScenes;
}

std::vector<StabilityPoint> stability_points() {
  std::vector<StabilityPoint> points;
  std::set<std::string> known;
  const auto add = [&](StabilityPoint point) {
    if (point.segment_steps > kMaxSegmentSteps || !known.insert(point.id).second) return;
    points.push_back(std::move(point));
  };
  for (const BaseScene& scene : base_scenes()) {
    add(point_of(scene, {}));
    for (const std::string_view name : scene.axes) {
      for (const double value : axis_of(name).values) add(point_of(scene, {{name, value}}));
    }
    for (const auto& [first, second] : scene.pairs) {
      for (const double a : sparse(axis_of(first))) {
        for (const double b : sparse(axis_of(second)))
          add(point_of(scene, {{first, a}, {second, b}}));
      }
    }
  }
  return points;
}

}  // namespace plastica::sweeps::stability
