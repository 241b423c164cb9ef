#include "calibrate/inference/intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/calibrate/fit/bilinear_coupon.hpp"
#include "tests/support/message.hpp"
#include "tests/support/sanitized.hpp"

// Intervals of fits through coupons: those of profile and bootstrap beside those of the covariance.

namespace plastica::calibrate {
namespace {

using testing::bilinear_coupon;
using testing::bounded;
using testing::message_of;
using testing::noisy_bilinear;
using testing::yield_and_tangent;

SceneFitOptions yield_options() {
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = yield_and_tangent();
  return options;
}

SceneFitResult fit(const SceneTarget& target, const SceneFitOptions& options) {
  return fit_scene(bilinear_coupon(), target, options);
}

double width(double low, double high) { return high - low; }

TEST(SceneIntervals, OfASmoothCurveAreThoseOfTheCovariance) {
  SceneFitOptions options = yield_options();
  options.intervals = {.profile = true, .bootstrap = 400};
  const SceneFitResult result = fit(noisy_bilinear({}, 0.005, 3), options);
  ASSERT_EQ(result.intervals.profiles.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const FittedParameter& p = result.parameters[i];
    const LikelihoodProfile& profile = result.intervals.profiles[i];
    const BootstrapInterval& bootstrap = result.intervals.residuals.intervals[i];
    const double error = p.standard_error;
    EXPECT_EQ(profile.low_end, ProfileEnd::Crossed);
    EXPECT_EQ(profile.high_end, ProfileEnd::Crossed);
    // Yield lies at a sample or another, so the cost is no parabola to the last per cent.
    EXPECT_NEAR(profile.low, p.interval_low, 0.1 * error);
    EXPECT_NEAR(profile.high, p.interval_high, 0.1 * error);
    // Of 400 resamples the standard error is known to 3.5 %, an end to 14 % of it.
    EXPECT_NEAR(bootstrap.standard_error, error, 0.12 * error);
    EXPECT_NEAR(bootstrap.low, p.interval_low, 0.45 * error);
    EXPECT_NEAR(bootstrap.high, p.interval_high, 0.45 * error);
  }
  EXPECT_EQ(result.intervals.residuals.failed, 0);
  EXPECT_EQ(result.intervals.residuals.values.size(), 800U);
}

TEST(SceneIntervals, HaveThePathOfTheLeastCost) {
  SceneFitOptions options = yield_options();
  options.intervals.profile = true;
  const SceneFitResult result = fit(noisy_bilinear({}, 0.005, 3), options);
  const LikelihoodProfile& profile = result.intervals.profiles[0];
  ASSERT_EQ(profile.value.size(), profile.rise.size());
  ASSERT_EQ(profile.searched.size(), 2 * profile.value.size());
  for (std::size_t i = 0; i < profile.value.size(); ++i) {
    EXPECT_NEAR(profile.searched[2 * i], profile.value[i], 1e-12);
    EXPECT_GE(profile.rise[i], -1e-6);
    if (i == 0) continue;
    EXPECT_GT(profile.value[i], profile.value[i - 1]);
    // Held higher, the yield stress leaves less to the tangent modulus.
    EXPECT_LT(profile.searched[2 * i + 1], profile.searched[2 * i - 1]);
  }
  EXPECT_NEAR(profile.threshold, 3.94, 0.01);  // t^2 of 98 degrees of freedom
}

TEST(SceneIntervals, HaveTheSameBitsForAnyThreads) {
  SceneFitOptions options = yield_options();
  options.parameters.push_back(bounded("break_strain", 1e-3, 10.0));
  options.intervals = {.profile = true, .bootstrap = 40, .block = 3};
  SceneTarget target = noisy_bilinear({}, 0.005, 4, 30);
  target.broke = SceneBreak{1.01, 0.01};
  const SceneFitResult one = fit(target, options);
  for (const int threads : {2, 3}) {
    options.threads = threads;
    const SceneFitResult other = fit(target, options);
    EXPECT_EQ(other.runs, one.runs);
    EXPECT_EQ(other.segment_iterations, one.segment_iterations);
    EXPECT_EQ(other.intervals.residuals.values, one.intervals.residuals.values);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(other.intervals.profiles[i].value, one.intervals.profiles[i].value);
      EXPECT_EQ(other.intervals.profiles[i].searched, one.intervals.profiles[i].searched);
      EXPECT_EQ(other.intervals.profiles[i].low, one.intervals.profiles[i].low);
    }
  }
}

TEST(SceneIntervals, DoNotChangeTheFit) {
  SceneFitOptions options = yield_options();
  const SceneTarget target = noisy_bilinear({}, 0.005, 4, 30);
  const SceneFitResult bare = fit(target, options);
  options.intervals = {.profile = true, .bootstrap = 20};
  const SceneFitResult with = fit(target, options);
  EXPECT_TRUE(bare.intervals.profiles.empty());
  EXPECT_EQ(bare.intervals.residuals.resamples, 0);
  EXPECT_EQ(with.parameters[0].value, bare.parameters[0].value);
  EXPECT_EQ(with.parameters[1].interval_low, bare.parameters[1].interval_low);
  EXPECT_GT(with.runs, bare.runs);
}

TEST(SceneIntervals, AreOneSidedWhereTheCurveSaysNoMore) {
  // A coupon that stays elastic: yield does not lie below 0.12, and anywhere above.
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = {bounded("youngs_modulus", 0.5, 5.0), bounded("yield_stress", 0.02, 1.0)};
  options.parameters[1].value = 0.3;
  options.intervals.profile = true;
  SceneTarget target = noisy_bilinear({.yield_stress = 10.0}, 0.001, 5, 60);
  for (double& strain : target.abscissa) strain *= 0.08;
  target.ordinate.clear();
  Draws draws(5, 0);
  for (const double strain : target.abscissa) {
    target.ordinate.push_back(1.5 * strain + 0.001 * draws.normal());
  }
  const SceneFitResult result = fit(target, options);
  EXPECT_EQ(result.parameters[1].verdict(), Verdict::NotIdentified);
  const LikelihoodProfile& profile = result.intervals.profiles[1];
  EXPECT_EQ(profile.high_end, ProfileEnd::Bound);
  EXPECT_EQ(profile.high, 1.0);
  EXPECT_EQ(profile.low_end, ProfileEnd::Crossed);
  EXPECT_GT(profile.low, 0.11);
  EXPECT_LT(profile.low, 0.121);
}

TEST(SceneIntervals, AreOpenOnBothSidesOfWhatNoCurveDependsOn) {
  SceneFitOptions options = yield_options();
  options.parameters.push_back(bounded("density", 1e3, 1e4));
  options.intervals = {.profile = true, .bootstrap = 20};
  const SceneFitResult result = fit(noisy_bilinear({}, 0.005, 6, 30), options);
  const LikelihoodProfile& profile = result.intervals.profiles[2];
  EXPECT_EQ(profile.low_end, ProfileEnd::Bound);
  EXPECT_EQ(profile.high_end, ProfileEnd::Bound);
  EXPECT_EQ(profile.low, 1e3);
  EXPECT_EQ(profile.high, 1e4);
  EXPECT_EQ(result.intervals.profiles[0].low_end, ProfileEnd::Crossed);
}

TEST(SceneIntervals, EndAtABoundWhereTheSolutionIs) {
  SceneFitOptions options = yield_options();
  options.parameters[1].upper = 0.09;  // of a truth of 0.1
  options.intervals.profile = true;
  const SceneFitResult result = fit(noisy_bilinear({}, 0.005, 3), options);
  EXPECT_TRUE(result.parameters[1].at_bound());
  EXPECT_TRUE(std::isnan(result.parameters[1].interval_low));
  const LikelihoodProfile& profile = result.intervals.profiles[1];
  EXPECT_EQ(profile.high_end, ProfileEnd::Bound);
  EXPECT_EQ(profile.high, 0.09);
  EXPECT_EQ(profile.low_end, ProfileEnd::Crossed);
  EXPECT_LT(profile.low, 0.09);
  EXPECT_GT(profile.low, 0.08);
}

TEST(SceneIntervals, OfABreakHaveNoiseAndSampling) {
  SceneFitOptions options = yield_options();
  options.parameters.push_back(bounded("break_strain", 1e-3, 10.0));
  options.intervals = {.profile = true, .bootstrap = 1000};
  // Coarsely and finely sampled: the sampling, and the noise, says most.
  for (const int samples : {12, 200}) {
    if (testing::kSanitized && samples > 12) continue;
    SceneTarget target = noisy_bilinear({}, 0.01, 8, samples);
    const double half = 0.5 / (samples - 1.0);
    target.broke = SceneBreak{1.0 + half, half};
    const SceneFitResult result = fit(target, options);
    const FittedParameter& p = result.parameters[2];
    const LikelihoodProfile& profile = result.intervals.profiles[2];
    const BootstrapInterval& bootstrap = result.intervals.residuals.intervals[2];
    const double wide = width(p.interval_low, p.interval_high);
    EXPECT_NEAR(width(profile.low, profile.high), wide, 0.02 * wide);
    EXPECT_NEAR(bootstrap.standard_error, p.standard_error, 0.1 * p.standard_error);
    EXPECT_NEAR(width(bootstrap.low, bootstrap.high), wide, 0.1 * wide);
  }
}

TEST(SceneIntervals, OfSpecimensAreTheirScatter) {
  // Eight coupons of unlike yield stress, hardly any noise, one fit: its yield stress is nearly
  // their mean, and the bootstrap's standard error that of a mean of eight drawn from them.
  std::vector<WeightedTarget> targets;
  double squares = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double off = 0.002 * (i - 3.5);
    squares += off * off;
    targets.push_back(
        {bilinear_coupon(), noisy_bilinear({.yield_stress = 0.15 + off}, 1e-5, 10, 60)});
    targets.back().target.name = "coupon " + std::to_string(i);
    targets.back().target.noise = 0.005;
  }
  SceneFitOptions options = yield_options();
  options.intervals = {.bootstrap = 20, .specimens = testing::kSanitized ? 200 : 1000};
  const SceneFitResult result = fit(targets, options);
  EXPECT_NEAR(result.parameters[0].value, 0.15, 1e-4);
  const double scatter = std::sqrt(squares / 8.0) / std::sqrt(8.0);
  const BootstrapInterval& specimens = result.intervals.specimens.intervals[0];
  EXPECT_NEAR(specimens.standard_error, scatter, 0.1 * scatter);
  EXPECT_LT(specimens.low, 0.15 - 1.5 * scatter);
  EXPECT_GT(specimens.high, 0.15 + 1.5 * scatter);
}

