#include "calibrate/inference/fit_intervals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"
#include "tests/support/sanitized.hpp"

// Intervals of coupon fits: those of profile and bootstrap beside those of the covariance.

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

void add_noise(Target& target, std::uint64_t seed, double deviation) {
  Noise noise(seed);
  for (double& s : target.corrected.stress) s += noise(deviation);
}

/// 200 GPa up to 0.1 %, with noise.
Target elastic_line(double deviation, std::uint64_t seed = 11) {
  const std::vector<double> strain = ramp(40, 0.001);
  std::vector<double> stress;
  for (const double e : strain) stress.push_back(200e9 * e);
  Target target = target_of(strain, stress);
  add_noise(target, seed, deviation);
  return target;
}

/// 200 GPa, 300 MPa, up to 2 %, with noise.
Target plateau(double deviation, std::uint64_t seed = 6, std::size_t samples = 201) {
  const std::vector<double> strain = ramp(samples, 0.02);
  Target target = target_of(strain, ideal_curve(strain, 200e9, 300e6));
  add_noise(target, seed, deviation);
  return target;
}

FitOptions with_intervals(FitOptions options, IntervalOptions intervals) {
  options.intervals = intervals;
  return options;
}

FitOptions modulus_alone() {
  return fit_of({free_parameter("youngs_modulus"), fixed_parameter("yield_stress", 1e12)});
}

FitOptions young_and_yield() {
  return fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
}

BatchFitOptions on_threads(int threads) {
  BatchFitOptions batch;
  batch.threads = threads;
  return batch;
}

TEST(FitIntervals, OfALinearModelAreThoseOfTheCovariance) {
  FitOptions options = with_intervals(modulus_alone(), {.profile = true, .bootstrap = 2000});
  // Along the strain path, equally weighted, weighted, and with a given noise.
  FitOptions equal = options, weighted = options, known = options;
  equal.objective = weighted.objective = known.objective = Objective::LeastSquares;
  weighted.weights = {{0.0003, 4.0}, {0.0008, 0.0}};
  known.noise = 2e6;
  for (const FitOptions& each : {options, equal, weighted, known}) {
    if (kSanitized && (each.noise || each.weights.empty())) continue;
    const FitResult result = fit_target(elastic_line(2e6), each);
    const FittedParameter& p = result.parameter("youngs_modulus");
    const double error = p.standard_error;
    ASSERT_EQ(result.intervals.profiles.size(), 1U);
    const LikelihoodProfile& profile = result.intervals.profiles[0];
    EXPECT_EQ(profile.low_end, ProfileEnd::Crossed);
    EXPECT_EQ(profile.high_end, ProfileEnd::Crossed);
    EXPECT_NEAR(profile.low, p.interval_low, 2e-3 * error);
    EXPECT_NEAR(profile.high, p.interval_high, 2e-3 * error);
    const double factor = (p.interval_high - p.value) / error;
    EXPECT_NEAR(profile.threshold, factor * factor, 1e-9 * profile.threshold);
    // 2000 resamples know a standard error to 1.6 %, an end of 95 % to 6 % of it; 40 samples their
    // own scatter to 11 %. A given noise is not theirs.
    const BootstrapInterval& bootstrap = result.intervals.residuals.intervals[0];
    if (each.noise) continue;
    EXPECT_NEAR(bootstrap.standard_error, error, 0.06 * error);
    EXPECT_NEAR(bootstrap.low, p.value - 1.96 * error, 0.2 * error);
    EXPECT_NEAR(bootstrap.high, p.value + 1.96 * error, 0.2 * error);
  }
}

TEST(FitIntervals, HaveThePathOfTheLeastCost) {
  const FitOptions options = with_intervals(young_and_yield(), {.profile = true});
  const FitResult result = fit_target(plateau(6e6), options);
  ASSERT_EQ(result.intervals.profiles.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const LikelihoodProfile& profile = result.intervals.profiles[k];
    ASSERT_GE(profile.value.size(), 5U);
    ASSERT_EQ(profile.value.size(), profile.rise.size());
    ASSERT_EQ(profile.searched.size(), 2 * profile.value.size());
    for (std::size_t i = 0; i < profile.value.size(); ++i) {
      EXPECT_DOUBLE_EQ(profile.searched[2 * i + k], profile.value[i]);
      EXPECT_GE(profile.rise[i], -1e-3);
      if (i == 0) continue;
      EXPECT_GT(profile.value[i], profile.value[i - 1]);
    }
  }
}

