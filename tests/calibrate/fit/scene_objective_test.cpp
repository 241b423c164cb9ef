#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/inference/bootstrap.hpp"
#include "tests/calibrate/fit/bilinear_coupon.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

/// How fits through scenes weigh samples, and by which algorithm they search.
namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

/// A curve that ideal plasticity cannot follow, so that the values depend on what counts.
SceneTarget bent_over(const std::vector<double>& strain) {
  SceneTarget target = bilinear_target("bent over", std::vector<double>(strain.size()));
  target.abscissa = strain;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    target.ordinate[i] = bilinear_stress(Bilinear{}, strain[i]);
  }
  return target;
}

/// Strains from 0 to 1, the first of which lie closest.
std::vector<double> closer_and_closer() {
  std::vector<double> strain;
  for (int i = 0; i <= 60; ++i) strain.push_back(std::pow(i / 60.0, 2.0));
  return strain;
}

Setup ideal_coupon() {
  Setup setup = bilinear_coupon();
  setup.scene.material.hardening.law = HardeningLaw::Ideal;
  return setup;
}

SceneFitOptions both(Objective objective) {
  SceneFitOptions options;
  options.parameters = {bounded("material.youngs_modulus", 0.5, 4.5),
                        bounded("material.yield_stress", 0.05, 0.45)};
  options.objective = objective;
  return options;
}

double yield_of(const std::vector<double>& strain, Objective objective) {
  return fit_scene(ideal_coupon(), bent_over(strain), both(objective)).parameters.at(1).value;
}

/// Ten times the samples on a part of the curve: the path does not notice.
TEST(SceneObjective, AlongThePathTheSamplingDoesNotCount) {
  const std::vector<double> even = ramp(101, 1.0);
  std::vector<double> crowded;
  for (std::size_t i = 0; i < even.size(); ++i) {
    crowded.push_back(even[i]);
    for (int k = 1; k < 10 && even[i] > 0.695; ++k) crowded.push_back(even[i] + 0.001 * k);
  }
  while (crowded.back() > 1.0) crowded.pop_back();
  const double path = yield_of(even, Objective::Path);
  EXPECT_NEAR(yield_of(crowded, Objective::Path), path, tolerance(1e-3 * path));
  EXPECT_GT(yield_of(crowded, Objective::LeastSquares), 1.05 * path);
}

/// The other road: the same integral of the same curve as a specimen's.
TEST(SceneObjective, IsThatOfACurveAlone) {
  const SceneTarget unequal = bent_over(closer_and_closer());
  const Target alone = target_of(unequal.abscissa, unequal.ordinate);
  FitOptions options;
  options.setup = ideal_coupon();
  options.parameters = both(Objective::Path).parameters;
  options.modulus_prior = false;
  const FitResult here = fit_target(alone, options);
  const SceneFitResult there = fit_scene(ideal_coupon(), unequal, both(Objective::Path));
  for (const char* name : {"youngs_modulus", "yield_stress"}) {
    EXPECT_NEAR(there.parameter(name).value, here.parameter(name).value,
                tolerance(1e-5 * here.parameter(name).value))
        << name;
  }
}

/// Errors that count the weights: as far as values of noisy curves scatter, and as the errors of
/// least squares where all weights are alike.
TEST(SceneObjective, ErrorsAreTheScatterOfTheValues) {
  constexpr int kCurves = 200;
  constexpr double kNoise = 0.004;
  const std::vector<double> strain = closer_and_closer();
  SceneFitOptions options = both(Objective::Path);
  options.parameters.push_back(bounded("material.hardening.tangent_modulus", 0.01, 1.0));
  options.starts = 1;
  std::vector<double> sum(3, 0.0), squares(3, 0.0), errors(3, 0.0);
  double noise = 0.0;
  for (int k = 0; k < kCurves; ++k) {
    Draws draws(7, static_cast<std::uint64_t>(k));
    SceneTarget target = bent_over(strain);
    for (double& stress : target.ordinate) stress += kNoise * draws.normal();
    const SceneFitResult fit = fit_scene(bilinear_coupon(), target, options);
    ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
    noise += fit.targets[0].noise * fit.targets[0].noise / kCurves;
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += fit.parameters[i].value;
      squares[i] += std::pow(fit.parameters[i].value, 2);
      errors[i] += std::pow(fit.parameters[i].noise_error, 2);
    }
  }
  EXPECT_NEAR(std::sqrt(noise), kNoise, 0.02 * kNoise);
  for (std::size_t i = 0; i < 3; ++i) {
    const double scatter = std::sqrt((squares[i] - sum[i] * sum[i] / kCurves) / (kCurves - 1.0));
    // Of 200 curves the scatter is known to 5 %.
    EXPECT_NEAR(std::sqrt(errors[i] / kCurves) / scatter, 1.0, 0.15) << i;
  }
}

