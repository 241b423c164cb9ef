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

/// Breaks that all lie between the same two samples: anywhere within h, and no more specimens tell
/// where. 95 % of a uniform distribution are 0.95 h.
TEST(MeanInterval, OfBreaksBetweenTheSameSamplesHasTheirWholeDistance) {
  for (const std::size_t n : {2U, 20U, 200U}) {
    const MeanInterval interval = mean_interval(std::vector<double>(n, 3.0), {}, 0.2);
    EXPECT_NEAR(interval.high, 3.19, 1e-9) << n;
    EXPECT_NEAR(interval.low, 2.81, 1e-9) << n;
    EXPECT_NEAR(interval.sampling_error, 0.2 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(interval.standard_error, 0.2 / std::sqrt(3.0), 1e-15);
  }
}

/// A fraction p of the breaks one interval of 2 h higher: next to the border they are all off by
/// h |1 - 2 p|.
TEST(MeanInterval, OfBreaksAboutASampleKnowsHowFarTheyMayBeOff) {
  const std::vector<double> values{1.0, 1.0, 1.0, 3.0};
  const MeanInterval interval = mean_interval(values, {}, 1.0);
  EXPECT_NEAR(interval.sampling_error, 0.5 / std::sqrt(3.0), 1e-15);
  EXPECT_GT(interval.high, mean_interval(values, {}).high);
  // Of breaks that scatter over several samples it is part of their scatter.
  const MeanInterval wide = mean_interval({1.0, 3.0, 5.0, 9.0}, {}, 1.0);
  EXPECT_EQ(wide.sampling_error, 0.0);
  EXPECT_EQ(wide.high, mean_interval({1.0, 3.0, 5.0, 9.0}, {}).high);
}

/// Breaks of any scatter, seen between samples a distance of 1 apart, at any place beside them. Of
/// those whose truth is drawn the interval holds the mean nearly as often as it says, or more often
/// where they scatter little; without the distance it holds it hardly ever.
TEST(MeanInterval, HoldsTheMeanOfBreaksBetweenSamples) {
  for (const double scatter : {0.0, 0.1, 0.3, 1.0}) {
    for (const std::size_t n : {3U, 20U}) {
      int held = 0, without = 0;
      for (unsigned seed = 0; seed < 250; ++seed) {
        std::mt19937_64 random(seed);
        const double truth = std::uniform_real_distribution<double>(5.0, 6.0)(random);
        std::normal_distribution<double> normal;
        std::vector<double> values(n);
        for (double& value : values) value = std::floor(truth + scatter * normal(random)) + 0.5;
        const auto holds = [&](const MeanInterval& interval) {
          return interval.low <= truth && truth <= interval.high ? 1 : 0;
        };
        held += holds(mean_interval(values, {}, 0.5));
        without += holds(mean_interval(values, {}));
      }
      EXPECT_GT(held, 227) << scatter << ' ' << n;  // 95 % less three standard errors
      if (scatter == 0.0) {
        EXPECT_EQ(without, 0) << scatter << ' ' << n;
      }
    }
  }
}

}  // namespace
}  // namespace plastica::calibrate
