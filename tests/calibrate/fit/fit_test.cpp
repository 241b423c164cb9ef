#include "calibrate/fit/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

const double kRoot3 = std::sqrt(3.0);

void expect_recovered(const FitResult& result, const char* name, double truth) {
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
  EXPECT_NEAR(result.parameter(name).value, truth, tolerance(1e-6 * std::fabs(truth))) << name;
}

TEST(Fit, RecoversAnIdealPlasticCurve) {
  const FitOptions options = fit_with(HardeningLaw::Ideal, {free_parameter("break_strain")});
  Target target = target_like(options, Deformation::Tension, ramp(120, 0.05));
  break_at(target, 0.0508, 0.0487);
  const FitResult result = fit_target(target, options);
  expect_recovered(result, "youngs_modulus", 190e9);
  expect_recovered(result, "yield_stress", 317e6);
  expect_recovered(result, "break_strain", 0.0504 - 317e6 / 190e9);
  EXPECT_NEAR(result.break_strain_total.value_or(0.0), 0.0504, tolerance(1e-9));
  EXPECT_LT(result.misfit_rms, 1.0);
  EXPECT_EQ(result.misfit_word, "close");
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_EQ(result.samples, 120U);
  // The fitted curve has the target's samples, falls at the break and carries nothing after it.
  ASSERT_EQ(result.fitted.size(), 123U);
  EXPECT_NEAR(result.fitted.stress[119], 317e6, tolerance(400.0));
  EXPECT_NEAR(result.fitted.strain[120], 0.0504, tolerance(1e-9));
  EXPECT_NEAR(result.fitted.stress[120], 317e6, tolerance(400.0));
  EXPECT_EQ(result.fitted.strain[121], result.fitted.strain[120]);
  EXPECT_EQ(result.fitted.stress[121], 0.0);
  EXPECT_EQ(result.fitted.strain[122], 0.0508);
  EXPECT_EQ(result.fitted.stress[122], 0.0);
}

TEST(Fit, FindsAShortPlateauInNoise) {
  // 165 samples on the elastic part, 9 on the plateau: the permanent strain at break is a small
  // difference, so that a break strain to start from is hardly known.
  const double strain_at_break = 38e6 / 1e9 + 0.00213;
  const std::vector<double> strain = ramp(175, strain_at_break - 1e-4);
  const std::vector<double> exact = ideal_curve(strain, 1e9, 38e6);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<double> stress = exact;
    Noise noise(seed);
    for (double& s : stress) s += noise(0.38e6);
    Target target = target_of(strain, stress);
    const double measured =
        strain_at_break - stress.back() / *target.characteristics.youngs_modulus;
    break_at(target, strain_at_break + 1e-4, std::max(measured, 1e-5));
    const FitResult result =
        fit_target(target, fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                                   free_parameter("break_strain")}));
    ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
    const FittedParameter& yield = result.parameter("yield_stress");
    ASSERT_TRUE(yield.has_error()) << seed;
    // 1 % noise on some nine samples: a third of a percent.
    EXPECT_NEAR(yield.standard_error, 0.13e6, 0.03e6) << seed;
    EXPECT_NEAR(yield.value, 38e6, 4.0 * yield.standard_error) << seed;
  }
}

TEST(Fit, RecoversLinearHardening) {
  FitOptions options = fit_with(HardeningLaw::Linear, {free_parameter("tangent_modulus")});
  options.setup.scene.material.hardening.tangent_modulus = 3.3e9;
  const FitResult result =
      fit_target(target_like(options, Deformation::Tension, ramp(120, 0.03)), options);
  expect_recovered(result, "youngs_modulus", 190e9);
  expect_recovered(result, "yield_stress", 317e6);
  expect_recovered(result, "tangent_modulus", 3.3e9);
}

TEST(Fit, RecoversVoceHardening) {
  FitOptions options = fit_with(HardeningLaw::VoceChaboche, {free_parameter("saturation_stress"),
                                                             free_parameter("saturation_rate")});
  options.setup.scene.material.hardening.saturation_stress = 120e6;
  options.setup.scene.material.hardening.saturation_rate = 45.0;
  const FitResult result =
      fit_target(target_like(options, Deformation::Tension, ramp(200, 0.06)), options);
  expect_recovered(result, "youngs_modulus", 190e9);
  expect_recovered(result, "yield_stress", 317e6);
  expect_recovered(result, "saturation_stress", 120e6);
  expect_recovered(result, "saturation_rate", 45.0);
}