/// Of what is known of a value the prior's part f is how far it pulls: the value moves by f times
/// what the prior's mean does, whatever the weights.
TEST(SceneObjective, ThePriorsFractionIsItsPull) {
  SceneTarget target = bent_over(closer_and_closer());
  Draws draws(3, 0);
  for (double& stress : target.ordinate) stress += 0.004 * draws.normal();
  target.noise = 0.004;
  const auto fitted = [&](double mean) {
    SceneFitOptions options = both(Objective::Path);
    options.parameters.push_back(bounded("material.hardening.tangent_modulus", 0.01, 1.0));
    options.parameters.back().prior = Prior{mean, 0.002};
    options.starts = 1;
    return fit_scene(bilinear_coupon(), target, options).parameters.at(2);
  };
  const FittedParameter low = fitted(0.0995), high = fitted(0.1005);
  const double pull = (high.value - low.value) / 0.001;
  ASSERT_EQ(low.verdict(), Verdict::FromPrior);
  EXPECT_NEAR(low.verdict_number(), pull, tolerance(0.02));
}

TEST(SceneObjective, AStandstillCountsNextToNothing) {
  std::vector<double> strain = ramp(101, 1.0);
  strain.insert(strain.begin() + 60, 30, strain[60]);
  EXPECT_NEAR(yield_of(strain, Objective::Path), yield_of(ramp(101, 1.0), Objective::Path),
              tolerance(1e-4));
}

/// DIRECT divides the box by three, and ends nowhere in particular.
const std::vector<std::pair<const char*, double>> kAlgorithms = {
    {"gauss-newton", 1e-4}, {"slsqp", 1e-4}, {"lbfgs", 1e-4}, {"bobyqa", 1e-4},
    {"nelder-mead", 1e-4},  {"sbplx", 1e-4}, {"crs", 1e-4},   {"direct-l", 1e-2}};

SceneFitResult found_by(const char* name, const Setup& setup, const SceneTarget& target,
                        std::vector<Parameter> parameters) {
  SceneFitOptions options;
  options.parameters = std::move(parameters);
  options.algorithm = name;
  options.evaluations = 4000;
  return fit_scene(setup, target, options);
}

TEST(SceneAlgorithm, EachFindsWhatTheOthersFind) {
  const SceneTarget target = noisy_bilinear(Bilinear{}, 0.001, 5);
  const std::vector<Parameter> parameters = {
      bounded("material.yield_stress", 0.05, 0.45),
      bounded("material.hardening.tangent_modulus", 0.03, 0.3)};
  const SceneFitResult wanted = found_by("auto", bilinear_coupon(), target, parameters);
  for (const auto& [name, reach] : kAlgorithms) {
    const SceneFitResult found = found_by(name, bilinear_coupon(), target, parameters);
    ASSERT_EQ(found.status, FitStatus::Fitted) << name << ": " << found.reason;
    EXPECT_EQ(found.starts.size(), 1u) << name;
    EXPECT_LE(found.search_runs, 4000) << name;
    for (std::size_t i = 0; i < 2; ++i) {
      const double value = wanted.parameters[i].value;
      EXPECT_NEAR(found.parameters[i].value, value, tolerance(reach * value)) << name;
    }
  }
}

