#include <gtest/gtest.h>

#include <cmath>

#include "calibrate/trial/scene_drive.hpp"
#include "plastica/base/check.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"

/// Where the scene's own path ends before the measured one, and which joints' strain is the limit.
namespace plastica::calibrate {
namespace {

using testing::all_three;
using testing::bend_test;
using testing::free_parameter;
using testing::measured;
using testing::pushed;

/// The bar pushed by a force of 300 N, which moves its end by 2.3 mm if it is of 205 GPa.
plastica::Setup pushed_bar() {
  plastica::Setup setup = testing::pushed_bar(300.0);
  setup.scene.material.youngs_modulus = 100e9;
  return setup;
}

std::vector<SceneCurve> curves_at(const plastica::Setup& setup, const SceneTarget& target,
                                  const std::vector<double>& moduli) {
  return SceneModel(setup, target, {&find_field("material.youngs_modulus")})
      .run(moduli, moduli.size());
}

TEST(ScenePath, GoesOnWithARampThatEndsTooEarly) {
  const std::vector<SceneCurve> curves = curves_at(pushed_bar(), pushed(), {100e9, 250e9, 2000e9});
  EXPECT_TRUE(curves[0].usable) << curves[0].reason;
  EXPECT_FALSE(curves[0].is_extended);
  ASSERT_TRUE(curves[1].usable) << curves[1].reason;
  EXPECT_TRUE(curves[1].is_extended);
  EXPECT_GT(curves[1].ordinate.back(), 1.5);
  EXPECT_FALSE(curves[2].usable);
  // Both runs cost.
  EXPECT_GT(curves[1].segment_iterations, 4 * curves[0].segment_iterations);
}

TEST(ScenePath, HasNoSeamWhereItGoesOn) {
  plastica::Setup longer = pushed_bar();
  longer.scene.loads[0].force[1] *= 4.0;
  longer.solver.steps *= 4;
  const SceneTarget target = pushed();
  const SceneCurve whole = curves_at(longer, target, {250e9}).front();
  const SceneCurve beyond = curves_at(pushed_bar(), target, {250e9}).front();
  ASSERT_TRUE(beyond.is_extended);
  ASSERT_FALSE(whole.is_extended);
  for (std::size_t i = 0; i < target.abscissa.size(); ++i) {
    EXPECT_NEAR(beyond.ordinate[i], 4.0 * whole.ordinate[i], 1e-8);
  }
}

TEST(ScenePath, DoesNotStopASearchThatBeginsTooSoft) {
  SceneTarget target = pushed();
  target.ordinate = curves_at(pushed_bar(), target, {250e9}).front().ordinate;
  SceneFitOptions options;
  options.parameters = {free_parameter("youngs_modulus", 50e9, 500e9)};
  options.starts = 1;
  options.segments_error = false;
  const SceneFitResult fit = fit_scene(pushed_bar(), target, options);
  ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
  EXPECT_NEAR(fit.parameters[0].value, 250e9, 250e9 * 1e-6);
  EXPECT_EQ(fit.failed_runs, 0);
  EXPECT_EQ(fit.warnings.at(0),
            "pushed: with the fitted values the scene's path ends before the measured one; it was "
            "compared where the ramps go on beyond the scene's end");
}

TEST(ScenePath, CountsAlsoWhereItFailsBeyondWhatWasMeasured) {
  // A Newton that may not cut steps back loses the bar once it yields, at 1200 N.
  plastica::Setup setup = pushed_bar();
  setup.scene.loads[0].force[1] = -450.0;
  setup.solver.steps = 3;
  setup.solver.max_iterations = 2;
  setup.solver.smallest_step = 1.0;
  plastica::Setup longer = setup;
  longer.solver.duration = 4.0;
  longer.solver.steps = 12;
  longer.scene.material.youngs_modulus = 250e9;
  ASSERT_EQ(simulate(longer.scene, longer.solver).status, Status::NotConverged);
  const SceneCurve curve = curves_at(setup, pushed(), {250e9}).front();
  EXPECT_TRUE(curve.is_extended);
  EXPECT_TRUE(curve.usable) << curve.reason;
  SceneTarget far = pushed();
  far.abscissa.back() = 0.1;
  EXPECT_NE(curves_at(setup, far, {250e9}).front().reason.find("the scene ended not-converged"),
            std::string::npos);
}

TEST(ScenePath, GoesOnOnlyUnderRamps) {
  EXPECT_EQ(extended_setup(pushed_bar(), 4)->solver.duration, 4.0);
  EXPECT_EQ(extended_setup(pushed_bar(), 4)->solver.steps, 320);
  const auto changed = [](auto change) {
    plastica::Setup setup = pushed_bar();
    change(setup);
    return extended_setup(setup, 4);
  };
  EXPECT_FALSE(changed([](auto& s) { s.solver.analysis = Analysis::Dynamics; }));
  EXPECT_FALSE(changed([](auto& s) { s.solver.control = PathControl::Displacement; }));
  EXPECT_FALSE(changed([](auto& s) { s.scene.loads[0].history = History::constant(); }));
  EXPECT_FALSE(changed([](auto& s) { s.scene.gravity[1] = -9.81; }));
  EXPECT_TRUE(changed([](auto& s) {
    s.scene.gravity[1] = -9.81;
    s.scene.gravity_history = History::constant();
  }));
  // What turns has ended after two seconds; the ramp goes on from there.
  const auto both = changed([](auto& s) {
    s.scene.loads.push_back(s.scene.loads[0]);
    s.scene.loads[1].history = History::turning_points({1.0, 0.0});
  });
  EXPECT_EQ(both->solver.duration, 8.0);
}

/// The bar, of which the clamped half is a region.
plastica::Setup bar_of_two(double break_strain) {
  plastica::Setup setup = bend_test(10);
  Region region{.from = Place::start(), .to = Place{0.5, {}}};
  region.section = setup.scene.section;
  region.material = setup.scene.material;
  region.own = {};
  if (break_strain > 0.0) {
    region.material.break_strain = break_strain;
    region.own = {"material.break_strain"};
  }
  setup.scene.regions = {region};
  return setup;
}

double strain_at_break(const plastica::Setup& setup) {
  return curves_at(setup, measured(bend_test(10)), {205e9}).front().strain.at;
}

TEST(ScenePath, TakesTheBreakStrainOfTheMaterialThatIsFitted) {
  const double of_all = strain_at_break(bend_test(10));
  EXPECT_GT(of_all, 0.005);
  EXPECT_EQ(strain_at_break(bar_of_two(0.0)), of_all);
  // A clamped half with a limit of its own says nothing of the scene's.
  const double of_the_rest = strain_at_break(bar_of_two(0.5));
  EXPECT_GE(of_the_rest, 0.0);
  EXPECT_LT(of_the_rest, 0.5 * of_all);
  // One that never breaks, either.
  plastica::Setup other = bar_of_two(0.0);
  other.scene.regions[0].own = {"material.break_strain"};
  EXPECT_EQ(strain_at_break(other), of_the_rest);
}

/// The joint at a thick region belongs to the thin one, on whichever side of it that is.
TEST(ScenePath, TakesTheBreakStrainAtARegionOfAnotherMaterialFromEitherEnd) {
  plastica::Setup setup = bar_of_two(0.5);
  setup.scene.regions[0].section.height = 0.032;
  setup.scene.regions[0].own.emplace_back("section.height");
  plastica::Setup mirrored = setup;
  mirrored.scene.regions[0].from = Place{0.5, {}};
  mirrored.scene.regions[0].to = Place::end();
  mirrored.scene.supports[0].at = Place::end();
  mirrored.scene.supports[1].at = Place::start();
  for (Probe& probe : mirrored.scene.probes) probe.at = Place::start();
  const double strain = strain_at_break(setup);
  EXPECT_GT(strain, 0.005);
  EXPECT_NEAR(strain_at_break(mirrored), strain, 1e-6 * strain);
}

/// Which of two regions is the weaker one is decided by the values of the trial, not by what the
/// scene began with.
TEST(ScenePath, TakesTheBreakStrainOfTheRegionThatIsWeakerAtTheValues) {
  plastica::Setup setup = bar_of_two(0.5);
  Region& region = setup.scene.regions[0];
  region.own.emplace_back("material.yield_stress");
  region.own.emplace_back("section.height");
  region.section.height = 0.025;
  const auto strain_from = [&](double nominal, double at) {
    setup.scene.material.yield_stress = nominal;
    const SceneModel model(setup, measured(bend_test(10)), {&find_field("material.yield_stress")});
    return model.run(std::vector{at}, 1).front().strain.at;
  };
  const double own = region.material.yield_stress;
  for (const double at : {0.5 * own, 3.0 * own}) {
    const double strain = strain_from(at, at);
    EXPECT_EQ(strain_from(0.5 * own, at), strain) << at;
    EXPECT_EQ(strain_from(3.0 * own, at), strain) << at;
  }
  EXPECT_GT(strain_from(own, 0.5 * own), 0.0);
}

TEST(ScenePath, RefusesALimitThatNoJointTakes) {
  plastica::Setup setup = bar_of_two(0.5);
  setup.scene.regions[0].to = Place::end();
  try {
    fit_scene(setup, measured(bend_test(10)), {.parameters = all_three(), .starts = 1});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.rule(), "cannot be fitted: regions of other materials cover the whole beam");
  }
}

}  // namespace
}  // namespace plastica::calibrate