/// Two coupons whose yield stresses differ, and two alike whose stress has another name.
std::vector<WeightedTarget> two_kinds() {
  std::vector<WeightedTarget> targets;
  for (const double yield : {0.14, 0.16, 0.15, 0.15}) {
    targets.push_back({bilinear_coupon(), noisy_bilinear({.yield_stress = yield}, 1e-6, 11, 40)});
    targets.back().target.name = "coupon " + std::to_string(targets.size());
    targets.back().target.noise = 0.005;
    if (targets.size() < 3) continue;
    targets.back().setup.scene.probes[0].name = "true stress";
    targets.back().target.ordinate_probe = "true stress";
  }
  return targets;
}

TEST(SceneIntervals, OfSpecimensDrawAsManyOfEachKindAsThereAre) {
  SceneFitOptions options = yield_options();
  options.intervals.specimens = 100;
  const SceneFitResult result = fit(two_kinds(), options);
  const std::vector<double>& values = result.intervals.specimens.values;
  ASSERT_EQ(values.size(), 200U);
  // The alike ones count two in all: only how often either of the others is drawn matters.
  for (std::size_t b = 0; b < 100; ++b) {
    const double yield = values[2 * b];
    EXPECT_NEAR(yield, 0.15 + 0.005 * std::round((yield - 0.15) / 0.005), 2e-4);
  }
}

