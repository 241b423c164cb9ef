#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/inference/lack_of_fit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

constexpr double kElasticSlope = 190e9;
constexpr double kSlopeError = 0.02 * kElasticSlope;  // the hidden errors alone

/// A target whose elastic slope was measured.
Target with_slope(std::vector<double> strain, std::vector<double> stress) {
  Target target = target_of(std::move(strain), std::move(stress));
  target.characteristics.youngs_modulus = kElasticSlope;
  target.characteristics.youngs_modulus_stderr = 0.0;
  target.characteristics.modulus_method = "regression";
  return target;
}

FitOptions elastic() {
  FitOptions options = fit_of({free_parameter("youngs_modulus")});
  options.setup.scene.material.yield_stress = 1e12;
  options.objective = Objective::LeastSquares;
  return options;
}

/// 200 GPa and residuals that change their sign: neighbours are not alike.
Target alternating(double size) {
  std::vector<double> strain = ramp(40, 0.001), stress;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    stress.push_back(200e9 * strain[i] + (i % 2 == 0 ? size : -size));
  }
  return with_slope(strain, stress);
}

/// n ln f + z^2 of an elastic curve.
double deviance(const Target& target, double modulus) {
  const Curve& curve = target.corrected;
  double squares = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    squares += std::pow(modulus * curve.strain[i] - curve.stress[i], 2);
  }
  const auto n = static_cast<double>(curve.size());
  return n * std::log(squares / n) + std::pow((modulus - kElasticSlope) / kSlopeError, 2);
}

TEST(WeighModulus, FindsTheLeastOfTheLikelihoodWithThePrior) {
  for (const double size : {2e6, 20e6, 60e6}) {
    const Target target = alternating(size);
    const FitResult result = fit_target(target, elastic());
    ASSERT_EQ(result.status, FitStatus::Fitted);
    // By thirds, to a millionth.
    double low = 150e9, high = 250e9;
    while (high - low > 1e4) {
      const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
      (deviance(target, a) < deviance(target, b) ? high : low) =
          deviance(target, a) < deviance(target, b) ? b : a;
    }
    EXPECT_NEAR(result.parameter("youngs_modulus").value, low, tolerance(2e6)) << size;
    ASSERT_TRUE(result.modulus_prior);
    EXPECT_EQ(result.modulus_prior->mean, kElasticSlope);
    // Its start is still that of the search.
    EXPECT_EQ(result.parameter("youngs_modulus").start, fit_target(target,
                                                                   [] {
                                                                     FitOptions without = elastic();
                                                                     without.modulus_prior = false;
                                                                     return without;
                                                                   }())
                                                            .parameter("youngs_modulus")
                                                            .start);
  }
}

/// Errors of both add up: with k the prior's part of the curvature, (1 - k) s_fit + k s_prior.
TEST(WeighModulus, AddsTheErrorsOfCurveAndSlope) {
  const Target target = alternating(20e6);
  const FitResult result = fit_target(target, elastic());
  double square = 0.0, squares = 0.0;
  const double modulus = result.parameter("youngs_modulus").value;
  for (std::size_t i = 0; i < 40; ++i) {
    const double e = target.corrected.strain[i];
    square += e * e;
    squares += std::pow(modulus * e - target.corrected.stress[i], 2);
  }
  const double of_fit = std::sqrt(squares / 39.0 / square);
  const double information = square / 40.0;
  const double of_prior = result.modulus_prior->variance / (kSlopeError * kSlopeError);
  const double k = of_prior / (information + of_prior);
  EXPECT_NEAR(result.parameter("youngs_modulus").noise_error, (1.0 - k) * of_fit + k * kSlopeError,
              tolerance(1e-6 * kSlopeError));
}

