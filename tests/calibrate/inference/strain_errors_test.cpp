#include "calibrate/inference/strain_errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/target/make.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::calibrate {
namespace {

double noise_in(const std::vector<double>& strain) {
  return noise_of_strain(strain, turns_of(strain));
}

/// Noise is told from a smooth course and from corners, whatever the course.
TEST(StrainErrors, TellNoiseFromACourse) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 1e-6);
  std::vector<double> sine, triangle;
  for (int i = 0; i < 800; ++i) {
    const double phase = i / 200.0;
    sine.push_back(0.01 * std::sin(2.0 * std::numbers::pi * phase));
    triangle.push_back(0.01 * std::asin(std::sin(2.0 * std::numbers::pi * phase)));
  }
  EXPECT_LT(noise_in(sine), 1e-8);
  EXPECT_LT(noise_in(triangle), 1e-12);
  for (std::size_t i = 0; i < sine.size(); ++i) {
    sine[i] += noise(random);
    triangle[i] += noise(random);
  }
  EXPECT_NEAR(noise_in(sine), 1e-6, 0.1e-6);
  EXPECT_NEAR(noise_in(triangle), 1e-6, 0.1e-6);
  EXPECT_EQ(noise_in(std::vector<double>(20, 0.0)), 0.0);
  EXPECT_EQ(noise_in(std::vector<double>{0.0, 1.0}), 0.0);
}

/// Noise that is as large as the steps, and turns whose peak stands twice.
TEST(StrainErrors, TellNoiseOfTheSizeOfSteps) {
  std::mt19937 random(2);
  for (const double noise : {1e-5, 1e-4, 2e-4}) {
    std::normal_distribution<double> normal(0.0, noise);
    std::vector<double> strain;
    for (int i = 0; i < 4000; ++i) {
      const double there = 0.01 * std::asin(std::sin(2.0 * std::numbers::pi * i / 200.0));
      for (int twice = i % 200 == 50 ? 2 : 1; twice > 0; --twice) {
        strain.push_back(there + normal(random));
      }
    }
    EXPECT_NEAR(noise_in(strain), noise, 0.12 * noise);
  }
}

/// How the strain of a cyclic test is read.
struct Reading {
  double noise = 0.0;       ///< [1]
  double resolution = 0.0;  ///< [1]; 0: exact
  int rows = 1;             ///< of each strain
};

/// Four cycles of 1 % of an ideal-plastic steel, 100 samples from turn to turn.
Target cycles(unsigned seed, const Reading& reading) {
  constexpr double kModulus = 200e9, kYield = 300e6;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  Curve curve;
  double stress = 0.0;
  double before = 0.0;
  const auto add = [&](double strain) {
    stress = std::clamp(stress + kModulus * (strain - before), -kYield, kYield);
    before = strain;
    double read = strain + reading.noise * normal(random);
    if (reading.resolution > 0.0) read = reading.resolution * std::round(read / reading.resolution);
    for (int row = 0; row < reading.rows; ++row) {
      curve.strain.push_back(read);
      curve.stress.push_back(stress + 2e6 * normal(random));
    }
  };
  for (int i = 0; i < 50; ++i) add(0.01 * i / 50.0);
  for (int half = 0; half < 8; ++half) {
    const double sign = half % 2 == 0 ? 1.0 : -1.0;
    for (int i = 0; i < 100; ++i) add(sign * 0.01 * (1.0 - 2.0 * i / 100.0));
  }
  TargetOptions options;
  options.loading = Loading::Cyclic;
  return make_target("cycles", curve, options);
}

/// How many of so many intervals of E hold it, and how wide they are on average [Pa].
struct Held {
  int curves = testing::kSanitized ? 10 : 100;
  int holds = 0;
  double width = 0.0;
};

Held held(const Reading& reading) {
  FitOptions options;
  for (const char* name : {"youngs_modulus", "yield_stress"}) {
    Parameter p;
    p.field = &find_field(name);
    options.parameters.push_back(p);
  }
  Held all;
  for (int seed = 0; seed < all.curves; ++seed) {
    const Target target = cycles(static_cast<unsigned>(seed), reading);
    const FittedParameter e = fit_target(target, options).parameter("youngs_modulus");
    all.holds += e.interval_low <= 200e9 && 200e9 <= e.interval_high ? 1 : 0;
    all.width += (e.interval_high - e.interval_low) / all.curves;
  }
  return all;
}

// Without the turns' part the intervals of E hold it in 63 of 100.
TEST(StrainErrors, AreCountedWhereACyclicTestTurns) {
  const Held noisy = held({.noise = 1e-5});
  EXPECT_GE(noisy.holds, 9 * noisy.curves / 10);
}

/// A resolution that is coarser than the steps is noise; exact strains in two rows each are none,
/// but for what residuals leave room for.
TEST(StrainErrors, CountAResolutionAndHardlyRowsThatRepeat) {
  const Held coarse = held({.noise = 1e-5, .resolution = 2.5e-4});
  EXPECT_GE(coarse.holds, 9 * coarse.curves / 10);
  EXPECT_LT(held({.rows = 2}).width, 3.0 * held({}).width);
}

}  // namespace
}  // namespace plastica::calibrate