TEST(FitIntervals, OfABreakHaveNoiseAndSampling) {
  FitOptions options =
      with_intervals(fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                             free_parameter("break_strain")}),
                     {.profile = true, .bootstrap = 2000});
  // The sampling, and the noise, says most.
  for (const double half : {1e-3, 1e-6}) {
    if (kSanitized && half < 1e-3) continue;
    Target target = plateau(2e6);
    break_at(target, 0.02 + 2.0 * half, 0.0185);
    const FitResult result = fit_target(target, options);
    const FittedParameter& p = result.parameter("break_strain");
    const double wide = p.interval_high - p.interval_low;
    const LikelihoodProfile& profile = result.intervals.profiles[2];
    EXPECT_EQ(profile.low_end, ProfileEnd::Crossed);
    EXPECT_EQ(profile.high_end, ProfileEnd::Crossed);
    EXPECT_NEAR(profile.high - profile.low, wide, 0.05 * wide);
    const BootstrapInterval& bootstrap = result.intervals.residuals.intervals[2];
    EXPECT_NEAR(bootstrap.standard_error, p.standard_error, 0.1 * p.standard_error);
    EXPECT_NEAR(bootstrap.high - bootstrap.low, wide, 0.1 * wide);
  }
}

TEST(FitIntervals, OfABreakReachAsFarAsTheLikelihoodDoes) {
  // All E and Y on a grid whose squares have risen by no more than the threshold: the least and the
  // largest permanent strain among them. Noise that lets a sample or two yield or not.
  FitOptions options =
      with_intervals(fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                             free_parameter("break_strain")}),
                     {.profile = true});
  options.objective = Objective::LeastSquares;
  options.noise = 20e6;
  Target target = plateau(20e6);
  break_at(target, 0.02, 0.0185);  // at the last sample, for sure
  const FitResult result = fit_target(target, options);
  const Curve& curve = target.corrected;
  const auto squares = [&](double E, double Y) {
    double sum = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const double r = (std::min(E * curve.strain[i], Y) - curve.stress[i]) / 20e6;
      sum += r * r;
    }
    return sum;
  };
  const double E = result.parameter("youngs_modulus").value;
  const double Y = result.parameter("yield_stress").value;
  const LikelihoodProfile& profile = result.intervals.profiles[2];
  const double most = squares(E, Y) + profile.threshold;
  double least = 1.0, largest = 0.0;
  for (int i = -300; i <= 300; ++i) {
    for (int k = -150; k <= 150; ++k) {
      const double e = E * (1.0 + 5e-4 * i), y = Y * (1.0 + 1e-4 * k);
      if (squares(e, y) > most) continue;
      least = std::min(least, 0.02 - y / e);
      largest = std::max(largest, 0.02 - y / e);
    }
  }
  // Steps of the grid move the strain by 0.0015 times 6e-4.
  EXPECT_NEAR(profile.low, least, 1e-6);
  EXPECT_NEAR(profile.high, largest, 1e-6);
}

