#include "calibrate/fit/scene_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

std::vector<WeightedTarget> bent_targets() {
  WeightedTarget weighted{bend_test(4), {}};
  weighted.target.name = "bar";
  weighted.target.ordinate = {0.0, 1.0, 2.0};
  return {weighted};
}

SceneFitOptions stated() {
  SceneFitOptions options;
  options.parameters = stiffness_and_yield();
  return options;
}

const Parameter& find(const SceneFitOptions& options, const std::string& name) {
  for (const Parameter& p : options.parameters) {
    if (p.name() == name) return p;
  }
  throw std::out_of_range(name);
}

TEST(SceneLaws, SetTheHardeningWhereTheSceneHasItsMaterial) {
  plastica::Setup setup = bend_test(4);
  Region thick;
  thick.to = {0.5, {}};
  thick.material = setup.scene.material;
  thick.own = {"section"};
  Region other = thick;
  other.own = {"section", "material"};
  setup.scene.regions = {thick, other};
  const plastica::Setup voce = setup_of(Law::Voce, setup);
  EXPECT_EQ(voce.scene.material.hardening.law, HardeningLaw::VoceChaboche);
  EXPECT_EQ(voce.scene.regions[0].material.hardening.law, HardeningLaw::VoceChaboche);
  EXPECT_EQ(voce.scene.regions[1].material.hardening.law, HardeningLaw::Linear) << "another metal";
  EXPECT_EQ(setup_of(Law::Ideal, setup).scene.material.hardening.law, HardeningLaw::Ideal);
}

TEST(SceneLaws, FreeTheirParametersBetweenBoundsThatFollowFromTheMaterial) {
  const std::vector<WeightedTarget> targets = bent_targets();
  const double E = targets[0].setup.scene.material.youngs_modulus;
  const double S = targets[0].setup.scene.material.yield_stress;
  EXPECT_EQ(options_of(Law::Ideal, stated(), targets).parameters.size(), 2U);
  const SceneFitOptions linear = options_of(Law::Linear, stated(), targets);
  ASSERT_EQ(linear.parameters.size(), 3U) << "no kinematic fraction without a reversal";
  EXPECT_EQ(*find(linear, "tangent_modulus").lower, 0.0);
  EXPECT_NEAR(*find(linear, "tangent_modulus").upper, 0.9 * 50e9, 1.0) << "below the least E";
  EXPECT_EQ(*find(linear, "tangent_modulus").value, 10e9) << "the scene's own";
  const SceneFitOptions voce = options_of(Law::Voce, stated(), targets);
  EXPECT_NEAR(*find(voce, "saturation_stress").value, 0.3 * S, 1.0);
  EXPECT_NEAR(*find(voce, "saturation_stress").upper, 3.0 * S, 1.0);
  EXPECT_NEAR(*find(voce, "saturation_rate").lower, 1e-3 * E / S, 1e-9);
  EXPECT_EQ(options_of(Law::Chaboche, stated(), targets).parameters.size(), 8U);
  std::vector<WeightedTarget> cyclic = targets;
  cyclic[0].target.ordinate = {0.0, 1.0, -0.5};
  EXPECT_EQ(options_of(Law::Linear, stated(), cyclic).parameters.size(), 4U);
}

TEST(SceneLaws, KeepWhatTheFitSaysOfTheirParameters) {
  SceneFitOptions options = stated();
  options.parameters.push_back(free_parameter("saturation_stress", 50e6, 90e6));
  Parameter& rate = options.parameters.emplace_back();
  rate.field = &find_field("saturation_rate");
  rate.upper = 0.1;
  const SceneFitOptions voce = options_of(Law::Voce, options, bent_targets());
  EXPECT_EQ(*find(voce, "saturation_stress").lower, 50e6);
  EXPECT_EQ(*find(voce, "saturation_stress").upper, 90e6);
  EXPECT_EQ(*find(voce, "saturation_stress").value, 90e6) << "the usual start, held within";
  EXPECT_NEAR(*find(voce, "saturation_rate").lower, 0.001, 1e-12) << "below the given end";
  EXPECT_EQ(options_of(Law::Ideal, options, bent_targets()).parameters.size(), 2U);
}

