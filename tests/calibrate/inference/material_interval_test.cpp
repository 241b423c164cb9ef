#include "calibrate/inference/material_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "calibrate/inference/not_a_number.hpp"

// Intervals of the material: what they are made of.

namespace plastica::calibrate {
namespace {

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

TEST(MaterialInterval, IsNoneWhereSegmentsLeaveOpenAllThatWasSearched) {
  FittedParameter p = parameter(1.0);
  const SegmentsError diverging = segments_error(110.0, 100.0, 70.0, 2.0);
  ASSERT_EQ(diverging.trend, SegmentsTrend::Diverges);
  p.lower = 10.0;  // 70 +- 3 * 40 holds 10 ... 180
  p.upper = 180.0;
  set_material_interval(0.95, {}, diverging, p);
  EXPECT_TRUE(std::isnan(p.standard_error));
  EXPECT_TRUE(std::isnan(p.interval_low) && std::isnan(p.interval_high));
  EXPECT_FALSE(is_of_material(p, diverging));
  p.upper = 500.0;
  set_material_interval(0.95, {}, diverging, p);
  EXPECT_NEAR(p.interval_high, 70.0 + 0.95 * 120.0, 0.1);  // 95 % of an even distribution
}

/// A number near 0 is known as well as any other.
TEST(MaterialInterval, OfANumberNearZeroIsThere) {
  FittedParameter p = parameter(1.7e6);
  p.value = -2.1e6;
  p.lower = -300e6;
  p.upper = 300e6;
  set_material_interval(0.95, {}, segments_error(-3.4e6, -2.1e6, -0.15e6, 2.0), p);
  EXPECT_LT(p.interval_low, 0.0);
  EXPECT_GT(p.interval_high, 0.0);
  EXPECT_GT(p.standard_error, 1.7e6);
}

TEST(MaterialInterval, OfOlderFilesIsKnownByItsPlace) {
  const SegmentsError segments = segments_error(116.0, 104.0, 101.0, 2.0);
  FittedParameter p = parameter(1.0);
  p.value = 104.0;
  set_material_interval(0.95, {}, segments, p);
  EXPECT_TRUE(is_of_material(p, segments));
  p.interval_low = 102.0;
  p.interval_high = 106.0;
  EXPECT_FALSE(is_of_material(p, segments));
  EXPECT_FALSE(is_of_material(p, {}));
}

TEST(MaterialInterval, OfWhatIsNotDeterminedIsNone) {
  FittedParameter p = parameter(kNan);
  set_material_interval(0.95, {}, segments_error(116.0, 104.0, 101.0, 2.0), p);
  EXPECT_TRUE(std::isnan(p.standard_error));
  EXPECT_TRUE(std::isnan(p.interval_low));
}

TEST(VarianceInflation, CountsAlikeNeighboursAsFewerSamples) {
  EXPECT_EQ(variance_inflation(0.0, 100.0, 2), 1.0);
  EXPECT_EQ(variance_inflation(-0.5, 100.0, 2), 1.0);
  EXPECT_NEAR(variance_inflation(0.5, 100.0, 2), 3.0, 1e-12);
  // No fewer are left than the parameters and one.
  EXPECT_NEAR(variance_inflation(1.0, 75.0, 2), 25.0, 1e-12);
  EXPECT_EQ(variance_inflation(0.9, 2.0, 2), 1.0);
}

/// Of a process of that correlation the mean has the error that `misfit_error` makes of its
/// noise's.
TEST(VarianceInflation, IsThatOfTheMeanOfAnAutoregressiveProcess) {
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
  // A variance of 2 000 values is known to 3.2 %, and 400 samples bring 1 % less than many.
  EXPECT_NEAR(squares / kSeeds * kSamples / variance_inflation(kRho, kSamples, 1), 1.0, 0.1);
}

}  // namespace
}  // namespace plastica::calibrate
