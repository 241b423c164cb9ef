#include "calibrate/fit/fit_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/fit/hardening_targets.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

std::vector<std::string> names_of(const std::vector<Parameter>& parameters) {
  std::vector<std::string> names;
  for (const Parameter& p : parameters) names.push_back(p.name());
  return names;
}

using Names = std::vector<std::string>;

FitOptions modulus_and_yield() {
  return fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
}

TEST(Law, FreesItsOwnParameters) {
  const FitOptions options = modulus_and_yield();
  const auto names = [&](Law law, Loading loading) {
    return names_of(options_of(law, options, loading).parameters);
  };
  const auto monotonic = Loading::Monotonic;
  EXPECT_EQ(names(Law::Ideal, monotonic), (Names{"youngs_modulus", "yield_stress"}));
  EXPECT_EQ(names(Law::Linear, monotonic),
            (Names{"youngs_modulus", "yield_stress", "tangent_modulus"}));
  EXPECT_EQ(names(Law::Linear, Loading::Cyclic),
            (Names{"youngs_modulus", "yield_stress", "tangent_modulus", "kinematic_fraction"}));
  EXPECT_EQ(names(Law::Voce, monotonic),
            (Names{"youngs_modulus", "yield_stress", "saturation_stress", "saturation_rate"}));
  EXPECT_EQ(names(Law::Chaboche, monotonic).size(), 8U);
}

TEST(Law, KeepsWhatTheFitFixesAndLeavesOutWhatOthersHave) {
  FitOptions options = modulus_and_yield();
  options.parameters.push_back(fixed_parameter("saturation_rate", 12.0));
  options.parameters.push_back(free_parameter("backstress_rate_1"));
  options.parameters.push_back(tied_parameter("backstress_rate_2", "backstress_rate_1", 0.1));
  EXPECT_EQ(names_of(options_of(Law::Ideal, options, Loading::Cyclic).parameters),
            (Names{"youngs_modulus", "yield_stress"}));
  const FitOptions voce = options_of(Law::Voce, options, Loading::Cyclic);
  EXPECT_EQ(names_of(voce.parameters),
            (Names{"youngs_modulus", "yield_stress", "saturation_rate", "saturation_stress"}));
  EXPECT_EQ(voce.parameters[2].role, ParameterRole::Fixed);
  const FitOptions chaboche = options_of(Law::Chaboche, options, Loading::Cyclic);
  EXPECT_EQ(chaboche.parameters[4].role, ParameterRole::Tied);
  EXPECT_EQ(law_of(chaboche.setup.scene.material.hardening, chaboche.parameters), Law::Chaboche);
  EXPECT_EQ(law_of(voce.setup.scene.material.hardening, voce.parameters), Law::Voce);
}

TEST(Law, IsRefusedByNameIfThereIsNone) {
  const std::vector<std::string> wrong{"ideal", "ludwik"};
  EXPECT_EQ(message_of([&] { (void)laws_of(wrong, "--laws"); }),
            "--laws = ludwik: is no law; there are ideal, linear, voce, chaboche, multilinear");
  const std::vector<std::string> twice{"voce", "voce"};
  EXPECT_EQ(message_of([&] { (void)laws_of(twice, "--laws"); }), "--laws = voce: is named twice");
}

TEST(Law, IsOfferedTheNextOnesInTheRow) {
  const auto monotonic = Loading::Monotonic;
  EXPECT_EQ(laws_to_try(Law::Ideal, monotonic, {}), "ideal,linear,voce");
  EXPECT_EQ(laws_to_try(Law::Ideal, Loading::Cyclic, {}), "ideal,linear,voce,chaboche");
  EXPECT_EQ(laws_to_try(Law::Voce, monotonic, {}), "voce,chaboche");
  EXPECT_EQ(laws_to_try(Law::Chaboche, Loading::Cyclic, {}), "");
  const std::vector<Law> tried{Law::Ideal, Law::Linear, Law::Voce};
  EXPECT_EQ(laws_to_try(Law::Ideal, monotonic, tried), "");
}

TEST(FitLaw, FindsTheLawThatMadeTheCurve) {
  FitOptions options = modulus_and_yield();
  options.laws = {Law::Ideal, Law::Linear, Law::Voce};
  const std::vector<Target> targets{voce_target()};
  const std::vector<FitResult> results = fit(targets, options);
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(results[2].law, Law::Voce);
  EXPECT_NEAR(results[2].misfit_rms, 1e6, tolerance(0.1e6));
  EXPECT_NEAR(results[2].parameter("saturation_stress").value, 150e6, tolerance(2e6));
  EXPECT_GT(results[2].runs_test_p, kFewRuns);
  EXPECT_TRUE(results[2].warnings.empty()) << results[2].warnings.front();
  EXPECT_LT(results[1].runs_test_p, kFewRuns);
  EXPECT_GT(results[0].misfit_rms, results[1].misfit_rms);
}