TEST(FitIntervals, OfABreakThatNothingSearchedMovesAreItsSampling) {
  FitOptions options = with_intervals(
      fit_of({fixed_parameter("youngs_modulus", 200e9), fixed_parameter("yield_stress", 300e6),
              free_parameter("break_strain")}),
      {.profile = true, .bootstrap = 2000});
  Target target = plateau(0.0);
  break_at(target, 0.0206, 0.0188);
  const FitResult result = fit_target(target, options);
  const FittedParameter& p = result.parameter("break_strain");
  const LikelihoodProfile& profile = result.intervals.profiles[0];
  EXPECT_NEAR(profile.high - p.value, 0.95 * 0.0003, 1e-12);
  EXPECT_NEAR(p.value - profile.low, 0.95 * 0.0003, 1e-12);
  EXPECT_TRUE(profile.value.empty());
  // A uniform scatter: its ends are known to a per cent of its width.
  const BootstrapInterval& bootstrap = result.intervals.residuals.intervals[0];
  EXPECT_NEAR(bootstrap.high - p.value, 0.95 * 0.0003, 0.02 * 0.0003);
  EXPECT_NEAR(bootstrap.standard_error, 0.0003 / std::sqrt(3.0), 0.03 * 0.0003);
}

TEST(FitIntervals, AreOneSidedWhereTheCurveSaysNoMore) {
  // It stays elastic: the yield stress is not identifiable, neither below the largest stress nor
  // above it.
  FitOptions options = with_intervals(young_and_yield(), {.profile = true, .bootstrap = 40});
  options.parameters[1].lower = 10e6;
  options.parameters[1].upper = 900e6;
  Target target = elastic_line(1e6);
  target.corrected.stress.back() += 3e6;  // above the line: no sample looks like a plateau
  const FitResult result = fit_target(target, options);
  ASSERT_EQ(result.parameter("yield_stress").judgement->verdict, Verdict::NotIdentified);
  const LikelihoodProfile& profile = result.intervals.profiles[1];
  EXPECT_EQ(profile.high_end, ProfileEnd::Bound);
  EXPECT_EQ(profile.high, 900e6);
  EXPECT_EQ(profile.low_end, ProfileEnd::Crossed);
  EXPECT_GT(profile.low, 190e6);
  EXPECT_LT(profile.low, 201e6);
  EXPECT_TRUE(std::isnan(result.intervals.residuals.intervals[1].low));
  EXPECT_FALSE(std::isnan(result.intervals.residuals.intervals[0].low));
}

TEST(FitIntervals, EndAtABoundWhereTheSolutionIs) {
  FitOptions options = with_intervals(young_and_yield(), {.profile = true});
  options.parameters[1].lower = 100e6;
  options.parameters[1].upper = 295e6;
  const FitResult result = fit_target(plateau(6e6), options);
  EXPECT_TRUE(result.parameter("yield_stress").at_upper);
  const LikelihoodProfile& profile = result.intervals.profiles[1];
  EXPECT_EQ(profile.high_end, ProfileEnd::Bound);
  EXPECT_EQ(profile.high, 295e6);
  EXPECT_EQ(profile.low_end, ProfileEnd::Crossed);
  EXPECT_LT(profile.low, 295e6);
}

TEST(FitIntervals, OfWhatTheCurveCannotShowAreEmpty) {
  const FitOptions options =
      with_intervals(fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                             free_parameter("break_strain")}),
                     {.profile = true, .bootstrap = 20});
  const FitResult result = fit_target(plateau(6e6), options);  // unbroken
  ASSERT_EQ(result.intervals.profiles.size(), 3U);
  EXPECT_TRUE(std::isnan(result.intervals.profiles[2].low));
  EXPECT_TRUE(result.intervals.profiles[2].value.empty());
  EXPECT_TRUE(std::isnan(result.intervals.residuals.intervals[2].low));
  EXPECT_EQ(result.intervals.residuals.failed, 0);
}

TEST(FitIntervals, DoNotChangeTheFit) {
  const Target target = plateau(6e6);
  const FitResult bare = fit_target(target, young_and_yield());
  const FitResult with =
      fit_target(target, with_intervals(young_and_yield(), {.profile = true, .bootstrap = 20}));
  EXPECT_TRUE(bare.intervals.profiles.empty());
  EXPECT_EQ(bare.intervals.residuals.resamples, 0);
  EXPECT_EQ(with.cost, bare.cost);
  EXPECT_EQ(with.trace.costs, bare.trace.costs);
  EXPECT_EQ(with.warnings, bare.warnings);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(with.parameters[i].value, bare.parameters[i].value);
    EXPECT_EQ(with.parameters[i].interval_low, bare.parameters[i].interval_low);
  }
}

