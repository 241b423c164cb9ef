// Recovery: synthetic ideal-plastic curves with a break, made with known parameters that span all
// engineering materials, must give these parameters back. PLASTICA_STUDY=full runs 1 000 curves of
// each kind, =sample the first 100 of the same seeds.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/target/make.hpp"
#include "tests/calibrate/target/curves.hpp"

namespace plastica::calibrate {
namespace {

std::size_t cases() {
  const char* study = std::getenv("PLASTICA_STUDY");
  return study != nullptr && std::string(study) == "full" ? 1000 : 100;
}

/// An ideal-plastic specimen and how it was sampled.
struct Specimen {
  double modulus = 0.0;
  double yield = 0.0;
  double break_strain = 0.0;   ///< permanent
  double last_interval = 0.0;  ///< strain between the last intact and the first broken sample
  Curve curve;
};

double log_uniform(std::mt19937_64& random, double low, double high) {
  std::uniform_real_distribution<double> exponent(std::log(low), std::log(high));
  return std::exp(exponent(random));
}

/// @param elastic  samples on the elastic part, without the one at zero
/// @param plateau  samples on the plateau before the break
Specimen make_specimen(std::mt19937_64& random, int elastic, int plateau, double noise) {
  Specimen s;
  s.yield = log_uniform(random, 1e6, 3e9);
  s.modulus = log_uniform(random, 1e9, 400e9);
  s.break_strain = log_uniform(random, 0.001, 0.5);
  const double yield_strain = s.yield / s.modulus;
  const double total = yield_strain + s.break_strain;
  std::uniform_real_distribution<double> part(0.02, 0.98);
  std::normal_distribution<double> error(0.0, noise * s.yield);
  const auto add = [&](double strain) {
    const double stress = std::min(s.modulus * strain, s.yield);
    s.curve.strain.push_back(strain);
    s.curve.stress.push_back(stress + (noise > 0.0 ? error(random) : 0.0));
  };
  add(0.0);
  const double before = part(random);
  for (int i = 1; i <= elastic; ++i) add(yield_strain * (i - 1 + before) / elastic);
  // The break falls anywhere between the last intact sample and the next.
  const double interval = s.break_strain / (plateau - 1 + part(random));
  for (int i = 0; i < plateau; ++i) add(yield_strain + interval * i);
  s.last_interval = interval;
  s.curve.strain.push_back(s.curve.strain.back() + interval);
  s.curve.stress.push_back(0.0);
  EXPECT_GT(s.curve.strain.back(), total);
  return s;
}

FitOptions all_free() {
  FitOptions options;
  for (const char* name : {"youngs_modulus", "yield_stress", "break_strain"}) {
    Parameter p;
    p.field = &find_field(name);
    options.parameters.push_back(p);
  }
  return options;
}

TEST(Recovery, GivesYieldStressAndBreakStrainBackWithoutNoise) {
  std::mt19937_64 random(20240117);
  std::uniform_int_distribution<int> elastic(5, 40);
  std::uniform_int_distribution<int> plateau(5, 200);
  std::size_t recovered = 0;
  double worst_yield = 0.0;
  double worst_break = 0.0;
  for (std::size_t i = 0; i < cases(); ++i) {
    const Specimen s = make_specimen(random, elastic(random), plateau(random), 0.0);
    const Target target =
        make_target("recovery-" + std::to_string(i), s.curve, testing::any_numbers());
    const FitResult fit = fit_target(target, all_free());
    if (fit.status != FitStatus::Fitted) {
      ADD_FAILURE() << i << ": E " << s.modulus << " yield " << s.yield << " break "
                    << s.break_strain << " samples " << s.curve.size() << ": " << fit.reason;
      continue;
    }
    const double yield_error = std::fabs(fit.parameter("yield_stress").value / s.yield - 1.0);
    const double break_error =
        std::fabs(fit.parameter("break_strain").value - s.break_strain) / s.last_interval;
    worst_yield = std::max(worst_yield, yield_error);
    worst_break = std::max(worst_break, break_error);
    const bool good = yield_error <= 1e-6 && break_error <= 0.5 * (1.0 + 1e-6);
    recovered += good ? 1 : 0;
    EXPECT_TRUE(good) << i << ": E " << s.modulus << " yield " << s.yield << " break "
                      << s.break_strain << " samples " << s.curve.size() << " errors "
                      << yield_error << " " << break_error;
  }
  std::printf(
      "recovered %zu of %zu; largest error of the yield stress %.2g, of the break strain "
      "%.3f sample intervals\n",
      recovered, cases(), worst_yield, worst_break);
}

TEST(Recovery, CallsCurvesTooCoarseInsteadOfFittingThem) {
  std::mt19937_64 random(7);
  std::uniform_int_distribution<int> few(2, 4);    // one, at yield, is no plateau: a brittle bar
  std::uniform_int_distribution<int> fewer(0, 2);  // with those at zero and at yield: 4 at most
  std::uniform_int_distribution<int> enough(6, 60);
  for (std::size_t i = 0; i < cases(); ++i) {
    const bool on_plateau = i % 2 == 0;
    const Specimen s = make_specimen(random, on_plateau ? enough(random) : fewer(random),
                                     on_plateau ? few(random) : enough(random), 0.0);
    const Target target =
        make_target("coarse-" + std::to_string(i), s.curve, testing::any_numbers());
    EXPECT_EQ(target.status, TargetStatus::TooCoarse)
        << i << " " << s.curve.size() << (on_plateau ? " plateau " : " elastic ") << target.reason;
    const FitResult fit = fit_target(target, all_free());
    EXPECT_EQ(fit.status, FitStatus::Rejected);
    EXPECT_FALSE(fit.reason.empty());
  }
}

TEST(Recovery, CoversTheTrueYieldStressInTheStatedFractionOfNoisyCurves) {
  std::mt19937_64 random(99);
  std::uniform_int_distribution<int> elastic(10, 40);
  std::uniform_int_distribution<int> plateau(20, 200);
  std::size_t fitted = 0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < cases(); ++i) {
    const Specimen s = make_specimen(random, elastic(random), plateau(random), 0.01);
    const Target target =
        make_target("noisy-" + std::to_string(i), s.curve, testing::any_numbers());
    const FitResult fit = fit_target(target, all_free());
    if (fit.status != FitStatus::Fitted) {
      ADD_FAILURE() << i << ": " << fit.reason;
      continue;
    }
    const FittedParameter& yield = fit.parameter("yield_stress");
    ++fitted;
    covered += yield.interval_low <= s.yield && s.yield <= yield.interval_high ? 1 : 0;
  }
  const double fraction = static_cast<double>(covered) / static_cast<double>(fitted);
  std::printf("95 %% interval covers the truth in %.1f %% of %zu\n", 100.0 * fraction, fitted);
  // 2.9 standard deviations of a fraction of 0.95 among 1 000; as many among the sample's.
  const double chance = 2.9 * std::sqrt(0.95 * 0.05 / static_cast<double>(cases()));
  EXPECT_NEAR(fraction, 0.95, chance);
}

}  // namespace
}  // namespace plastica::calibrate