TEST(WeighModulus, LeavesACurveThatTheLawMeetsExactly) {
  const std::vector<double> strain = ramp(60, 0.004);
  const Target target = with_slope(strain, ideal_curve(strain, 200e9, 400e6));
  const FitResult result = fit_target(
      target, fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")}));
  EXPECT_NEAR(result.parameter("youngs_modulus").value, 200e9, tolerance(1e-6 * 200e9));
}

/// A law that cannot follow bends its elastic part; with the slope it does not.
TEST(WeighModulus, HoldsALawThatCannotFollowToTheSlope) {
  const std::vector<double> strain = ramp(200, 0.02);
  std::vector<double> stress;
  for (const double e : strain) {
    const double elastic = 190e9 * e;
    stress.push_back(
        elastic < 250e6 ? elastic : 250e6 + 150e6 * (1.0 - std::exp(-300.0 * (e - 250e6 / 190e9))));
  }
  const Target target = with_slope(strain, stress);
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  const FitResult with = fit_target(target, options);
  options.modulus_prior = false;
  const FitResult without = fit_target(target, options);
  EXPECT_FALSE(without.modulus_prior);
  EXPECT_LT(without.parameter("youngs_modulus").value, 0.75 * kElasticSlope);
  EXPECT_NEAR(with.parameter("youngs_modulus").value, kElasticSlope, kSlopeError);
  EXPECT_LT(with.parameter("youngs_modulus").standard_error, 2.0 * kSlopeError);
  EXPECT_GT(with.misfit_rms, without.misfit_rms) << "the misfit is the curve's alone";
}

/// A window that is not straight: quarters of 200, 200, 160 and 160 GPa, or a slip between two
/// lines of 200.
TEST(WeighModulus, TrustsASlopeAsFarAsItsWindowIsStraight) {
  const std::vector<double> strain = ramp(101, 0.002);
  const auto deviation_of = [&](const std::vector<double>& stress) {
    Target target = with_slope(strain, stress);
    target.characteristics.modulus_window_low = 0.0;
    target.characteristics.modulus_window_high = stress.back();
    return modulus_prior(target, elastic())->standard_deviation;
  };
  std::vector<double> straight, bent, slipped;
  for (const double e : strain) {
    straight.push_back(kElasticSlope * e);
    bent.push_back(std::min(200e9 * e, 200e9 * 0.0008889 + 160e9 * (e - 0.0008889)));
    slipped.push_back(200e9 * (e < 0.001 ? e : e < 0.0011 ? 0.001 : e - 1e-4));
  }
  EXPECT_NEAR(deviation_of(straight), kSlopeError, tolerance(1e-6 * kSlopeError));
  // Each is 20 GPa off the mean: sqrt(4 20^2/(4 3)).
  EXPECT_NEAR(deviation_of(bent), std::hypot(kSlopeError, 20e9 / std::sqrt(3.0)),
              tolerance(0.03 * 12e9));
  EXPECT_GT(deviation_of(slipped), 2.0 * kSlopeError);
  // What leans on such a slope says so.
  Target target = with_slope(strain, slipped);
  target.characteristics.modulus_window_high = slipped.back();
  const std::vector<std::string> warnings = fit_target(target, elastic()).warnings;
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& warning) {
    return warning.find("leans on an elastic slope that is known to") != std::string::npos;
  }));
}

TEST(WeighModulus, IsOfAFreeModulusAndASlopeOfTheCurvesOwn) {
  const Target target = alternating(2e6);
  FitOptions options = elastic();
  EXPECT_TRUE(modulus_prior(target, options));
  options.modulus_prior = false;
  EXPECT_FALSE(modulus_prior(target, options));
  options = fit_of({fixed_parameter("youngs_modulus", 200e9), free_parameter("yield_stress")});
  EXPECT_FALSE(modulus_prior(target, options));
  Target other = target;
  other.characteristics.modulus_method = "given";
  EXPECT_FALSE(modulus_prior(other, elastic()));
  other = target;
  other.test = Deformation::Bending;
  EXPECT_FALSE(modulus_prior(other, elastic()));
}

}  // namespace
}  // namespace plastica::calibrate
