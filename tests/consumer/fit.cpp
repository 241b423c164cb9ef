#include <algorithm>
#include <calibrate/calibrate.hpp>
#include <cstdio>

using namespace plastica::calibrate;

/// A cantilever of 1 m and 20 mm square, pressed down at its tip by 3 E I/L^3 times its way, E =
/// 200 GPa; to a file and back.
void fit_beam() {
  WeightedTarget bar;
  plastica::Scene& scene = bar.setup.scene;
  scene.section.width = scene.section.height = 0.02;
  scene.beam.segments = 32;
  scene.yield_model = plastica::YieldModel::Elastic;
  scene.supports.emplace_back();                        // a clamp at the start
  scene.loads.push_back({.force = {0.0, -80.0, 0.0}});  // beyond what was measured
  scene.probes = {{"tip", plastica::ProbeQuantity::Displacement},
                  {"force", plastica::ProbeQuantity::Reaction, plastica::Place::start()}};
  bar.target.name = "bar";
  bar.target.abscissa_probe = "tip";
  bar.target.ordinate_probe = "force";
  bar.target.abscissa_factor = -1.0;
  for (int i = 1; i <= 10; ++i) {
    bar.target.abscissa.push_back(1e-4 * i);
    bar.target.ordinate.push_back(3.0 * 200e9 * 0.02 * 0.02 * 0.02 * 0.02 / 12.0 * 1e-4 * i);
  }
  SceneFitOptions options;
  options.parameters.push_back(
      {.field = &plastica::find_field("youngs_modulus"), .lower = 1e9, .upper = 1e12});
  const std::vector<WeightedTarget> targets{bar};
  SceneFitContents contents;
  contents.records.push_back(record_of({"bar", targets}, fit(targets, options)));
  write_scene_fit_store("bar.h5", contents);
  const SceneFitContents stored = read_scene_fit_store("bar.h5");
  std::printf("%s %.3g\n", stored.records[0].name.c_str(),
              stored.records[0].result.parameter("youngs_modulus").value);
}

int main() {
  fit_beam();
  Curve measured;  // of a steel without hardening, broken after 2 %
  for (int i = 0; i <= 200; ++i) {
    const double strain = 1e-4 * i;
    measured.strain.push_back(strain);
    measured.stress.push_back(std::min(210e9 * strain, 355e6));
  }
  measured.strain.push_back(0.0201);
  measured.stress.push_back(0.0);

  FitOptions options;
  for (const char* name : {"youngs_modulus", "yield_stress", "break_strain"}) {
    options.parameters.emplace_back().field = &plastica::find_field(name);
  }
  const std::vector<Target> targets{make_target("bar", measured)};
  for (const FitResult& result : fit(targets, options)) {
    for (const FittedParameter& p : result.parameters)
      std::printf("%s %.4g\n", p.name().c_str(), p.value);
  }
}