TEST(SceneIntervals, OfTheFittedCurveAreThoseOfALine) {
  // Stress = E strain: the curve's error is strain sigma/sqrt(sum strain^2).
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = {bounded("youngs_modulus", 0.5, 5.0)};
  SceneTarget target = noisy_bilinear({.yield_stress = 10.0}, 0.0, 5, 50);
  for (std::size_t i = 0; i < 50; ++i) {
    target.abscissa[i] *= 0.09;
    target.ordinate[i] = 1.5 * target.abscissa[i];
  }
  target.noise = 0.001;
  const SceneFitResult result = fit(target, options);
  double squares = 0.0;
  for (const double strain : target.abscissa) squares += strain * strain;
  const TargetFit& of_target = result.targets[0];
  ASSERT_EQ(of_target.fitted_error.size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_NEAR(of_target.fitted_error[i], 0.001 * target.abscissa[i] / std::sqrt(squares), 1e-9);
  }
}

TEST(SceneIntervals, RefuseWhatCannotBeDrawn) {
  const SceneTarget target = noisy_bilinear({}, 0.005, 6, 30);
  const auto refusal = [&](IntervalOptions intervals) {
    SceneFitOptions options = yield_options();
    options.intervals = intervals;
    return message_of([&] { fit(target, options); });
  };
  EXPECT_EQ(refusal({.bootstrap = 19}), "bootstrap = 19: must be 0, for none, or 20 to 1000000");
  EXPECT_EQ(refusal({.block = 0}), "bootstrap_block = 0: must be at least 1");
  EXPECT_EQ(refusal({.block = 31}),
            "bootstrap_block = 31: must be no more than the samples of bilinear");
  EXPECT_EQ(refusal({.specimens = 100}),
            "bootstrap_specimens = 100: needs several targets that share the parameters");
  SceneFitOptions options = yield_options();
  options.intervals.specimens = 100;
  std::vector<WeightedTarget> targets = two_kinds();
  targets.pop_back();
  EXPECT_EQ(message_of([&] { fit(targets, options); }),
            "bootstrap_specimens = 100: needs several targets of each kind, and coupon 3 is the "
            "only one that measures its probe over its abscissa");
}

}  // namespace
}  // namespace plastica::calibrate