/// A sample that goes from elastic to plastic is a kink of the sum of squares, so that it has many
/// minima where the law cannot follow: no algorithm finds a lower one.
TEST(SceneAlgorithm, NoneFindsALowerMinimum) {
  for (const std::size_t samples : {40u, 50u, 61u, 75u}) {
    const SceneTarget target = bent_over(ramp(samples, 1.0));
    const std::vector<Parameter> parameters = both(Objective::LeastSquares).parameters;
    const double found = found_by("auto", ideal_coupon(), target, parameters).targets.at(0).cost;
    for (const auto& [name, reach] : kAlgorithms) {
      const double other = found_by(name, ideal_coupon(), target, parameters).targets.at(0).cost;
      EXPECT_GE(other, found * (1.0 - 1e-6)) << name << ", " << samples;
    }
  }
}

/// What was not searched stands behind what was: a tied value with the errors of what it follows.
TEST(SceneParametersHeld, AreInTheResultWithTheirErrors) {
  SceneFitOptions options;
  Parameter tied;
  tied.field = &find_field("material.yield_stress");
  tied.role = ParameterRole::Tied;
  tied.tied_to = &find_field("material.youngs_modulus");
  tied.factor = 0.1;
  Parameter fixed;
  fixed.field = &find_field("material.hardening.tangent_modulus");
  fixed.role = ParameterRole::Fixed;
  fixed.value = Bilinear{}.tangent_modulus;
  options.parameters = {tied, fixed, bounded("material.youngs_modulus", 0.5, 4.5)};
  const SceneFitResult fit =
      fit_scene(bilinear_coupon(), noisy_bilinear(Bilinear{}, 0.002, 3), options);
  ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
  ASSERT_EQ(fit.parameters.size(), 3u);
  EXPECT_EQ(fit.free_count(), 1u);
  EXPECT_EQ(fit.correlation.size(), 1u);
  const FittedParameter& modulus = fit.parameters[0];
  EXPECT_NEAR(modulus.value, kBilinearModulus, tolerance(5e-3));
  EXPECT_EQ(fit.parameters[1].role, ParameterRole::Tied);
  EXPECT_DOUBLE_EQ(fit.parameters[1].value, 0.1 * modulus.value);
  EXPECT_DOUBLE_EQ(fit.parameters[1].standard_error, 0.1 * modulus.standard_error);
  EXPECT_DOUBLE_EQ(fit.parameters[1].interval_high, 0.1 * modulus.interval_high);
  EXPECT_EQ(fit.parameters[2].role, ParameterRole::Fixed);
  EXPECT_EQ(fit.parameters[2].value, Bilinear{}.tangent_modulus);
  EXPECT_FALSE(fit.parameters[2].has_error());
}

TEST(SceneAlgorithm, KeepsToItsEvaluations) {
  for (const char* name : {"slsqp", "bobyqa"}) {
    SceneFitOptions options = both(Objective::LeastSquares);
    options.algorithm = name;
    options.evaluations = 12;
    options.segments_error = false;
    const SceneFitResult found = fit_scene(ideal_coupon(), bent_over(ramp(50, 1.0)), options);
    EXPECT_LE(found.starts.at(0).evaluations, 12) << name;
    EXPECT_EQ(found.outcome, LeastSquaresOutcome::EvaluationsReached) << name;
  }
}

TEST(SceneAlgorithm, RefusesWhatIsNone) {
  SceneFitOptions options = both(Objective::LeastSquares);
  options.algorithm = "newton";
  EXPECT_EQ(message_of([&] { (void)fit_scene(ideal_coupon(), bent_over(ramp(50, 1.0)), options); }),
            "fit.algorithm = newton: is not the name of an algorithm");
  options = both(Objective::Path);
  SceneTarget still = bent_over(std::vector<double>(20, 0.3));
  EXPECT_NE(message_of([&] { (void)fit_scene(ideal_coupon(), still, options); }), "");
}

}  // namespace
}  // namespace plastica::calibrate