TEST(FitIntervals, HaveTheSameBitsForAnyThreadsAndCompany) {
  std::vector<Target> targets;
  for (std::uint64_t i = 0; i < 5; ++i) {
    targets.push_back(plateau(6e6, 20 + i, 60));
    targets.back().name = "bar-" + std::to_string(i);
  }
  const FitOptions options =
      with_intervals(young_and_yield(), {.profile = true, .bootstrap = 40, .block = 3});
  const std::vector<FitResult> one = fit(targets, options, on_threads(1));
  EXPECT_NE(one[0].intervals.residuals.values, one[1].intervals.residuals.values);
  for (const int threads : {2, 3}) {
    const std::vector<FitResult> other = fit(targets, options, on_threads(threads));
    for (std::size_t i = 0; i < targets.size(); ++i) {
      EXPECT_EQ(other[i].intervals.residuals.values, one[i].intervals.residuals.values);
      EXPECT_EQ(other[i].intervals.profiles[1].searched, one[i].intervals.profiles[1].searched);
    }
  }
  const FitResult alone = fit_target(targets[3], options);
  EXPECT_EQ(alone.intervals.residuals.values, one[3].intervals.residuals.values);
  FitOptions seeded = options;
  seeded.seed = 2;
  EXPECT_NE(fit_target(targets[3], seeded).intervals.residuals.values,
            one[3].intervals.residuals.values);
}

TEST(FitIntervals, BelongToTheLawThatIsFitted) {
  FitOptions options = with_intervals(young_and_yield(), {.profile = true, .bootstrap = 20});
  options.laws = {Law::Ideal, Law::Linear};
  const std::vector<Target> targets{plateau(6e6, 6, 60)};
  const std::vector<FitResult> results = fit(targets, options, on_threads(1));
  ASSERT_EQ(results.size(), 2U);
  for (const FitResult& result : results) {
    const std::size_t free = result.free_parameters().size();
    EXPECT_EQ(result.intervals.profiles.size(), free);
    EXPECT_EQ(result.intervals.residuals.intervals.size(), free);
    EXPECT_EQ(result.intervals.residuals.values.size(), 20 * free);
  }
  EXPECT_EQ(results[1].intervals.profiles.size(), 3U);
}

TEST(FitIntervals, OfACurveThatTheModelMeetsAreNarrow) {
  const FitOptions options = with_intervals(young_and_yield(), {.profile = true, .bootstrap = 20});
  const FitResult result = fit_target(plateau(0.0), options);
  for (const LikelihoodProfile& profile : result.intervals.profiles) {
    EXPECT_EQ(profile.low_end, ProfileEnd::Crossed);
    EXPECT_LT(profile.high - profile.low, 1e-6 * profile.high);
  }
}

TEST(FitIntervals, ThatCannotBeFoundLeaveTheFitAndAWarning) {
  const FitOptions options =
      with_intervals(young_and_yield(), {.profile = true, .bootstrap = 20, .block = 61});
  const FitResult result = fit_target(plateau(6e6, 6, 60), options);
  EXPECT_EQ(result.status, FitStatus::Fitted);
  EXPECT_EQ(result.intervals.profiles.size(), 2U);
  EXPECT_EQ(result.intervals.residuals.resamples, 0);
  EXPECT_EQ(std::ranges::count(result.warnings,
                               "there is no bootstrap: blocks of 61 residuals are longer than the "
                               "60 samples"),
            1);
}

TEST(FitIntervals, RefuseWhatCannotBeDrawn) {
  const auto refusal = [&](IntervalOptions intervals) {
    return message_of(
        [&] { fit_target(plateau(6e6), with_intervals(young_and_yield(), intervals)); });
  };
  EXPECT_EQ(refusal({.bootstrap = 19}), "bootstrap = 19: must be 0, for none, or 20 to 1000000");
  EXPECT_EQ(refusal({.block = 0}), "bootstrap_block = 0: must be at least 1");
}

}  // namespace
}  // namespace plastica::calibrate
