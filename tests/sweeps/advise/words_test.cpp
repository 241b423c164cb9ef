#include "sweeps/advise/word_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "plastica/model/section.hpp"
#include "plastica/theory/beam_vibration.hpp"
#include "plastica/theory/cantilever.hpp"
#include "sweeps/advise/advice_runs.hpp"
#include "tests/sweeps/advise/advised_scenes.hpp"
#include "tests/sweeps/robot_arm.hpp"

/// Words as decisions, each against a truth that no run of the advice has told.
namespace plastica::sweeps {
namespace {

TEST(AdvisedTranslation, IsRigidWhereShearIsLessThanWhatIsAllowedAndItsErrorIsThatOfShear) {
  const plastica::Setup setup = tip_cantilever(0.02, "['0 N', '-1 N', '0 N']");
  const Advice advice = advise(setup, asked(0.01));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  const ToldWord told = told_of(advice, "solver.translation");
  EXPECT_EQ(told.chosen, "rigid");
  const double shear = shear_ratio(setup);
  EXPECT_NEAR(told.line.error, shear / (1.0 + shear), 0.1 * shear);
  ASSERT_NE(told.other("elastic"), nullptr);
  EXPECT_NEAR(told.other("elastic")->cost, 2.0, 0.5);
}

TEST(AdvisedTranslation, IsElasticInAStubbyBeamUnlessTheToleranceIsWide) {
  const plastica::Setup setup = tip_cantilever(0.25, "['0 N', '-1 N', '0 N']");
  const double shear = shear_ratio(setup);
  const double exact = -bending_deflection(setup, 1.0) * (1.0 + shear);
  ASSERT_GT(shear, 0.03);
  for (const auto& [within, word] : {std::pair(0.01, "elastic"), std::pair(0.2, "rigid")}) {
    const Advice advice = advise(setup, asked(within));
    ASSERT_EQ(advice.end, AdviceEnd::Found) << within;
    const ToldWord told = told_of(advice, "solver.translation");
    EXPECT_EQ(told.chosen, word) << within;
    EXPECT_LE(std::abs(end_of(setup, advice) / exact - 1.0), advice.promised) << within;
    EXPECT_LE(advice.promised, within);
    if (told.chosen != "elastic") continue;
    ASSERT_NE(told.other("rigid"), nullptr);
    EXPECT_NEAR(told.other("rigid")->error, shear / (1.0 + shear), 0.15 * shear);
  }
}

TEST(AdvisedTranslation, IsElasticInABarThatIsPulled) {
  // N L/(E A); a rigid one does not move at all.
  const plastica::Setup setup =
      tip_cantilever(0.02, "['0 N', '0 N', '1000 N']", "yield_model = 'elastic'", "steps = 1", 'z');
  const Advice advice = advise(setup, asked(0.02));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  const ToldWord told = told_of(advice, "solver.translation");
  EXPECT_EQ(told.chosen, "elastic");
  ASSERT_NE(told.other("rigid"), nullptr);
  EXPECT_NEAR(told.other("rigid")->error, 1.0, 1e-6);
  const double exact = 1000.0 / (setup.scene.material.youngs_modulus * 0.02 * 0.02);
  // Any number of segments is exact, to the solver's tolerance of 1e-10.
  EXPECT_LE(std::abs(end_of(setup, advice) / exact - 1.0), advice.promised + 1e-10);
}

TEST(AdvisedTranslation, IsElasticInABeamThatBothEndsHoldAlongItsAxis) {
  plastica::Setup setup = tip_cantilever(0.02, "['0 N', '-1 N', '0 N']");
  setup.scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
  setup.scene.loads[0].at = {0.5, {}};
  setup.scene.probes[0].at = {0.5, {}};
  ASSERT_EQ(simulate(setup.scene, setup.solver).status, Status::HeldTwice);
  const Advice advice = advise(setup, asked(0.01));
  ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
  EXPECT_EQ(told_of(advice, "solver.translation").chosen, "elastic");
  // Between clamps P L^3/(192 E I), and shear adds P L/(4 k G A): 192/(4 · 3) times the ratio that
  // it adds to a cantilever's.
  const double exact = -bending_deflection(setup, 1.0) / 64.0 * (1.0 + 16.0 * shear_ratio(setup));
  EXPECT_LE(std::abs(end_of(setup, advice) / exact - 1.0), advice.promised);
}

TEST(AdvisedLevel, IsTheLeastSincePlaneScenesAreTheSameInSpace) {
  plastica::Setup setup = tip_cantilever(0.02, "['0 N', '-1 N', '0 N']");
  setup.solver.level = Level::Spatial;  // as a file may say without need
  const Advice advice = advise(setup, asked(0.01));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  const ToldWord told = told_of(advice, "solver.level");
  EXPECT_EQ(told.chosen, "planar");
  EXPECT_LE(told.line.error, 1e-8);
  ASSERT_NE(told.other("spatial"), nullptr);
  EXPECT_NEAR(told.other("spatial")->cost, 4.0, 0.5);
}

TEST(AdvisedLevel, IsNoChoiceWhereAPlaneWouldDropALoad) {
  const plastica::Setup setup = tip_cantilever(0.02, "['1 N', '-1 N', '0 N']");
  for (const WordAxis& axis : word_axes(setup)) EXPECT_NE(axis.field().path, "solver.level");
}

TEST(AdvisedLevel, IsTheLeastOfABeamThatIsLoadedToItsLimit) {
  // 8 M_p/L^2 of a beam on two supports. The run in space finds an unstable mode at that load.
  const plastica::Setup setup = shipped_scene("profile_limit_load");
  const Advice advice = advise(setup, asked(0.05));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  EXPECT_EQ(told_of(advice, "solver.level").chosen, "auto");
  const plastica::Setup at = advised_setup(setup, advice);
  const Response response = simulate(at.scene, at.solver);
  ASSERT_TRUE(response.limit.has_value());
  const SectionProperties s = section_properties(at.scene.section, at.scene.material.poisson_ratio);
  const double limit = 8.0 * at.scene.material.yield_stress * s.plastic_section_modulus_x /
                       std::pow(at.scene.beam.length, 2.0);
  EXPECT_NEAR(response.limit->below, limit / 90e3, advice.promised * limit / 90e3);
}

/// The load of first yield of the cantilever, M_y/L.
double first_yield(const Setup& setup) {
  const SectionProperties s =
      section_properties(setup.scene.section, setup.scene.material.poisson_ratio);
  return setup.scene.material.yield_stress * s.section_modulus_x / setup.scene.beam.length;
}

Setup loaded_to(double ratio, const std::string& rules) {
  const plastica::Setup unit = tip_cantilever(0.02, "['0 N', '-1 N', '0 N']");
  const double force = ratio * first_yield(unit);
  return tip_cantilever(0.02, "['0 N', '" + std::to_string(-force) + " N', '0 N']", rules,
                        "steps = 8");
}

TEST(AdvisedYieldModel, IsComparedWithFewerFibresWhereMoreIsAllowed) {
  const plastica::Setup setup = loaded_to(0.9, "yield_model = 'per_axis'");
  for (const auto& [within, fibres] : {std::pair(0.002, 40.0), std::pair(0.01, 40.0),
                                       std::pair(0.05, 18.0), std::pair(0.5, 16.0)}) {
    const AdviceOptions options = asked(within);
    const AdviceRuns runs(setup, options);
    const auto& axes = runs.axes();
    const auto of_fibres = std::ranges::find_if(
        axes, [](const FinenessAxis& axis) { return axis.field->path == "solver.fibres"; });
    ASSERT_NE(of_fibres, axes.end());
    EXPECT_EQ(runs.own().setting[static_cast<std::size_t>(of_fibres - axes.begin())], fibres);
  }
}

TEST(AdvisedYieldModel, IsElasticBelowFirstYield) {
  const plastica::Setup setup = loaded_to(0.9, "yield_model = 'fibre'");
  const Advice advice = advise(setup, asked(0.01));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  EXPECT_TRUE(told_of(advice, "rules.yield_model").chosen.starts_with("elastic"));
  EXPECT_LE(told_of(advice, "rules.yield_model").line.error, 1e-7);
}

TEST(AdvisedYieldModel, IsThatOfFibresPastFirstYieldOfARectangle) {
  // Elastic ones are 1 - 1.25/1.2767 = 2.1 % off, Prager and Hodge; a hinge capped at the fully
  // plastic moment, 1.5 M_y, does not yield at all at 1.25 M_y, and misses as much; one capped at
  // first yield finds no equilibrium.
  const plastica::Setup setup = loaded_to(1.25, "yield_model = 'interaction'");
  const Advice advice = advise(setup, asked(0.01));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  const ToldWord told = told_of(advice, "rules.yield_model");
  EXPECT_EQ(told.chosen, "fibre");
  const double missed = 1.0 - 1.25 / theory::tip_deflection_ratio(1.25);
  // That of the next simpler one is measured at the setting that is advised.
  ASSERT_NE(told.other("interaction, fully_plastic"), nullptr);
  EXPECT_NEAR(told.other("interaction, fully_plastic")->error, missed, advice.promised);
  ASSERT_NE(told.other("elastic"), nullptr);
  EXPECT_GT(told.other("elastic")->error, 0.01);
  ASSERT_NE(told.other("interaction, first_yield"), nullptr);
  EXPECT_TRUE(std::isinf(told.other("interaction, first_yield")->error));
  const double exact =
      -theory::tip_deflection_ratio(1.25) * bending_deflection(setup, first_yield(setup));
  // Prager and Hodge's is of small displacements: (tip/length)^2 is 5e-3.
  EXPECT_NEAR(end_of(setup, advice) / exact, 1.0, advice.promised + 5e-3);
}

TEST(AdvisedYieldModel, IsNotElasticWhereOnlyAFineBeamYields) {
  // Loaded to 1.2 first yields it stays 0.54 mm bent (Prager and Hodge); the coarsest beam, whose
  // clamp joint has four fibres, does not yield at all.
  const plastica::Setup setup = shipped_scene("bend_and_release");
  for (const double within : {0.01, 0.002}) {
    const Advice advice = advise(setup, asked(within));
    ASSERT_EQ(advice.end, AdviceEnd::Found) << within;
    EXPECT_EQ(told_of(advice, "rules.yield_model").chosen, "fibre") << within;
  }
}

TEST(AdvisedYieldModel, StaysWhatItsFileCallsElastic) {
  for (const WordAxis& axis : word_axes(loaded_to(1.4, "yield_model = 'elastic'"))) {
    EXPECT_NE(axis.field().path, "rules.yield_model");
  }
}

TEST(AdvisedEndRule, IsOneOfSecondOrderWhereItsFileClampsASegment) {
  const plastica::Setup setup =
      tip_cantilever(0.02, "['0 N', '-1 N', '0 N']", "yield_model = 'elastic'\nend_rule = 'equal'");
  const Advice advice = advise(setup, asked(0.01));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  EXPECT_NE(told_of(advice, "rules.end_rule").chosen, "equal");
  // 1.4/N of a clamped segment would take 140, 1/(2 N^2) some 8 (docs/accuracy.md).
  EXPECT_LE(advice.setting[0], 20.0);
  const double exact = -bending_deflection(setup, 1.0) * (1.0 + shear_ratio(setup));
  EXPECT_LE(std::abs(end_of(setup, advice) / exact - 1.0), advice.promised);
}

TEST(AdvisedScheme, IsOneOfSecondOrderAndHoldsAgainstTheClosedFormOfAReleasedCantilever) {
  plastica::Setup setup = shipped_scene("falling_cantilever");
  setup.scene.material.youngs_modulus = 20e9;
  setup.solver.rotary_inertia = RotaryInertia::Off;
  setup.solver.duration = 0.1;
  setup.solver.steps = 25;
  setup.solver.scheme = Scheme::LinearlyImplicitEuler;
  const Advice advice = advise(setup, asked(0.05));
  ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
  const plastica::Setup at = advised_setup(setup, advice);
  EXPECT_EQ(order_of_method(at, find_field("solver.scheme")), 2.0);
  const Response response = simulate(at.scene, at.solver);
  const SectionProperties s = section_properties(at.scene.section, at.scene.material.poisson_ratio);
  const theory::VibratingBeam beam{at.scene.beam.length,
                                   at.scene.material.youngs_modulus * s.second_moment_x,
                                   at.scene.material.density * s.area};
  double squares = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < response.samples; ++i) {
    const double exact =
        theory::released_cantilever_tip(beam, at.scene.gravity[1], response.chain.time[i], 20);
    squares += std::pow(response.probes[0][i] - exact, 2.0);
    all += exact * exact;
  }
  EXPECT_LE(std::sqrt(squares / all), advice.promised);
}

TEST(AdvisedWords, ArePromisedWithTheErrorOfTheirModels) {
  for (const double within : {0.1, 0.02}) {
    const plastica::Setup setup = tip_cantilever(0.12, "['0 N', '-1 N', '0 N']");
    const Advice advice = advise(setup, asked(within));
    ASSERT_EQ(advice.end, AdviceEnd::Found);
    const plastica::Setup finer = finer_setup(setup, advice, 0.25);
    EXPECT_EQ(finer.solver.translation, JointTranslation::Elastic);
    const double truth = simulate(finer.scene, finer.solver).probes[0].back();
    EXPECT_LE(std::abs(end_of(setup, advice) / truth - 1.0), advice.promised);
  }
}

}  // namespace
}  // namespace plastica::sweeps
