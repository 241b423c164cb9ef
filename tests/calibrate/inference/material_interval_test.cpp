#include "calibrate/inference/material_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

// Intervals of the material: what they are made of.

namespace plastica::calibrate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

FittedParameter parameter(double noise, double misfit = 0.0) {
  FittedParameter p;
  p.value = 100.0;
  p.noise_error = noise;
  p.misfit_error = misfit;
  p.degrees_of_freedom = std::numeric_limits<double>::infinity();
  return p;
}

TEST(MaterialInterval, IsStudentsOfNoiseAndLackOfFit) {
  FittedParameter p = parameter(3.0, 4.0);
  set_material_interval(0.95, {}, {}, p);
  EXPECT_DOUBLE_EQ(p.standard_error, 5.0);
  EXPECT_NEAR(p.interval_high, 100.0 + 1.959964 * 5.0, 1e-4);
  EXPECT_NEAR(p.interval_low, 100.0 - 1.959964 * 5.0, 1e-4);
  p = parameter(3.0, kNan);  // not known
  p.degrees_of_freedom = 4.0;
  set_material_interval(0.95, {}, {}, p);
  EXPECT_NEAR(p.interval_high, 100.0 + 2.776445 * 3.0, 1e-4);
}

TEST(MaterialInterval, LiesAboutWhatTheSegmentsLeadTo) {
  FittedParameter p = parameter(0.0);
  // Second order from 116, 104, 101: to 100.
  p.value = 104.0;
  set_material_interval(0.95, {}, segments_error(116.0, 104.0, 101.0, 2.0), p);
  EXPECT_NEAR(0.5 * (p.interval_low + p.interval_high), 100.0, 1e-9);
  EXPECT_NEAR(p.interval_high, 100.0 + 0.95 * 1.25, 1e-9);  // evenly likely
  EXPECT_NEAR(p.standard_error, 1.25 * 4.0 / std::sqrt(3.0), 1e-9);
}

TEST(MaterialInterval, OfWhatIsNotDeterminedIsNone) {
  FittedParameter p = parameter(kNan);
  set_material_interval(0.95, {}, segments_error(116.0, 104.0, 101.0, 2.0), p);
  EXPECT_TRUE(std::isnan(p.standard_error));
  EXPECT_TRUE(std::isnan(p.interval_low));
}

TEST(MisfitError, CountsAlikeNeighboursAsFewerSamples) {
  EXPECT_EQ(misfit_error(2.0, 0.0, 100.0, 2), 0.0);
  EXPECT_EQ(misfit_error(2.0, -0.5, 100.0, 2), 0.0);
  // A third as many samples: sqrt(3) times the error.
  EXPECT_NEAR(std::hypot(2.0, misfit_error(2.0, 0.5, 100.0, 2)), 2.0 * std::sqrt(3.0), 1e-12);
  // No fewer than the parameters and one.
  EXPECT_NEAR(std::hypot(2.0, misfit_error(2.0, 1.0, 75.0, 2)), 2.0 * 5.0, 1e-12);
}

/// Of a process of that correlation the mean has the error that `misfit_error` makes of its
/// noise's.
TEST(MisfitError, IsThatOfTheMeanOfAnAutoregressiveProcess) {
  constexpr double kRho = 0.8;
  constexpr int kSamples = 400, kSeeds = 2000;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  double squares = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    double x = normal(random), sum = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      sum += x;
      x = kRho * x + std::sqrt(1.0 - kRho * kRho) * normal(random);
    }
    squares += sum * sum / (kSamples * kSamples);
  }
  const double noise = 1.0 / std::sqrt(kSamples);
  const double all = std::hypot(noise, misfit_error(noise, kRho, kSamples, 1));
  // A standard deviation of 2 000 is known to 1.6 %.
  EXPECT_NEAR(std::sqrt(squares / kSeeds) / all, 1.0, 0.05);
}

}  // namespace
}  // namespace plastica::calibrate
