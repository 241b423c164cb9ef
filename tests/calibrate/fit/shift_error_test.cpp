#include <gtest/gtest.h>

#include <algorithm>
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

// Without the shift's part the interval of E holds it in 92 of 200.
TEST(ShiftError, IsInTheIntervalsOfAPreloadedCurve) {
  FitOptions options;
  for (const char* name : {"youngs_modulus", "yield_stress"}) {
    Parameter p;
    p.field = &find_field(name);
    options.parameters.push_back(p);
  }
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

TEST(ShiftError, IsNoneWhereNothingWasShifted) {
  TargetOptions options;
  options.preload.mode = CorrectionChoice::Mode::Off;
  EXPECT_EQ(make_target("as it is", preloaded(1), options).shift_error, 0.0);
  options.preload = {CorrectionChoice::Mode::Set, -25e6 / kModulus};
  EXPECT_EQ(make_target("set", preloaded(1), options).shift_error, 0.0);
}

}  // namespace
}  // namespace plastica::calibrate
