#include "calibrate/engine/fitted_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/calibrate/engine/engine_scenes.hpp"
#include "tests/calibrate/report/records.hpp"
#include "tests/support/message.hpp"

namespace plastica::testing {
namespace {

using calibrate::FitOptions;
using calibrate::FitRecord;
using calibrate::FittedParameter;
using calibrate::FittedScene;
using calibrate::ParameterRole;
using calibrate::testing::free_parameter;

FitRecord fit_of(std::vector<FittedParameter> parameters) {
  FitRecord record;
  record.target.name = "bar-01";
  record.result.status = calibrate::FitStatus::Fitted;
  record.result.parameters = std::move(parameters);
  return record;
}

FittedParameter yield() {
  return free_parameter("yield_stress", Dimension::Stress, 310e6, 2.4e6, 300e6, 1e6, 1e9);
}

FittedParameter break_strain() {
  return free_parameter("break_strain", Dimension::Strain, 0.16, 0.001, 0.1, 0.001, 1.0);
}

bool has(const FittedScene& fitted, const std::string& note) {
  return std::find(fitted.notes.begin(), fitted.notes.end(), note) != fitted.notes.end();
}

TEST(FittedScene, HasTheNumbersOfTheFitAndElseItsOwn) {
  const Scene scene = breakable_scene();
  const FittedScene fitted = fitted_scene(scene, fit_of({yield(), break_strain()}), {});
  EXPECT_EQ(fitted.scene.material.yield_stress, 310e6);
  EXPECT_EQ(fitted.scene.material.break_strain, 0.16);
  EXPECT_EQ(fitted.scene.material.youngs_modulus, scene.material.youngs_modulus);
  EXPECT_EQ(fitted.scene.material.name, "bar-01");
  EXPECT_EQ(fitted.scene.section.height, 0.03);
  EXPECT_TRUE(has(fitted, "material fitted to bar-01"));
  EXPECT_TRUE(has(fitted, "yield_stress = 310.0 ± 2.4 MPa, fitted"));
}

/// A beam of aluminium with the mass of steel would not show it.
TEST(FittedScene, SaysWhatItHasOfTheScenesMaterial) {
  Scene scene = breakable_scene();
  scene.material.name = "S355";
  const FittedScene fitted = fitted_scene(scene, fit_of({yield()}), {});
  EXPECT_TRUE(has(fitted, "density = 7850.0 kg/m^3, of the scene's S355, not of bar-01"));
  EXPECT_TRUE(has(fitted, "poisson_ratio = 0.30000, of the scene's S355, not of bar-01"));
  FitOptions options;
  options.setup.scene.material.density = 2700.0;
  options.stated.emplace_back("material.density");
  const FittedScene stated = fitted_scene(scene, fit_of({yield()}), options);
  EXPECT_EQ(stated.scene.material.density, 2700.0);
  EXPECT_FALSE(has(stated, "density = 7850.0 kg/m^3, of the scene's S355, not of bar-01"));
}

/// Who gets the export has not seen the report.
TEST(FittedScene, SaysThatAFitIsPoorOrOfNoUse) {
  FitRecord record = fit_of({yield()});
  record.result.misfit_word = "poor";
  EXPECT_TRUE(has(fitted_scene(breakable_scene(), record, {}),
                  "a poor fit: its law does not describe the curve"));
  record.result.misfit_fraction = 0.7;
  EXPECT_TRUE(has(fitted_scene(breakable_scene(), record, {}),
                  "NO USABLE FIT: the misfit is 70 % of the largest value, above 50 %"));
}

TEST(FittedScene, KeepsWhatTheFitDoesNotKnow) {
  FittedParameter unknown = break_strain();
  unknown.identified = false;
  const FittedScene fitted = fitted_scene(breakable_scene(), fit_of({yield(), unknown}), {});
  EXPECT_EQ(fitted.scene.material.break_strain, 0.02);
  EXPECT_TRUE(has(fitted, "break_strain is not identified by the fit: the scene's own stays"));
}

/// [material] of the fit's file: what the curve was measured with, and no other.
TEST(FittedScene, HasTheMaterialThatTheFitWasTold) {
  FitOptions options;
  calibrate::Parameter parameter;
  parameter.field = &find_field("material.yield_stress");
  options.parameters = {parameter};
  Material& told = options.setup.scene.material;
  told.youngs_modulus = 70e9;
  told.poisson_ratio = 0.33;
  Scene scene = breakable_scene();
  scene.material.youngs_modulus = 200e9;
  scene.material.density = 2000.0;
  const FittedScene fitted = fitted_scene(scene, fit_of({yield()}), options);
  EXPECT_EQ(fitted.scene.material.youngs_modulus, 70e9);
  EXPECT_EQ(fitted.scene.material.poisson_ratio, 0.33);
  EXPECT_EQ(fitted.scene.material.density, 2000.0) << "nobody said another";
  EXPECT_TRUE(has(fitted, "youngs_modulus = 70.000 GPa, of the fit's material"));
  // One that was fitted goes before.
  const FittedParameter modulus =
      free_parameter("youngs_modulus", Dimension::Stress, 71e9, 1e8, 70e9, 1e9, 1e12);
  EXPECT_EQ(fitted_scene(scene, fit_of({modulus, yield()}), options).scene.material.youngs_modulus,
            71e9);
  // In torsion neither modulus nor yield stress need be told.
  FitRecord twisted = fit_of({yield()});
  twisted.target.test = calibrate::Test::Torsion;
  FitOptions untold;
  untold.parameters = options.parameters;
  EXPECT_EQ(fitted_scene(scene, twisted, untold).scene.material.youngs_modulus, 200e9);
}

/// What the fit's file says holds, be it what a material has by default.
TEST(FittedScene, HasWhatTheFitsFileSaysThoughItIsTheDefault) {
  Scene scene = breakable_scene();
  scene.material.poisson_ratio = 0.4;
  scene.material.density = 2000.0;
  FitOptions options;
  const Material defaults = options.setup.scene.material;
  const auto fitted = [&] {
    return fitted_scene(scene, fit_of({yield()}), options).scene.material;
  };
  EXPECT_EQ(fitted().poisson_ratio, 0.4);
  options.stated = {"material.poisson_ratio"};
  EXPECT_EQ(fitted().poisson_ratio, defaults.poisson_ratio);
  EXPECT_EQ(fitted().density, 2000.0);
  options.stated = {"material"};
  EXPECT_EQ(fitted().density, defaults.density);
  EXPECT_EQ(fitted().break_strain, 0.02) << "of which the fit's material says nothing";
}

TEST(FittedScene, TakesFixedNumbersAndSaysWhatIsAtABound) {
  FittedParameter fixed = break_strain();
  fixed.role = ParameterRole::Fixed;
  fixed.identified = false;
  fixed.standard_error = FittedParameter::kNone;
  FittedParameter bound = yield();
  bound.at_upper = true;
  const FittedScene fitted = fitted_scene(breakable_scene(), fit_of({bound, fixed}), {});
  EXPECT_EQ(fitted.scene.material.break_strain, 0.16);
  EXPECT_TRUE(has(fitted, "break_strain = 16.000 %, fixed"));
  EXPECT_TRUE(has(fitted, "yield_stress = 310.0 ± 2.4 MPa, fitted, at a bound of the fit"));
}

TEST(FittedScene, HasTheHardeningOfTheFit) {
  Scene scene = breakable_scene();
  scene.material.hardening = {.law = HardeningLaw::Linear, .tangent_modulus = 1e9};
  FitOptions options;
  options.setup.scene.material.hardening = {.law = HardeningLaw::Linear, .kinematic_fraction = 1.0};
  const FittedParameter tangent =
      free_parameter("hardening.tangent_modulus", Dimension::Stress, 2e9, 1e7, 1e9, 0.0, 1e11);
  const auto& found = fitted_scene(scene, fit_of({tangent}), options).scene.material.hardening;
  EXPECT_EQ(found.law, HardeningLaw::Linear);
  EXPECT_EQ(found.tangent_modulus, 2e9);
  EXPECT_EQ(found.kinematic_fraction, 1.0);
  EXPECT_EQ(fitted_scene(scene, fit_of({yield()}), {}).scene.material.hardening.law,
            HardeningLaw::Ideal);
}

TEST(FittedScene, FitsRegionsOfTheSameMaterialToo) {
  Scene scene = rich_scene();
  scene.regions.push_back(scene.regions[0]);
  scene.regions[1].material.name = "harder";
  scene.regions[1].material.yield_stress = 900e6;
  scene.regions[1].own = {"section.width", "material.name", "material.yield_stress"};
  FitOptions options;
  options.setup.scene.material.hardening = {.law = HardeningLaw::Linear, .kinematic_fraction = 0.5};
  const FittedScene fitted = fitted_scene(scene, fit_of({yield(), break_strain()}), options);
  EXPECT_EQ(fitted.scene.regions[0].material.yield_stress, 310e6);
  EXPECT_EQ(fitted.scene.regions[0].material.hardening.kinematic_fraction, 0.5);
  EXPECT_EQ(fitted.scene.regions[0].material.name, "bar-01");
  EXPECT_EQ(fitted.scene.regions[1].material.yield_stress, 900e6);
  EXPECT_EQ(fitted.scene.regions[1].material.break_strain, 0.16);
  EXPECT_EQ(fitted.scene.regions[1].material.name, "harder");
}

TEST(FittedScene, GivesRegionsTheWholeLawOfTheFit) {
  FitOptions options;
  options.setup.scene.material.hardening = {.law = HardeningLaw::Linear, .kinematic_fraction = 0.5};
  const FittedParameter tangent =
      free_parameter("hardening.tangent_modulus", Dimension::Stress, 3e9, 1e7, 1e9, 0.0, 1e11);
  const FittedScene fitted = fitted_scene(rich_scene(), fit_of({tangent}), options);
  EXPECT_EQ(fitted.scene.regions[0].material.hardening.tangent_modulus, 3e9);
  EXPECT_EQ(fitted.scene.regions[0].material.hardening.kinematic_fraction, 0.5);
}

/// A fit through scenes of the yield stress and the hinge length.
calibrate::SceneFitRecord scene_fit(calibrate::Verdict of_the_hinge) {
  calibrate::FittedParameter yield_stress;
  yield_stress.path = "material.yield_stress";
  yield_stress.dimension = Dimension::Stress;
  yield_stress.value = 310e6;
  yield_stress.standard_error = 2.4e6;
  yield_stress.judgement = {calibrate::Verdict::Identified, 0.0};
  calibrate::FittedParameter hinge;
  hinge.path = "rules.hinge_length";
  hinge.dimension = Dimension::Length;
  hinge.value = 0.05;
  hinge.standard_error = std::numeric_limits<double>::quiet_NaN();
  hinge.judgement = {of_the_hinge, 0.0};
  calibrate::SceneFitRecord record;
  record.name = "bend";
  record.result.status = calibrate::FitStatus::Fitted;
  record.result.parameters = {yield_stress, hinge};
  return record;
}

TEST(FittedSetup, HasTheNumbersOfAFitThroughScenes) {
  const plastica::Setup setup{rich_scene(), {}};
  const auto fitted =
      fitted_setup(setup, scene_fit(calibrate::Verdict::AtBound), calibrate::Law::Ideal);
  EXPECT_EQ(fitted.setup.scene.material.yield_stress, 310e6);
  EXPECT_EQ(fitted.setup.scene.regions[0].material.yield_stress, 310e6);
  EXPECT_EQ(fitted.setup.scene.hinge_length, 0.05);
  EXPECT_EQ(fitted.notes,
            (std::vector<std::string>{"fitted to bend",
                                      "material.yield_stress = 310.0 ± 2.4 MPa, identified",
                                      "rules.hinge_length = 0.050000 m, at bound"}));
}

TEST(FittedSetup, KeepsWhatTheFitDoesNotKnow) {
  const auto fitted = fitted_setup({rich_scene(), {}}, scene_fit(calibrate::Verdict::NotIdentified),
                                   calibrate::Law::Ideal);
  EXPECT_FALSE(fitted.setup.scene.hinge_length);
  EXPECT_EQ(fitted.notes.back(),
            "rules.hinge_length is not identified by the fit: the scene's own stays");
}

TEST(FittedSetup, HasWhatTheFitHeldToo) {
  std::vector<calibrate::Parameter> held(4);
  const auto set = [&](std::size_t i, const char* name, ParameterRole role) {
    held[i].field = &find_field(name);
    held[i].role = role;
  };
  set(0, "density", ParameterRole::Fixed);
  held[0].value = 2700.0;
  set(1, "shear_yield_stress", ParameterRole::Tied);
  held[1].tied_to = &find_field("yield_stress");
  held[1].factor = 0.5;
  set(2, "shear_modulus", ParameterRole::Tied);
  held[2].tied_to = held[0].field;
  held[2].factor = 1e7;
  set(3, "solver.damping_time", ParameterRole::Tied);
  held[3].tied_to = &find_field("rules.hinge_length");
  const auto fitted = fitted_setup({rich_scene(), {}}, scene_fit(calibrate::Verdict::NotIdentified),
                                   calibrate::Law::Ideal, held);
  EXPECT_EQ(fitted.setup.scene.material.density, 2700.0);
  EXPECT_EQ(fitted.setup.scene.material.shear_yield_stress, 155e6);
  EXPECT_EQ(fitted.setup.scene.material.shear_modulus, 27e9);
  EXPECT_EQ(fitted.setup.solver.damping_time, 0.0);
  EXPECT_EQ(fitted.notes[4], "material.shear_yield_stress = 155.00 MPa, tied");
  EXPECT_EQ(fitted.notes.back(),
            "solver.damping_time is tied to what is not identified: the scene's own stays");
}

TEST(FittedSetup, LeavesOutWhatAnotherLawOfAComparisonHeld) {
  auto record = scene_fit(calibrate::Verdict::Identified);
  record.result.law = calibrate::Law::Voce;
  std::vector<calibrate::Parameter> held(2);
  held[0].field = &find_field("backstress_modulus_1");
  held[0].role = ParameterRole::Fixed;
  held[0].value = 20e9;
  // Tied to it, so that the fit without it has searched this.
  held[1].field = &find_field("yield_stress");
  held[1].role = ParameterRole::Tied;
  held[1].tied_to = held[0].field;
  held[1].factor = 0.01;
  const auto fitted = fitted_setup({rich_scene(), {}}, record, record.result.law, held);
  EXPECT_EQ(fitted.setup.scene.material.hardening.backstress_modulus[0], 0.0);
  EXPECT_EQ(fitted.setup.scene.material.yield_stress, 310e6);
  EXPECT_EQ(fitted.notes.size(), 3U);
  record.result.law = calibrate::Law::Chaboche;
  EXPECT_EQ(fitted_setup({rich_scene(), {}}, record, record.result.law, held)
                .setup.scene.material.hardening.backstress_modulus[0],
            20e9);
}

// What the first target's law does not have is still held of another target's.
TEST(FittedSetup, HasWhatTheFitHeldOfTheLawThatItIsFor) {
  auto record = scene_fit(calibrate::Verdict::Identified);
  record.result.targets.resize(2);
  record.result.targets[1].law = calibrate::Law::Linear;
  std::vector<calibrate::Parameter> held(1);
  held[0].field = &find_field("tangent_modulus");
  held[0].role = ParameterRole::Fixed;
  held[0].value = 3e9;
  const auto linear =
      fitted_setup({rich_scene(), {}}, record, calibrate::Law::Linear, held).setup.scene;
  EXPECT_EQ(linear.material.hardening.law, HardeningLaw::Linear);
  EXPECT_EQ(linear.material.hardening.tangent_modulus, 3e9);
  const auto ideal = fitted_setup({rich_scene(), {}}, record, calibrate::Law::Ideal, held);
  EXPECT_EQ(ideal.setup.scene.material.hardening.law, HardeningLaw::Ideal);
  EXPECT_EQ(ideal.notes[1], "the fit's targets have several laws: this is ideal plasticity");
}

TEST(FittedSetup, NeedsAFit) {
  auto record = scene_fit(calibrate::Verdict::Identified);
  record.result.status = calibrate::FitStatus::Failed;
  record.result.reason = "no search found a start";
  EXPECT_EQ(message_of([&] {
              fitted_setup({rich_scene(), {}}, record, calibrate::Law::Ideal);
            }),
            "--case = bend: has no fit: no search found a start");
}

TEST(FittedScene, NeedsAFit) {
  FitRecord record = fit_of({});
  record.result.status = calibrate::FitStatus::Failed;
  record.result.reason = "the optimizer found nothing";
  EXPECT_EQ(message_of([&] { fitted_scene(breakable_scene(), record, {}); }),
            "--case = bar-01: has no fit: the optimizer found nothing");
}

}  // namespace
}  // namespace plastica::testing
