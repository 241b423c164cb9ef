#pragma once

#include <string>
#include <utility>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/trial/scene_model.hpp"
#include "plastica/io/scene_file.hpp"

namespace plastica::testing {

/// data/scenes/bend_test.toml, remeshed.
inline Setup bend_test(int segments) {
  const std::string path = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/bend_test.toml";
  Setup setup = io::read_scene_file(path).setup;
  setup.scene.beam.segments = segments;
  return setup;
}

inline calibrate::Parameter free_parameter(const std::string& name, double lower, double upper) {
  calibrate::Parameter p;
  p.field = &find_field(name);
  p.lower = lower;
  p.upper = upper;
  return p;
}

/// Young's modulus and yield stress.
inline std::vector<calibrate::Parameter> stiffness_and_yield() {
  return {free_parameter("youngs_modulus", 50e9, 500e9),
          free_parameter("yield_stress", 100e6, 2e9)};
}

/// And the break strain.
inline std::vector<calibrate::Parameter> all_three() {
  auto parameters = stiffness_and_yield();
  parameters.push_back(free_parameter("break_strain", 1e-4, 1.0));
  return parameters;
}

struct Truth {
  double youngs_modulus = 205e9;
  double yield_stress = 380e6;
};

/// What a machine would measure of a setup with other numbers, without noise: the force over the
/// way of the end, every `spacing` up to `last` [m].
inline calibrate::SceneTarget measured(const Setup& setup, const Truth& truth = {},
                                       double spacing = 1e-3, double last = 0.06) {
  calibrate::SceneTarget target;
  target.name = "bar";
  target.abscissa_probe = "displacement";
  target.ordinate_probe = "force";
  target.abscissa_factor = target.ordinate_factor = -1.0;
  for (int i = 0; i * spacing < last * (1.0 + 1e-9); ++i) target.abscissa.push_back(i * spacing);
  target.ordinate.assign(target.abscissa.size(), 0.0);
  const calibrate::SceneModel model(
      setup, target,
      {&find_field("material.youngs_modulus"), &find_field("material.yield_stress")});
  const std::vector<double> values{truth.youngs_modulus, truth.yield_stress};
  const calibrate::SceneCurve curve = model.run(values, 1).front();
  if (curve.usable) target.ordinate = curve.ordinate;
  target.broke = calibrate::SceneBreak{last, 0.0};
  return target;
}

/// The end's way up to 4 mm, of a bar that is pushed by a force.
inline calibrate::SceneTarget pushed() {
  calibrate::SceneTarget target;
  target.name = "pushed";
  target.abscissa_probe = "displacement";
  target.ordinate_probe = "force";
  target.abscissa_factor = -1.0;
  for (int i = 0; i <= 40; ++i) target.abscissa.push_back(1e-4 * i);
  target.ordinate.assign(target.abscissa.size(), 0.0);
  return target;
}

/// The bar pushed at its end.
inline Setup pushed_bar(double force) {
  Setup setup = bend_test(5);
  Scene& scene = setup.scene;
  scene.supports.pop_back();
  scene.loads = {{.at = Place::end(), .force = {0.0, -force, 0.0}}};
  scene.probes[1] = {"force", ProbeQuantity::LoadFactor};
  return setup;
}

}  // namespace plastica::testing
