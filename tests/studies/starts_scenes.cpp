#include "tests/studies/starts_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "calibrate/trial/scene_model.hpp"
#include "tests/calibrate/fit/path_over.hpp"
#include "tests/support/normal.hpp"

namespace plastica::studies {
namespace {

using calibrate::Abscissa;
using calibrate::Parameter;
using calibrate::WeightedTarget;
using testing::Normal;
using testing::path_over;

constexpr double kFactor = 30.0;
constexpr double kNoise = 0.005;

/// A bar of 400 x 20 x 20 mm, clamped at its start.
Setup bar(int segments) {
  Setup setup;
  Scene& scene = setup.scene;
  scene.beam.length = 0.4;
  scene.beam.segments = segments;
  scene.section.width = scene.section.height = 0.02;
  scene.material.youngs_modulus = 205e9;
  scene.material.yield_stress = 380e6;
  scene.supports = {{.at = Place::start(), .kind = SupportKind::Clamp}};
  scene.probes.clear();
  return setup;
}

/// Its end is pushed along y.
Setup bent_bar(int segments) {
  Setup setup = bar(segments);
  Scene& scene = setup.scene;
  scene.yield_model = YieldModel::Fibre;
  Support head{.at = Place::end(), .kind = SupportKind::Roller};
  head.hold = HeldFreedoms{false, true, false, false, false, false};
  head.translation = {0.0, 1.0, 0.0};
  scene.supports.push_back(head);
  scene.probes = {{"force", ProbeQuantity::Reaction, Place::end(), Component::Y}};
  return setup;
}

double value_of(const Setup& setup, const Field& field) {
  return std::get<double>(field.get(setup));
}

/// Frees fields of a scene, whose numbers are the truth, and makes its curve.
StartsProblem problem(std::string name, WeightedTarget weighted,
                      const std::vector<std::string>& fields) {
  StartsProblem made;
  made.name = weighted.target.name = std::move(name);
  std::vector<const Field*> set;
  std::vector<double> truth;
  for (const std::string& path : fields) {
    Parameter p;
    p.field = &find_field(path);
    p.value = value_of(weighted.setup, *p.field);
    const bool fraction = p.field->material == MaterialField::KinematicFraction;
    p.lower = fraction ? 0.02 : *p.value / kFactor;
    p.upper = fraction ? 1.0 : *p.value * kFactor;
    made.parameters.push_back(p);
    set.push_back(p.field);
    truth.push_back(*p.value);
  }
  weighted.target.ordinate.assign(weighted.target.abscissa.size(), 0.0);
  const calibrate::SceneModel model(weighted.setup, weighted.target, set);
  const calibrate::SceneCurve curve = model.run(truth, 1).front();
  if (!curve.usable) throw std::runtime_error(made.name + ": " + curve.reason);
  double largest = 0.0;
  for (const double y : curve.ordinate) largest = std::max(largest, std::abs(y));
  Normal normal(7);
  for (std::size_t i = 0; i < curve.ordinate.size(); ++i) {
    weighted.target.ordinate[i] = curve.ordinate[i] + kNoise * largest * normal.draw();
  }
  made.weighted = std::move(weighted);
  return made;
}

WeightedTarget driven(Setup setup, Abscissa kind, std::size_t driven, std::vector<double> path) {
  WeightedTarget weighted;
  weighted.target.kind = kind;
  weighted.target.driven = driven;
  weighted.target.ordinate_probe = setup.scene.probes.front().name;
  weighted.target.abscissa = std::move(path);
  weighted.setup = std::move(setup);
  return weighted;
}

StartsProblem bend() {
  Setup setup = bent_bar(8);
  setup.scene.material.hardening = {HardeningLaw::Linear, 10e9};
  return problem(
      "bend", driven(setup, Abscissa::Support, 1, path_over({0.06, 0.04}, 20)),
      {"material.youngs_modulus", "material.yield_stress", "material.hardening.tangent_modulus"});
}

StartsProblem torsion() {
  Setup setup = bar(6);
  Scene& scene = setup.scene;
  scene.material.shear_modulus = 79e9;
  scene.material.shear_yield_stress = 220e6;
  scene.yield_cap = YieldCap::FullyPlastic;
  Support head{.at = Place::end(), .kind = SupportKind::Pin};
  head.hold = HeldFreedoms{true, true, false, false, false, true};
  head.rotation = {0.0, 0.0, 1.0};
  scene.supports.push_back(head);
  scene.probes = {{"torque", ProbeQuantity::ReactionMoment, Place::end(), Component::Z}};
  return problem("torsion", driven(setup, Abscissa::Support, 1, path_over({0.3}, 30)),
                 {"material.shear_modulus", "material.shear_yield_stress"});
}

/// The force is given, so that soft or weak bars have no equilibrium.
StartsProblem cyclic() {
  Setup setup = bar(8);
  Scene& scene = setup.scene;
  scene.yield_model = YieldModel::Fibre;
  scene.material.hardening = {HardeningLaw::Linear, 10e9, 0.6};
  scene.loads = {{.at = Place::end(), .force = {0.0, 1.0, 0.0}}};
  scene.probes = {{"tip", ProbeQuantity::Displacement, Place::end(), Component::Y}};
  return problem("cyclic force",
                 driven(setup, Abscissa::Load, 0, path_over({2000.0, -2000.0, 2200.0}, 16)),
                 {"material.youngs_modulus", "material.yield_stress",
                  "material.hardening.tangent_modulus", "material.hardening.kinematic_fraction"});
}

StartsProblem voce() {
  Setup setup = bent_bar(8);
  setup.scene.material.hardening.law = HardeningLaw::VoceChaboche;
  setup.scene.material.hardening.saturation_stress = 150e6;
  setup.scene.material.hardening.saturation_rate = 40.0;
  return problem("Voce bend", driven(setup, Abscissa::Support, 1, path_over({0.08, 0.05}, 20)),
                 {"material.youngs_modulus", "material.yield_stress",
                  "material.hardening.saturation_stress", "material.hardening.saturation_rate"});
}

/// A bar that was struck and swings: three and a half periods.
StartsProblem swing() {
  Setup setup = bar(6);
  Scene& scene = setup.scene;
  scene.yield_model = YieldModel::Elastic;
  scene.initial_motions = {{.from = Place{0.5, {}}, .velocity = {0.0, 3.0, 0.0}}};
  scene.probes = {{"tip", ProbeQuantity::Displacement, Place::end(), Component::Y}};
  setup.solver.analysis = Analysis::Dynamics;
  setup.solver.scheme = Scheme::ArticulatedMidpoint;
  setup.solver.time_step = 2e-4;
  setup.solver.damping = Damping::Stiffness;
  setup.solver.damping_time = 1e-4;
  setup.solver.duration = 0.036;
  setup.solver.steps = 90;
  WeightedTarget weighted = driven(setup, Abscissa::Time, 0, path_over({0.036}, 90));
  return problem("swing", std::move(weighted), {"material.youngs_modulus", "solver.damping_time"});
}

StartsProblem coupon() {
  Setup setup;
  Scene& scene = setup.scene;
  scene.material.youngs_modulus = 205e9;
  scene.material.yield_stress = 300e6;
  scene.material.hardening.law = HardeningLaw::VoceChaboche;
  scene.material.hardening.saturation_stress = 80e6;
  scene.material.hardening.saturation_rate = 15.0;
  scene.material.hardening.backstress_modulus = {30e9, 0.0, 0.0};
  scene.material.hardening.backstress_rate = {250.0, 0.0, 0.0};
  scene.drive.strain = {0.01};
  return problem(
      "Chaboche coupon",
      driven(setup, Abscissa::Strain, 0,
             path_over({0.012, -0.012, 0.012, -0.012, 0.016, -0.016}, 40)),
      {"material.youngs_modulus", "material.yield_stress", "material.hardening.saturation_stress",
       "material.hardening.saturation_rate", "material.hardening.backstress_modulus_1",
       "material.hardening.backstress_rate_1"});
}

}  // namespace

std::vector<StartsProblem> starts_problems() {
  std::vector<StartsProblem> all{bend(), torsion(), cyclic(), voce(), swing(), coupon()};
  for (const std::size_t cheap : {0U, 1U, 4U}) all[cheap].cheap = true;
  return all;
}

}  // namespace plastica::studies