TEST(Fit, RecoversBackStressesFromACyclicCurve) {
  FitOptions options = fit_with(HardeningLaw::VoceChaboche, {free_parameter("backstress_modulus_1"),
                                                             free_parameter("backstress_rate_1")});
  options.setup.scene.material.hardening.backstress_modulus[0] = 30e9;
  options.setup.scene.material.hardening.backstress_rate[0] = 220.0;
  Target target = target_like(options, Deformation::Tension, path({0.01, -0.01, 0.01, -0.01}, 50));
  target.loading = Loading::Cyclic;
  const FitResult result = fit_target(target, options);
  expect_recovered(result, "youngs_modulus", 190e9);
  expect_recovered(result, "yield_stress", 317e6);
  expect_recovered(result, "backstress_modulus_1", 30e9);
  expect_recovered(result, "backstress_rate_1", 220.0);
}

TEST(Fit, RecoversManyParametersWhateverTheSeed) {
  FitOptions options =
      fit_with(HardeningLaw::VoceChaboche,
               {free_parameter("backstress_modulus_1"), free_parameter("backstress_rate_1"),
                free_parameter("saturation_stress"), free_parameter("saturation_rate")});
  Hardening& hardening = options.setup.scene.material.hardening;
  hardening = {HardeningLaw::VoceChaboche, 0.0, 0.0, 60e6, 8.0, {40e9, 0.0, 0.0},
               {300.0, 0.0, 0.0}};
  Target target = target_like(options, Deformation::Tension, path({0.01, -0.01, 0.01}, 25));
  target.loading = Loading::Cyclic;
  for (options.seed = 1; options.seed <= 3; ++options.seed) {
    const FitResult result = fit_target(target, options);
    expect_recovered(result, "yield_stress", 317e6);
    expect_recovered(result, "backstress_rate_1", 300.0);
    expect_recovered(result, "saturation_rate", 8.0);
  }
}

TEST(Fit, EveryAlgorithmThatFollowsSlopesFindsTheSame) {
  FitOptions options = fit_with(HardeningLaw::Ideal);
  const Target target = target_like(options, Deformation::Tension, ramp(120, 0.02));
  for (const char* name : {"gauss-newton", "slsqp", "lbfgs", "nelder-mead", "bobyqa", "sbplx"}) {
    options.algorithm = name;
    const FitResult result = fit_target(target, options);
    ASSERT_EQ(result.status, FitStatus::Fitted) << name;
    ASSERT_EQ(result.stages.size(), 1U);
    EXPECT_EQ(result.stages[0].algorithm, name);
    EXPECT_NEAR(result.parameter("yield_stress").value, 317e6, tolerance(317.0)) << name;
  }
}

TEST(Fit, RecoversShearNumbersInTorsion) {
  FitOptions options =
      fit_of({free_parameter("shear_modulus"), free_parameter("shear_yield_stress"),
              free_parameter("break_shear_strain")});
  options.setup.scene.material.shear_modulus = 77e9;
  options.setup.scene.material.shear_yield_stress = 140e6;
  Target target = target_like(options, Deformation::Torsion, ramp(90, 0.04));
  break_at(target, 0.0404, 0.0384);
  const FitResult result = fit_target(target, options);
  expect_recovered(result, "shear_modulus", 77e9);
  expect_recovered(result, "shear_yield_stress", 140e6);
  expect_recovered(result, "break_shear_strain", 0.0402 - 140e6 / 77e9);
  EXPECT_NEAR(result.break_strain_total.value_or(0.0), 0.0402, tolerance(1e-9));
}

