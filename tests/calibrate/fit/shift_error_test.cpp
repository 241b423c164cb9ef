#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "calibrate/fit/fit.hpp"
#include "calibrate/target/make.hpp"
#include "tests/support/sanitized.hpp"

/// A shift of the strain that the elastic line decides has an error of its own.
namespace plastica::calibrate {
namespace {

constexpr double kModulus = 200e9;
constexpr double kYieldStress = 300e6;

/// Ideal plastic, with normal noise of the stress; zeroed at 25 MPa.
Curve preloaded(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.5e6);
  Curve curve;
  const double begin = 25e6 / kModulus;
  const double knee = kYieldStress / kModulus;
  for (int i = 0; i < 55; ++i) curve.strain.push_back(begin + (knee - begin) * i / 55.0);
  for (int i = 0; i < 140; ++i) curve.strain.push_back(knee + (0.03 - knee) * i / 139.0);
  for (double& strain : curve.strain) {
    curve.stress.push_back(std::min(kModulus * strain, kYieldStress) + noise(random));
    strain -= begin;
  }
  return curve;
}

/// E and the yield stress are free.
FitOptions elastic_fit() {
  FitOptions options;
  for (const char* name : {"youngs_modulus", "yield_stress"}) {
    Parameter p;
    p.field = &find_field(name);
    options.parameters.push_back(p);
  }
  return options;
}

// Without the shift's part the interval of E holds it in 92 of 200.
TEST(ShiftError, IsInTheIntervalsOfAPreloadedCurve) {
  const FitOptions options = elastic_fit();
  int shifted = 0;
  int holds = 0;
  constexpr int kCurves = testing::kSanitized ? 20 : 100;
  for (unsigned seed = 0; seed < kCurves; ++seed) {
    const Target target = make_target("preloaded", preloaded(seed));
    shifted += target.shift_error > 0.0 ? 1 : 0;
    const FitResult fit = fit_target(target, options);
    const FittedParameter& e = fit.parameter("youngs_modulus");
    ASSERT_TRUE(e.has_error());
    holds += e.interval_low <= kModulus && kModulus <= e.interval_high ? 1 : 0;
  }
  EXPECT_EQ(shifted, kCurves);
  EXPECT_GE(holds, 9 * kCurves / 10);
}

/// Ideal plastic, its elastic part of 40 samples.
/// @param shift  of the strain
/// @param scatter  of the stress [Pa]
Curve beside(unsigned seed, double shift, double scatter = 3e6) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, scatter);
  Curve curve;
  const double knee = kYieldStress / kModulus;
  for (int i = 0; i < 40; ++i) curve.strain.push_back(knee * i / 40.0);
  for (int i = 0; i < 140; ++i) curve.strain.push_back(knee + (0.03 - knee) * i / 139.0);
  for (double& strain : curve.strain) {
    curve.stress.push_back(std::min(kModulus * strain, kYieldStress) + noise(random));
    strain += shift;
  }
  return curve;
}

// A zero that is off by too little for a correction: counted as nothing, the intervals of E hold it
// in 26, 1 and 22 of 100 curves.
TEST(ShiftError, IsWhatTheLineMissesTheOriginBy) {
  const FitOptions options = elastic_fit();
  constexpr int kCurves = testing::kSanitized ? 20 : 100;
  for (const double shift : {0.0, 2e-5, -5e-5, 9e-5}) {
    int holds = 0;
    for (unsigned seed = 0; seed < kCurves; ++seed) {
      const Target target = make_target("beside", beside(seed, shift));
      EXPECT_GT(target.shift_error, 0.0);
      const FittedParameter e = fit_target(target, options).parameter("youngs_modulus");
      holds += e.interval_low <= kModulus && kModulus <= e.interval_high ? 1 : 0;
    }
    EXPECT_GE(holds, 9 * kCurves / 10) << shift;
  }
}

/// The strain's zero moves all parameters as a fit of the curve that is moved does: the break
/// strain, too, by what is left of the shift of its strain and of the elastic strain at the break.
TEST(ShiftError, CountsWhatAShiftMoves) {
  FitOptions options = elastic_fit();
  Parameter p;
  p.field = &find_field("break_strain");
  options.parameters.push_back(p);
  options.modulus_prior = false;  // its size hangs on the residuals
  Curve curve = beside(3, 0.0, 1e4);
  curve.strain.push_back(curve.strain.back() + 1e-9);
  curve.stress.push_back(0.0);
  const Target target = make_target("broken", curve);
  const auto moved = [&](double by, double error) {
    Target other = target;
    for (double& strain : other.corrected.strain) strain += by;
    other.characteristics.observed_break->last_intact_strain += by;
    other.characteristics.observed_break->first_broken_strain += by;
    other.shift_error = error;
    return fit_target(other, options);
  };
  constexpr double kShift = 1e-5;
  const FitResult more = moved(kShift, 0.0), less = moved(-kShift, 0.0);
  const FitResult with = moved(0.0, kShift), without = moved(0.0, 0.0);
  const auto ratio = [&](const char* name) {
    const double off = 0.5 * (more.parameter(name).value - less.parameter(name).value);
    const double added = std::sqrt(std::pow(with.parameter(name).standard_error, 2.0) -
                                   std::pow(without.parameter(name).standard_error, 2.0));
    return added / std::fabs(off);
  };
  // The sample at the knee is elastic on one side of it, which makes 3.5 % of E. The break strain
  // moves by 1.5 shifts with E and back by one with its own strain: three times as much of it.
  EXPECT_NEAR(ratio("youngs_modulus"), 1.0, 0.05);
  EXPECT_NEAR(ratio("break_strain"), 1.0, 0.15);
}

TEST(ShiftError, IsNoneWhereNothingWasShifted) {
  TargetOptions options;
  options.preload.mode = CorrectionChoice::Mode::Off;
  EXPECT_EQ(make_target("as it is", preloaded(1), options).shift_error, 0.0);
  options.preload = {CorrectionChoice::Mode::Set, -25e6 / kModulus};
  EXPECT_EQ(make_target("set", preloaded(1), options).shift_error, 0.0);
}

}  // namespace
}  // namespace plastica::calibrate