TEST(SceneLaws, BeginWhereASimplerOneEndedOnceWithoutAnyEffectOfTheirOwn) {
  SceneFitOptions options = options_of(Law::Chaboche, stated(), bent_targets());
  SceneFitResult voce;
  FittedParameter p;
  for (const auto& [path, value] : {std::pair{"material.yield_stress", 300e6},
                                    std::pair{"material.hardening.saturation_stress", 80e6}}) {
    p.path = path;
    p.value = value;
    voce.parameters.push_back(p);
  }
  start_from(voce, options);
  ASSERT_EQ(options.further_starts.size(), 2U);
  EXPECT_EQ(options.further_starts[0].size(), 2U);
  const auto value_of = [&](const std::string& name) {
    for (const auto& [field, value] : options.further_starts[1]) {
      if (field == &find_field(name)) return value;
    }
    return std::nan("");
  };
  EXPECT_EQ(value_of("saturation_stress"), 80e6);
  EXPECT_EQ(value_of("backstress_modulus_1"), *find(options, "backstress_modulus_1").lower);
  EXPECT_EQ(value_of("backstress_rate_1"), *find(options, "backstress_rate_1").upper);
  EXPECT_TRUE(std::isnan(value_of("youngs_modulus"))) << "at its start";
}

/// Two targets of three samples.
SceneFitRecord fitted(double noise) {
  SceneFitRecord record;
  record.name = "both";
  record.weights = {1.0, 3.0};
  record.result.status = FitStatus::Fitted;
  record.result.law = Law::Linear;
  record.result.search_runs = 70;
  for (const char* name : {"a", "b"}) {
    SceneTarget& target = record.targets.emplace_back();
    target.name = name;
    target.abscissa = {0.0, 1.0, 2.0};
    target.ordinate = {0.0, 10.0, 20.0};
    TargetFit& of_target = record.result.targets.emplace_back();
    of_target.samples = 3;
    of_target.fitted = {1.0, 9.0, 21.0};
    of_target.cost = 3.0;
    of_target.misfit_fraction = 0.05;
    of_target.runs_test_p = std::nan("");
  }
  record.targets[1].noise = noise;
  FittedParameter& limit = record.result.parameters.emplace_back();
  limit.path = "material.break_strain";
  FittedParameter& slope = record.result.parameters.emplace_back();
  slope.path = "material.hardening.tangent_modulus";
  slope.judgement = {Verdict::Weak, 0.0};
  record.result.starts = {{{}, {}, 1.0, LeastSquaresOutcome::Stalled, 30},
                          {{}, {}, 1.0, LeastSquaresOutcome::Stalled, 12}};
  return record;
}

TEST(SceneLaws, AreComparedByWhatTheFitsLeave) {
  const LawFit fit = law_fit_of(fitted(0.5));
  ASSERT_EQ(fit.curves.size(), 2U);
  EXPECT_EQ(fit.curves[0].mean_square, 1.0);
  EXPECT_EQ(fit.curves[0].largest, 20.0);
  EXPECT_EQ(fit.curves[0].samples, 1.5) << "its weight over the mean";
  EXPECT_EQ(fit.curves[1].samples, 4.5);
  EXPECT_NEAR(fit.curves[0].autocorrelation, -2.0 / 3.0, 1e-15);
  EXPECT_FALSE(fit.curves[0].noise);
  EXPECT_EQ(fit.curves[1].noise, 0.5) << "a stated one";
  EXPECT_EQ(fit.parameters, std::vector<std::string>{"tangent_modulus"}) << "no break";
  EXPECT_EQ(fit.verdicts, std::vector<Verdict>{Verdict::Weak});
  EXPECT_EQ(fit.evaluations, 42U);
  EXPECT_EQ(fit.runs, 70U);
  // n ln s^2 of the one, chi^2 = n s^2/noise^2 of the other; one noise is a parameter.
  const LawComparison laws = compare_laws({fit});
  EXPECT_NEAR(laws.laws[0].aic, 4.5 / 0.25 + 2.0 * 2.0, 1e-12);
}

TEST(SceneLaws, SayWhenOneEndsWorseThanOneThatItContains) {
  std::vector<WeightedTarget> targets(2);
  const SceneFitRecord record = fitted(0.5);
  for (std::size_t i = 0; i < 2; ++i) targets[i].target = record.targets[i];
  SceneFitResult ideal = record.result;
  ideal.law = Law::Ideal;
  SceneFitResult linear = record.result;
  compare_with(ideal, targets, linear);
  EXPECT_TRUE(linear.warnings.empty());
  linear.targets[1].fitted = {1.01, 8.99, 21.01};
  compare_with(ideal, targets, linear);
  ASSERT_EQ(linear.warnings.size(), 1U);
  EXPECT_EQ(linear.warnings[0],
            "linear ends with a larger misfit than ideal, which it contains: its search has not "
            "found its best");
}

}  // namespace
}  // namespace plastica::calibrate