TEST(Fit, TranslatesTensionsNumbersInTorsion) {
  FitOptions options = fit_with(HardeningLaw::Ideal, {free_parameter("break_strain")});
  Target target = target_like(options, Deformation::Torsion, ramp(90, 0.04));
  break_at(target, 0.0404, 0.0377);
  const FitResult result = fit_target(target, options);
  const double shear_modulus = 190e9 / 2.6;
  expect_recovered(result, "youngs_modulus", 190e9);
  expect_recovered(result, "yield_stress", 317e6);
  expect_recovered(result, "break_strain", (0.0402 - 317e6 / kRoot3 / shear_modulus) / kRoot3);
  EXPECT_NEAR(result.break_strain_total.value_or(0.0), 0.0402, tolerance(1e-9));
}

TEST(Fit, TiesOfYieldStressesHoldInTorsion) {
  // Below 1/sqrt(3) the yield stress is above what it is without a tie.
  for (const double factor : {0.4, 0.5, 0.577, 0.7}) {
    FitOptions options = fit_of({free_parameter("shear_modulus"), free_parameter("yield_stress"),
                                 tied_parameter("shear_yield_stress", "yield_stress", factor)});
    options.setup.scene.material.shear_modulus = 77e9;
    options.setup.scene.material.yield_stress = 317e6;
    options.setup.scene.material.shear_yield_stress = factor * 317e6;
    const Target target = target_like(options, Deformation::Torsion, ramp(90, 0.04));
    const FitResult result = fit_target(target, options);
    expect_recovered(result, "yield_stress", 317e6);
    expect_recovered(result, "shear_yield_stress", factor * 317e6);
    EXPECT_EQ(result.misfit_word, "close") << factor;
  }
}

TEST(Fit, TiesOfBreakLimitsHoldInEveryTest) {
  FitOptions options = fit_with(
      HardeningLaw::Ideal,
      {free_parameter("break_strain"), tied_parameter("break_shear_strain", "break_strain", 2.0)});
  Target tension = target_like(options, Deformation::Tension, ramp(90, 0.04));
  break_at(tension, 0.0404, 0.038);
  expect_recovered(fit_target(tension, options), "break_strain", 0.0402 - 317e6 / 190e9);
  Target torsion = target_like(options, Deformation::Torsion, ramp(90, 0.04));
  break_at(torsion, 0.0404, 0.038);
  const double permanent = 0.0402 - 317e6 / kRoot3 / (190e9 / 2.6);
  const FitResult result = fit_target(torsion, options);
  expect_recovered(result, "break_strain", permanent / 2.0);
  expect_recovered(result, "break_shear_strain", permanent);
  EXPECT_NEAR(result.break_strain_total.value_or(0.0), 0.0402, tolerance(1e-9));
  EXPECT_NEAR(result.parameter("break_strain").standard_error, 0.0002 / kRoot3 / 2.0,
              tolerance(1e-9));
}

TEST(Fit, FullyPlasticCapsRaiseTheStressAndNotTheYieldStress) {
  for (const Deformation test : {Deformation::Bending, Deformation::Torsion}) {
    FitOptions options = fit_with(HardeningLaw::Ideal);
    options.setup.scene.section.shape = SectionShape::Circle;
    options.setup.scene.yield_cap = YieldCap::FullyPlastic;
    const Target target = target_like(options, test, ramp(90, 0.04));
    const FitResult result = fit_target(target, options);
    expect_recovered(result, "youngs_modulus", 190e9);
    expect_recovered(result, "yield_stress", 317e6);
    // Shape factors of a circle: 16/(3 pi) in bending, 4/3 in torsion.
    const double factor =
        test == Deformation::Bending ? 16.0 / (3.0 * 3.14159265358979323846) : 4.0 / 3.0 / kRoot3;
    EXPECT_NEAR(target.corrected.stress.back(), factor * 317e6, tolerance(1.0));
  }
}

TEST(Fit, AccumulatesPermanentStrainOverCycles) {
  FitOptions options = fit_with(HardeningLaw::Ideal, {free_parameter("break_strain")});
  options.setup.scene.break_measure = BreakMeasure::Accumulated;
  Target target = target_like(options, Deformation::Tension, path({0.01, -0.01, 0.006}, 60));
  target.loading = Loading::Cyclic;
  break_at(target, 0.0064, 0.0045);  // at 0.0062
  const FitResult result = fit_target(target, options);
  // The legs are 0.01, 0.02 and 0.0162 long; the way back from yield to yield is elastic.
  const double elastic = 317e6 / 190e9;
  const double accumulated = (0.01 - elastic) + (0.02 - 2.0 * elastic) + (0.0162 - 2.0 * elastic);
  expect_recovered(result, "break_strain", accumulated);
  EXPECT_NEAR(result.break_strain_total.value_or(0.0), 0.0062, tolerance(1e-8));
}