TEST(FitLaw, WidensTheIntervalsOfALawThatCannotFollow) {
  const Target target = voce_target();
  const auto modulus = [&](Law law, const std::optional<double>& noise = {}) {
    FitOptions options = modulus_and_yield();
    options.objective = Objective::LeastSquares;
    options.noise = noise;
    return fit_law(target, options, law).parameter("youngs_modulus");
  };
  // With the curve's own law noise is all that is left.
  const FittedParameter voce = modulus(Law::Voce);
  EXPECT_EQ(voce.misfit_error, 0.0);
  EXPECT_DOUBLE_EQ(voce.standard_error, voce.noise_error);
  EXPECT_NEAR(voce.value, 200e9, 1.96 * voce.standard_error);
  // Ideal plasticity follows the elastic part too flat, by many errors of noise.
  const FittedParameter ideal = modulus(Law::Ideal);
  EXPECT_LT(ideal.value + 3.0 * ideal.noise_error, 200e9);
  EXPECT_LT(ideal.interval_low, 200e9);
  EXPECT_GT(ideal.interval_high, 200e9);
  // The same of a stated noise, which the residuals exceed by far.
  const FittedParameter stated = modulus(Law::Ideal, 1e6);
  EXPECT_LT(stated.noise_error, 0.1 * ideal.noise_error);
  EXPECT_NEAR(stated.standard_error / ideal.standard_error, 1.0, 0.02);
}

TEST(FitLaw, IsNoWorseThanTheSimplerLawThatItContains) {
  FitOptions options = modulus_and_yield();
  // One evaluation is no search: what is found is where it began.
  options.algorithm = "slsqp";
  options.stopping.local_evaluations = 1;
  const Target target = voce_target();
  const FitResult ideal = fit_law(target, options, Law::Ideal);
  const FitResult linear = fit_law(target, options, Law::Linear);
  EXPECT_LE(linear.cost, ideal.cost * (1.0 + 1e-6));
  // Where Voce and Chaboche begin is worse than where the simpler law does; they begin again where
  // they have no effect of their own.
  for (const Law law : {Law::Voce, Law::Chaboche}) {
    const FitResult result = fit_law(target, options, law);
    const FitResult simpler = fit_law(target, options, law == Law::Voce ? Law::Ideal : Law::Voce);
    EXPECT_LE(result.cost, simpler.cost * (1.0 + 1e-6)) << name_of(law);
    EXPECT_EQ(result.simpler_evaluations, simpler.evaluations() + simpler.simpler_evaluations);
    EXPECT_EQ(result.trace.values.size(), result.evaluations() * result.trace.active.size());
  }
}

TEST(FitLaw, SaysWhereGivenBoundsKeepItFromTheSimplerLaw) {
  FitOptions options = modulus_and_yield();
  options.parameters.push_back(free_parameter("saturation_stress"));
  options.parameters.back().lower = 50e6;
  options.parameters.back().upper = 200e6;
  options.parameters.push_back(fixed_parameter("saturation_rate", 100.0));
  const FitResult voce = fit_law(softening_target(), options, Law::Voce);
  EXPECT_TRUE(std::ranges::any_of(voce.warnings, [](const std::string& text) {
    return text.find("ends with a larger misfit than") != std::string::npos;
  }));
}

TEST(FitLaw, KeepsAStatedNoiseForTheComparison) {
  FitOptions options = modulus_and_yield();
  EXPECT_FALSE(fit_law(voce_target(), options, Law::Ideal).noise);
  options.objective = Objective::LeastSquares;
  options.noise = 1e6;
  EXPECT_EQ(fit_law(voce_target(), options, Law::Ideal).noise, 1e6);
}

// Voce with Q = -80 MPa, b = 20, worked in small steps that know nothing of the library.
TEST(Law, FindsThatACyclicCurveSoftens) {
  const std::vector<double> strain = path({0.008, -0.008, 0.01, -0.01, 0.012, -0.012, 0.012}, 60);
  std::vector<double> stress;
  double plastic = 0.0, passed = 0.0, before = 0.0;
  Noise noise(12);
  for (const double to : strain) {
    constexpr int kSteps = 500;
    for (int i = 1; i <= kSteps; ++i) {
      const double e = before + (to - before) * i / kSteps;
      const double yield = 350e6 - 80e6 * (1.0 - std::exp(-20.0 * passed));
      const double slope = -80e6 * 20.0 * std::exp(-20.0 * passed);
      const double tried = 200e9 * (e - plastic);
      const double step = (std::abs(tried) - yield) / (200e9 + slope);
      if (step <= 0.0) continue;
      plastic += std::copysign(step, tried);
      passed += step;
    }
    before = to;
    stress.push_back(200e9 * (to - plastic) + noise(1e6));
  }
  Target target = target_of(strain, stress);
  target.loading = Loading::Cyclic;
  FitOptions options = modulus_and_yield();
  options.laws = {Law::Voce};
  const FitResult result = fit_law(target, options, Law::Voce);
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
  const FittedParameter& q = result.parameter("saturation_stress");
  const FittedParameter& b = result.parameter("saturation_rate");
  EXPECT_NEAR(q.value, -80e6, 4.0 * q.standard_error);
  EXPECT_NEAR(b.value, 20.0, 4.0 * b.standard_error);
  EXPECT_LT(q.standard_error, 4e6);
  EXPECT_EQ(result.misfit_word, "close");
}

}  // namespace
}  // namespace plastica::calibrate
