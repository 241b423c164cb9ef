#include "calibrate/inference/mean_interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace plastica::calibrate {
namespace {

/// Worked by hand: mean 5, deviation sqrt(20/3), t(0.975; 3) = 3.18245.
TEST(MeanInterval, IsStudentsOfFewSpecimens) {
  const MeanInterval interval = mean_interval({2.0, 8.0, 4.0, 6.0}, {});
  EXPECT_NEAR(interval.standard_error, std::sqrt(20.0 / 3.0) / 2.0, 1e-14);
  EXPECT_NEAR(interval.high - 5.0, 3.18245 * interval.standard_error, 1e-5);
  EXPECT_NEAR(5.0 - interval.low, interval.high - 5.0, 1e-12);
  // Resamples of so few say less.
  EXPECT_EQ(mean_interval({2.0, 8.0, 4.0, 6.0}, {400, 1, 0.95}).low, interval.low);
  EXPECT_LT(mean_interval({2.0, 8.0, 4.0, 6.0}, {0, 1, 0.5}).high, interval.high);
}

TEST(MeanInterval, DoesNotDependOnTheOrder) {
  std::vector<double> values{1.0, 2.0, 4.0, 8.0, 9.0, 11.0, 15.0, 16.0, 21.0, 40.0, 41.0};
  const MeanInterval interval = mean_interval(values, {200, 3, 0.9});
  std::ranges::reverse(values);
  EXPECT_EQ(mean_interval(values, {200, 3, 0.9}).low, interval.low);
  EXPECT_EQ(mean_interval(values, {200, 3, 0.9}).high, interval.high);
  EXPECT_NE(mean_interval(values, {200, 4, 0.9}).high, interval.high);
  const MeanInterval same = mean_interval(std::vector<double>(12, 3.0), {200, 3, 0.9});
  EXPECT_EQ(same.low, 3.0);
  EXPECT_EQ(same.high, 3.0);
}

/// In how many of a thousand groups the interval of 95 % holds the mean.
double coverage(std::size_t n, int resamples, double truth,
                const std::function<double(std::mt19937_64&)>& draw) {
  int held = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<double> values(n);
    for (double& value : values) value = draw(random);
    const MeanInterval interval = mean_interval(values, {resamples, seed, 0.95});
    if (interval.low <= truth && truth <= interval.high) ++held;
  }
  return held / 1000.0;
}

/// Three standard errors of a share of 0.95 among a thousand are 2.1 %.
TEST(MeanInterval, HoldsTheMeanAsOftenAsItSays) {
  const auto normal = [](std::mt19937_64& random) {
    return std::normal_distribution<double>(300.0, 12.0)(random);
  };
  for (const std::size_t n : {3U, 4U, 10U}) EXPECT_NEAR(coverage(n, 0, 300.0, normal), 0.95, 0.021);
  EXPECT_NEAR(coverage(10, 200, 300.0, normal), 0.95, 0.021);
}

/// Break strains are skewed; there Student's t holds less often than the bootstrap.
TEST(MeanInterval, OfSkewedValuesIsBetterByResamples) {
  const auto skewed = [](std::mt19937_64& random) {
    return std::lognormal_distribution<double>(0.0, 1.0)(random);
  };
  const double truth = std::exp(0.5);
  const double student = coverage(20, 0, truth, skewed);
  const double drawn = coverage(20, 200, truth, skewed);
  EXPECT_GT(drawn, student + 0.02);
  EXPECT_GT(drawn, 0.9);
}

}  // namespace
}  // namespace plastica::calibrate