TEST(Fit, LooksForTheBreakInTheDirectionOfTheLastStep) {
  // The specimen ends unbroken on its way down from 1 %, before it yields again: the model breaks
  // on that way, not on a way up.
  FitOptions options = fit_with(HardeningLaw::Ideal, {fixed_parameter("break_strain", 0.02)});
  options.setup.scene.break_measure = BreakMeasure::Accumulated;
  Target target = target_like(options, Deformation::Tension, path({0.01, 0.008}, 60));
  target.loading = Loading::Cyclic;
  const FitResult result = fit_target(target, options);
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
  const double elastic = 317e6 / 190e9;
  const double first = 0.01 - elastic;
  EXPECT_NEAR(result.break_strain_total.value_or(0.0), 0.01 - 2.0 * elastic - (0.02 - first),
              tolerance(1e-8));
}

TEST(Fit, GivesTheSameAnswerFromThreeStarts) {
  // Noise and hardening that the model does not have: the minimum is not exact.
  const std::vector<double> strain = ramp(150, 0.03);
  std::vector<double> stress = ideal_curve(strain, 190e9, 317e6);
  Noise noise(3);
  for (std::size_t i = 0; i < stress.size(); ++i) stress[i] += noise(2e6) + 5e8 * strain[i];
  const Target target = target_of(strain, stress);
  const auto fitted = [&](double modulus, double yield) {
    return fit_target(target, fit_of({free_parameter("youngs_modulus", modulus),
                                      free_parameter("yield_stress", yield)}));
  };
  const FitResult first = fitted(190e9, 300e6);
  for (const auto& [modulus, yield] : {std::pair{80e9, 700e6}, std::pair{500e9, 90e6}}) {
    const FitResult other = fitted(modulus, yield);
    for (const char* name : {"youngs_modulus", "yield_stress"}) {
      const double value = first.parameter(name).value;
      EXPECT_NEAR(other.parameter(name).value, value, tolerance(1e-6 * value)) << name;
    }
  }
}

TEST(Fit, KeepsToTheEvaluationsOfItsStages) {
  FitOptions options = fit_with(HardeningLaw::Ideal);
  Target target = target_like(options, Deformation::Tension, ramp(120, 0.02));
  for (std::size_t i = 0; i < 120; ++i) target.corrected.stress[i] *= 1.0 + 1e-3 * (i % 2 == 0);
  options.parameters[1].value = 250e6;  // away from the answer
  options.stopping.global_evaluations = 0;
  const FitResult local = fit_target(target, options);
  EXPECT_EQ(local.stages.front().algorithm, "gauss-newton");
  options.stopping.global_evaluations = 20;
  options.stopping.local_evaluations = 3;
  const FitResult brief = fit_target(target, options);
  EXPECT_EQ(brief.stages[0].algorithm, "gauss-newton");
  EXPECT_EQ(brief.stages[0].outcome, "maxeval-reached");
  EXPECT_LE(brief.stages[0].evaluations, 3);
  const auto global = std::find_if(brief.stages.begin(), brief.stages.end(),
                                   [](const auto& stage) { return stage.algorithm == "sobol"; });
  ASSERT_LT(global + 1, brief.stages.end());
  EXPECT_EQ(global->evaluations, 20);
  EXPECT_EQ(global[1].outcome, "maxeval-reached");
  EXPECT_LE(global[1].evaluations, 3);
  EXPECT_EQ(brief.trace.values.size(), 2 * brief.trace.costs.size());
  EXPECT_EQ(brief.trace.active, (std::vector<std::uint32_t>{0, 1}));
  // The result is the best point of the trace.
  EXPECT_EQ(brief.cost, *std::min_element(brief.trace.costs.begin(), brief.trace.costs.end()));
}

}  // namespace
}  // namespace plastica::calibrate
