#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/calibrate/fit/path_over.hpp"

/// Each kind of parameter that a fit through a scene may move, fitted back from the scene's own
/// curve without noise, from starts that are a fifth off.
namespace plastica::calibrate {
namespace {

using testing::path_over;

struct Fitted {
  std::string field;
  double from = 1.2;  ///< start over the truth
};

/// A scene whose numbers are the truth.
struct Problem {
  std::string name;
  plastica::Setup setup;
  SceneTarget target{};  ///< without ordinates
  std::vector<Fitted> fitted{};
  std::string break_path{};  ///< the limit that it breaks by at the path's end; empty: it does not
  bool knows_break = false;  ///< whether it breaks there by the strain that its scene has
};

// The name that GoogleTest looks for. NOLINTNEXTLINE(readability-identifier-naming)
void PrintTo(const Problem& problem, std::ostream* to) { *to << problem.name; }

/// A bar of 400 x 20 x 20 mm, clamped at its start.
plastica::Setup bar() {
  plastica::Setup setup;
  Scene& scene = setup.scene;
  scene.beam.length = 0.4;
  scene.beam.segments = 6;
  scene.section.width = scene.section.height = 0.02;
  scene.material.youngs_modulus = 205e9;
  scene.material.yield_stress = 380e6;
  scene.supports = {{.at = Place::start(), .kind = SupportKind::Clamp}};
  return setup;
}

Problem bent(std::string name, const Hardening& hardening, std::vector<double> path,
             std::vector<Fitted> fitted) {
  Problem problem{.name = std::move(name), .setup = bar(), .fitted = std::move(fitted)};
  Scene& scene = problem.setup.scene;
  scene.material.hardening = hardening;
  scene.yield_model = YieldModel::Fibre;
  Support head{.at = Place::end(), .kind = SupportKind::Roller};
  head.hold = HeldFreedoms{false, true, false, false, false, false};
  head.translation = {0.0, 1.0, 0.0};
  scene.supports.push_back(head);
  scene.probes = {{"force", ProbeQuantity::Reaction, Place::end(), Component::Y}};
  problem.target.kind = Abscissa::Support;
  problem.target.driven = 1;
  problem.target.ordinate_probe = "force";
  problem.target.abscissa = std::move(path);
  return problem;
}

Problem twisted(std::string name, std::vector<Fitted> fitted) {
  Problem problem{.name = std::move(name), .setup = bar(), .fitted = std::move(fitted)};
  Scene& scene = problem.setup.scene;
  scene.material.shear_yield_stress = 220e6;
  scene.material.hardening = {HardeningLaw::Linear, 10e9};
  Support head{.at = Place::end(), .kind = SupportKind::Pin};
  head.hold = HeldFreedoms{true, true, false, false, false, true};
  head.rotation = {0.0, 0.0, 1.0};
  scene.supports.push_back(head);
  scene.probes = {{"torque", ProbeQuantity::ReactionMoment, Place::end(), Component::Z}};
  problem.target.kind = Abscissa::Support;
  problem.target.driven = 1;
  problem.target.ordinate_probe = "torque";
  problem.target.abscissa = path_over({0.4}, 30);
  problem.break_path = "material.break_shear_strain";
  return problem;
}

Problem with_shear_modulus() {
  Problem problem = twisted("ShearModulusAndShearYieldStress",
                            {{"material.shear_modulus"}, {"material.shear_yield_stress", 0.8}});
  problem.setup.scene.material.shear_modulus = 79e9;
  return problem;
}

/// Without hardening one joint alone yields: its rotation is strain over the hinge length.
Problem hinge() {
  Problem problem = bent("HingeLength", {}, path_over({0.05}, 30),
                         {{"rules.hinge_length"}, {"material.yield_stress", 0.9}});
  Scene& scene = problem.setup.scene;
  scene.yield_model = YieldModel::PerAxis;
  scene.hinge_length = 0.03;
  problem.knows_break = true;
  return problem;
}

/// A bar that was struck and swings.
Problem swinging() {
  Problem problem{.name = "DampingTime",
                  .setup = bar(),
                  .fitted = {{"material.youngs_modulus", 1.05}, {"solver.damping_time"}}};
  plastica::Setup& setup = problem.setup;
  setup.scene.yield_model = YieldModel::Elastic;
  setup.scene.initial_motions = {{.from = Place{0.5, {}}, .velocity = {0.0, 3.0, 0.0}}};
  setup.scene.probes = {{"tip", ProbeQuantity::Displacement, Place::end(), Component::Y}};
  setup.solver.analysis = Analysis::Dynamics;
  setup.solver.scheme = Scheme::ArticulatedMidpoint;
  setup.solver.time_step = 2e-4;
  setup.solver.damping = Damping::Stiffness;
  setup.solver.damping_time = 1e-4;
  setup.solver.duration = 0.02;
  setup.solver.steps = 50;
  problem.target.kind = Abscissa::Time;
  problem.target.ordinate_probe = "tip";
  problem.target.abscissa = path_over({0.02}, 50);
  return problem;
}

std::vector<Problem> problems() {
  Hardening linear{HardeningLaw::Linear, 10e9, 0.6};
  Hardening voce{.law = HardeningLaw::VoceChaboche};
  voce.saturation_stress = 150e6;
  voce.saturation_rate = 40.0;
  Hardening one{.law = HardeningLaw::VoceChaboche};
  one.backstress_modulus = {30e9, 0.0, 0.0};
  one.backstress_rate = {150.0, 0.0, 0.0};
  Hardening two = voce;
  two.backstress_modulus = {60e9, 4e9, 0.0};
  two.backstress_rate = {600.0, 40.0, 0.0};
  const std::vector<double> there = path_over({0.08, 0.05}, 20);
  const std::vector<double> cycles = path_over({0.05, -0.05, 0.06, -0.06}, 16);
  return {bent("TangentModulusAndKinematicFraction", linear, cycles,
               {{"material.hardening.tangent_modulus"},
                {"material.hardening.kinematic_fraction", 0.8},
                {"material.yield_stress", 0.9}}),
          bent("VoceHardening", voce, there,
               {{"material.youngs_modulus", 0.8},
                {"material.yield_stress"},
                {"material.hardening.saturation_stress", 0.8},
                {"material.hardening.saturation_rate"}}),
          bent("OneBackStress", one, cycles,
               {{"material.yield_stress", 0.9},
                {"material.hardening.backstress_modulus_1"},
                {"material.hardening.backstress_rate_1", 0.8}}),
          bent("TwoBackStressesAndVoce", two, cycles,
               {{"material.yield_stress", 0.95},
                {"material.hardening.saturation_stress", 1.1},
                {"material.hardening.saturation_rate", 0.9},
                {"material.hardening.backstress_modulus_1", 0.9},
                {"material.hardening.backstress_rate_1", 1.1},
                {"material.hardening.backstress_modulus_2", 1.1},
                {"material.hardening.backstress_rate_2", 0.9}}),
          twisted("PoissonRatio", {{"material.poisson_ratio", 0.8}}),
          with_shear_modulus(),
          hinge(),
          swinging()};
}

class SceneParameterKinds : public ::testing::TestWithParam<Problem> {};

TEST_P(SceneParameterKinds, AreFittedBack) {
  Problem problem = GetParam();
  std::vector<const Field*> fields;
  std::vector<double> truth;
  SceneFitOptions options{.parameters = {}, .starts = 1, .segments_error = false};
  for (const Fitted& fitted : problem.fitted) {
    const Field& field = find_field(fitted.field);
    fields.push_back(&field);
    truth.push_back(std::get<double>(field.get(problem.setup)));
    Parameter p = testing::free_parameter(fitted.field, 0.1 * truth.back(), 10.0 * truth.back());
    if (field.path == "material.poisson_ratio") p.upper = 0.5;
    if (field.material == MaterialField::KinematicFraction) p.upper = 1.0;
    p.value = fitted.from * truth.back();
    options.parameters.push_back(p);
  }
  problem.target.name = problem.name;
  problem.target.ordinate.assign(problem.target.abscissa.size(), 0.0);
  const SceneModel model(problem.setup, problem.target, fields);
  const SceneCurve curve = model.run(truth, 1).front();
  ASSERT_TRUE(curve.usable) << curve.reason;
  problem.target.ordinate = curve.ordinate;
  // Without a break the strain is that at the end.
  const double strain = curve.strain.at;
  const bool breaks = !problem.break_path.empty();
  if (breaks || problem.knows_break) {
    problem.target.broke = SceneBreak{problem.target.abscissa.back(), 0.0};
  }
  if (problem.knows_break) problem.setup.scene.material.break_strain = strain;
  if (breaks) options.parameters.push_back(testing::free_parameter(problem.break_path, 1e-5, 10.0));
  const SceneFitResult fit = fit_scene(problem.setup, problem.target, options);
  ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(fit.parameters[i].value / truth[i], 1.0, 1e-5) << problem.fitted[i].field;
    EXPECT_EQ(fit.parameters[i].verdict(), Verdict::Identified) << problem.fitted[i].field;
  }
  if (breaks) {
    EXPECT_NEAR(fit.parameters.back().value / strain, 1.0, 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, SceneParameterKinds, ::testing::ValuesIn(problems()),
                         [](const auto& problem) { return problem.param.name; });

}  // namespace
}  // namespace plastica::calibrate
