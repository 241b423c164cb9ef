#include "calibrate/fit/scene_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/support/has.hpp"

namespace plastica::calibrate {
namespace {

using testing::all_three;
using testing::bend_test;
using testing::free_parameter;
using testing::has;
using testing::measured;
using testing::stiffness_and_yield;
using testing::Truth;

TEST(SceneFit, RecoversTheParametersOfItsOwnModel) {
  const plastica::Setup setup = bend_test(10);
  const SceneTarget target = measured(setup);
  const SceneFitResult fit =
      fit_scene(setup, target, {.parameters = all_three(), .starts = 1, .segments_error = false});
  ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
  EXPECT_NEAR(fit.parameter("youngs_modulus").value / Truth{}.youngs_modulus, 1.0, 1e-6);
  EXPECT_NEAR(fit.parameter("material.yield_stress").value / Truth{}.yield_stress, 1.0, 1e-6);
  EXPECT_LT(fit.targets[0].misfit_fraction, 1e-8);
  EXPECT_EQ(fit.targets[0].break_strain, fit.parameter("break_strain").value);
  EXPECT_EQ(fit.failed_runs, 0);
  EXPECT_LE(fit.runs, 40);
  EXPECT_GT(fit.segment_iterations, 10 * fit.runs);
  // A specimen of the fitted numbers breaks where the measured one did.
  plastica::Setup broken = setup;
  broken.scene.material.youngs_modulus = fit.parameters[0].value;
  broken.scene.material.yield_stress = fit.parameters[1].value;
  broken.scene.material.break_strain = fit.parameters[2].value;
  const Response response = simulate(broken.scene, broken.solver);
  ASSERT_EQ(response.status, Status::Broken);
  EXPECT_NEAR(-response.probes[0][response.samples - 1], target.broke->at, 1e-5);
}

TEST(SceneFit, TakesFieldsThatNoRunCanSet) {
  // The depth shapes the beam itself: each run prepares its own model.
  plastica::Setup setup = bend_test(6);
  setup.scene.section.height = 0.021;
  const SceneTarget target = measured(setup);
  setup.scene.section.height = 0.020;
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = {free_parameter("section.height", 0.01, 0.04),
                        free_parameter("yield_stress", 100e6, 2e9)};
  options.parameters.push_back(free_parameter("youngs_modulus", 50e9, 500e9));
  options.parameters.back().role = ParameterRole::Fixed;
  options.parameters.back().value = Truth{}.youngs_modulus;
  const SceneFitResult fit = fit_scene(setup, target, options);
  EXPECT_EQ(fit.free_count(), 2U);
  EXPECT_EQ(fit.parameter("youngs_modulus").value, Truth{}.youngs_modulus);
  EXPECT_NEAR(fit.parameter("height").value, 0.021, 0.021 * 1e-6);
  EXPECT_NEAR(fit.parameter("yield_stress").value / Truth{}.yield_stress, 1.0, 1e-6);
}

TEST(SceneFit, SetsALoneBreakStrainWithoutASearch) {
  const plastica::Setup setup = bend_test(10);
  SceneTarget target =
      measured(setup, {setup.scene.material.youngs_modulus, setup.scene.material.yield_stress});
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = {free_parameter("break_strain", 1e-4, 1.0)};
  const SceneFitResult sharp = fit_scene(setup, target, options);
  EXPECT_EQ(sharp.parameters[0].scatter_error(), 0.0);
  const auto strain_at = [&](double displacement) {
    SceneTarget moved = target;
    moved.broke->at = displacement;
    return fit_scene(setup, moved, options).parameters[0].value;
  };
  // Evenly distributed over 1 mm.
  const double low = strain_at(0.06 - 5e-4), high = strain_at(0.06 + 5e-4);
  target.broke->half_interval = 5e-4;
  const SceneFitResult blurred = fit_scene(setup, target, options);
  EXPECT_NEAR(blurred.parameters[0].value, 0.5 * (low + high), 1e-12);
  EXPECT_NEAR(blurred.parameters[0].scatter_error(), 0.5 * (high - low) / std::sqrt(3.0), 1e-12);
  // One to search, one at the solution, whatever the search ran; two with other segments.
  EXPECT_LE(blurred.runs, 4);
}

TEST(SceneFit, HasTheErrorsOfALinearFitWhereForcesAreProportional) {
  // Below yield F is E times a curve: the error of E is s E/sqrt(sum F^2).
  const plastica::Setup setup = bend_test(10);
  SceneTarget target = measured(setup, {}, 1e-4, 5e-3);
  target.broke.reset();
  double squares = 0.0;
  for (const double force : target.ordinate) squares += force * force;
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = {free_parameter("youngs_modulus", 50e9, 500e9)};
  target.noise = 4.0;
  const SceneFitResult given = fit_scene(setup, target, options);
  EXPECT_TRUE(std::isinf(given.degrees_of_freedom));
  EXPECT_NEAR(given.parameters[0].scatter_error(),
              4.0 * given.parameters[0].value / std::sqrt(squares),
              1e-6 * given.parameters[0].scatter_error());
  // Residuals of +-3 N that the curve does not see: their size is found.
  target.noise.reset();
  for (std::size_t i = 0; i < target.ordinate.size(); ++i) {
    target.ordinate[i] += i % 2 == 0 ? 3.0 : -3.0;
  }
  const SceneFitResult estimated = fit_scene(setup, target, options);
  const auto samples = static_cast<double>(target.ordinate.size());
  EXPECT_NEAR(estimated.degrees_of_freedom, samples - 1.0, 1e-9);
  EXPECT_NEAR(estimated.targets[0].noise, 3.0 * std::sqrt(samples / (samples - 1.0)), 0.01);
  EXPECT_NEAR(estimated.parameters[0].scatter_error(),
              estimated.targets[0].noise * estimated.parameters[0].value / std::sqrt(squares),
              1e-3 * estimated.parameters[0].scatter_error());
}

// A noise that is stated a hundred times too small does not make the errors so.
TEST(SceneFit, DoubtsANoiseThatTheResidualsContradict) {
  const plastica::Setup setup = bend_test(10);
  SceneTarget target = measured(setup, {}, 1e-4, 5e-3);
  target.broke.reset();
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 3.0);
  for (double& force : target.ordinate) force += noise(random);
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = {free_parameter("youngs_modulus", 50e9, 500e9)};
  const SceneFitResult estimated = fit_scene(setup, target, options);
  target.noise = 0.03;
  const SceneFitResult stated = fit_scene(setup, target, options);
  EXPECT_NEAR(stated.parameters[0].noise_error, 0.01 * estimated.parameters[0].noise_error,
              2e-3 * estimated.parameters[0].noise_error);
  const FittedParameter& modulus = stated.parameters[0];
  const double all = std::hypot(modulus.noise_error, modulus.misfit_error);
  EXPECT_GT(all, 0.6 * estimated.parameters[0].noise_error);
  EXPECT_LT(all, 1.6 * estimated.parameters[0].noise_error);
  ASSERT_FALSE(stated.warnings.empty());
  EXPECT_TRUE(has(stated.warnings[0], "a noise of 0.03 is stated, but the residuals are of"))
      << stated.warnings[0];
}

TEST(SceneFit, SaysThatAForceWasNotSetToZero) {
  const plastica::Setup setup = bend_test(10);
  SceneFitOptions options;
  options.starts = 1;
  options.segments_error = false;
  options.parameters = stiffness_and_yield();
  SceneTarget target = measured(setup);
  // Turned, as a machine counts that pushes.
  target.ordinate_factor *= -1.0;
  for (double& force : target.ordinate) force = -force;
  const auto warnings = [&] {
    std::string all;
    for (const std::string& one : fit_scene(setup, target, options).warnings) all += one + '\n';
    return all;
  };
  EXPECT_FALSE(has(warnings(), "off each measured ordinate"));
  for (double& force : target.ordinate) force += 50.0;
  const std::string said = warnings();
  const std::size_t at = said.find("bar: taking ");
  ASSERT_NE(at, std::string::npos) << said;
  // To the linearization about the fitted parameters.
  EXPECT_NEAR(std::stod(said.substr(at + 12)), 50.0, 0.02 * 50.0) << said;
}

TEST(SceneFit, SaysWhatABoundStopsAndWhatTheCurveDoesNotSee) {
  const plastica::Setup setup = bend_test(10);
  auto parameters = stiffness_and_yield();
  parameters[1].upper = 370e6;
  const SceneFitResult stopped =
      fit_scene(setup, measured(setup), {.parameters = parameters, .starts = 1});
  EXPECT_TRUE(stopped.parameters[1].at_bound());
  EXPECT_EQ(stopped.parameters[1].value, 370e6);
  EXPECT_TRUE(std::isnan(stopped.parameters[1].standard_error));
  EXPECT_FALSE(stopped.parameters[0].at_bound());
  EXPECT_GT(stopped.parameters[0].standard_error, 0.0);
  // A bar that did not yield knows nothing of its yield stress.
  SceneTarget elastic = measured(setup, {}, 1e-4, 5e-3);
  elastic.ordinate[3] += 1.0;
  const SceneFitResult unidentified =
      fit_scene(setup, elastic, {.parameters = stiffness_and_yield(), .starts = 1});
  EXPECT_TRUE(std::isnan(unidentified.parameters[1].standard_error));
  EXPECT_GT(unidentified.parameters[0].standard_error, 0.0);
  EXPECT_THROW(unidentified.parameter("poisson_ratio"), std::out_of_range);
}

TEST(SceneFit, GivesTheSameBitsAndNoWorseFromMoreStarts) {
  const plastica::Setup setup = bend_test(5);
  SceneTarget target = measured(bend_test(20));
  const SceneFitOptions once{.parameters = stiffness_and_yield(), .starts = 1};
  SceneFitOptions often = once;
  often.starts = 3;
  const SceneFitResult a = fit_scene(setup, target, often);
  const SceneFitResult b = fit_scene(setup, target, often);
  EXPECT_EQ(a.targets[0].cost, b.targets[0].cost);
  EXPECT_EQ(a.parameters[0].value, b.parameters[0].value);
  EXPECT_EQ(a.targets[0].fitted, b.targets[0].fitted);
  EXPECT_LE(a.targets[0].cost, fit_scene(setup, target, once).targets[0].cost);
}

TEST(SceneFit, SaysWhatIsOfItsPrior) {
  // Below yield the yield stress is what the prior says, and the modulus what the curve does.
  const plastica::Setup setup = bend_test(10);
  SceneTarget elastic = measured(setup, {}, 1e-4, 5e-3);
  for (std::size_t i = 0; i < elastic.ordinate.size(); ++i) {
    elastic.ordinate[i] += i % 2 == 0 ? 3.0 : -3.0;
  }
  elastic.broke.reset();
  auto parameters = stiffness_and_yield();
  parameters[1].prior = Prior{380e6, 20e6};
  const SceneFitResult fit =
      fit_scene(setup, elastic, {.parameters = parameters, .starts = 1, .segments_error = false});
  ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
  EXPECT_EQ(fit.parameters[1].verdict(), Verdict::FromPrior);
  EXPECT_NEAR(fit.parameters[1].verdict_number(), 1.0, 1e-6);
  EXPECT_NEAR(fit.parameters[1].standard_error, 20e6, 20.0);
  EXPECT_EQ(fit.parameters[0].verdict(), Verdict::Identified);
  // The prior's residual takes the yield stress, so that the samples lose one.
  const auto samples = static_cast<double>(elastic.ordinate.size());
  EXPECT_NEAR(fit.degrees_of_freedom, samples - 1.0, 1e-6);
  EXPECT_NEAR(fit.parameters[0].degrees_of_freedom, samples - 1.0, 1e-6);
  EXPECT_GT(fit.parameters[1].degrees_of_freedom, 1e6) << "its prior is known";
  EXPECT_NE(
      fit.warnings.at(0).find("yield_stress is from its prior: of what is known of it, 100 %"),
      std::string::npos)
      << fit.warnings.at(0);
}

TEST(SceneFit, SaysThatAMachineCountsTheOtherWay) {
  const plastica::Setup setup = bend_test(5);
  SceneTarget target = measured(setup);
  for (double& force : target.ordinate) force = -force;
  const SceneFitResult fit = fit_scene(
      setup, target, {.parameters = stiffness_and_yield(), .starts = 1, .segments_error = false});
  ASSERT_FALSE(fit.warnings.empty());
  EXPECT_EQ(fit.warnings.front(),
            "bar: the scene's curve runs against the measured one; if the machine counts the other "
            "way, ordinate.factor = 1 turns it");
}

TEST(SceneFit, FailsWithAReasonWhereThePathEndsTooEarly) {
  const plastica::Setup setup = bend_test(5);
  SceneTarget target = measured(setup);
  target.broke->at = 0.39;
  const SceneFitResult fit = fit_scene(setup, target, {.parameters = all_three(), .starts = 1});
  EXPECT_EQ(fit.status, FitStatus::Failed);
  EXPECT_EQ(fit.reason,
            "the scene gives no curve from the start values: the path goes from 0 to 0.32, and was "
            "measured from 0 to 0.39 (its ramps going on to 4 times their ends)");
  EXPECT_EQ(fit.runs, 6) << "with the points of two slopes, and again with ramps that go on";
  EXPECT_EQ(fit.failed_runs, 3);
}

/// A test under load control that goes on to collapse: the path of the scene ends at a limit load
/// beyond what was measured, with a curve all the same, and slopes.
TEST(SceneFit, HasSlopesWhereTheSceneEndsAtALimitLoad) {
  plastica::Setup setup = bend_test(12);
  Scene& scene = setup.scene;
  scene.beam.length = 0.2;
  scene.material.hardening = {};
  scene.material.break_strain.reset();
  setup.solver = {};
  setup.solver.steps = 60;
  scene.supports[1].translation = {};
  scene.supports[1].history = {};
  const SectionProperties section = section_properties(scene.section, scene.material.poisson_ratio);
  const double first_yield = scene.material.yield_stress * section.section_modulus_x;
  Load load;
  load.at = {0.5, {}};
  load.force = {0.0, -11.0 * first_yield / scene.beam.length, 0.0};  // the limit is near 9
  scene.loads = {load};
  scene.probes = {{.name = "way",
                   .quantity = ProbeQuantity::Displacement,
                   .at = load.at,
                   .component = Component::Y},
                  {.name = "factor", .quantity = ProbeQuantity::LoadFactor}};
  const Response truth = simulate(scene, setup.solver);
  ASSERT_EQ(truth.status, Status::LimitLoad);
  SceneTarget target;
  target.name = "collapse";
  target.kind = Abscissa::Probe;
  target.abscissa_probe = "way";
  target.abscissa_factor = -1.0;
  target.ordinate_probe = "factor";
  for (std::size_t k = 0; k + 3 < truth.samples; ++k) {
    target.abscissa.push_back(-truth.probes[0][k]);
    target.ordinate.push_back(truth.probes[1][k]);
  }
  const double yield = scene.material.yield_stress;
  scene.material.yield_stress *= 0.97;
  const SceneFitResult fit =
      fit_scene(setup, target,
                {.parameters = {free_parameter("yield_stress", 0.5 * yield, 2.0 * yield)},
                 .starts = 1,
                 .segments_error = false});
  ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
  EXPECT_NEAR(fit.parameters[0].value, yield, 1e-5 * yield);
}

/// What a scene leaves out its parameters make up for: here shear, of a bar that is short.
TEST(SceneFit, PassesOnWhatItsScenesWarnOf) {
  plastica::Setup setup = bend_test(10);
  setup.scene.section.height = setup.scene.beam.length / 5.0;
  const SceneTarget target = measured(setup, {}, 1e-4, 1e-3);
  const SceneFitOptions options{.parameters = {free_parameter("youngs_modulus", 50e9, 500e9)},
                                .starts = 1,
                                .segments_error = false};
  const auto says = [&](std::string_view words) {
    const SceneFitResult fit = fit_scene(setup, target, options);
    EXPECT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
    return std::ranges::any_of(fit.warnings, [&](const auto& one) { return has(one, words); });
  };
  EXPECT_TRUE(says("the scene: the beam is 5 times as long as deep: shear"));
  setup.solver.translation = JointTranslation::Elastic;
  EXPECT_FALSE(says("shear"));
}

}  // namespace
}  // namespace plastica::calibrate
