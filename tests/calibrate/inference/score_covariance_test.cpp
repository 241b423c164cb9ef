#include "calibrate/inference/score_covariance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace plastica::calibrate {
namespace {

TEST(ScoreCovariance, OfFourResidualsIsTheSumByHand) {
  const std::vector<double> ones(4, 1.0);
  // Products of neighbours sum to -0.5, squares to 6.25: rho = -0.08, which takes nothing out; L =
  // 1.1447 (0.0259 4)^(1/3) = 0.54, none.
  const std::vector<double> mixed{1.0, 2.0, -1.0, 0.5};
  EXPECT_DOUBLE_EQ(score_covariance(ones, mixed)[0], 6.25);
  // rho = 8/10, and with (1 + 1 + 2.4)/4 more above 0.97: 1.03, 0.06 and -0.94 are left. Their
  // products sum to 0.0618 - 0.0564, squares to 1.9481: L = 0.0. Of 4/3 over 0.03^2.
  const std::vector<double> run{1.0, 2.0, 2.0, 1.0};
  EXPECT_NEAR(score_covariance(ones, run)[0] / (4.0 / 3.0 * 1.9481 / (0.03 * 0.03)), 1.0, 1e-12);
}

// As a filtered load cell leaves them: mean and slope of a short series, 400 times over.
TEST(ScoreCovariance, OfResidualsOfAnAutoregressiveProcessIsThatOfTheirSums) {
  for (const auto& [count, rho] : {std::pair{80, 0.5}, std::pair{160, 0.8}}) {
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    const auto n = static_cast<std::size_t>(count);
    constexpr int kSeries = 400;
    double squares = 0.0, expected = 0.0;
    for (int series = 0; series < kSeries; ++series) {
      std::vector<double> slopes(n, 1.0), residual(n);
      double value = normal(random), mean = 0.0;
      for (double& r : residual) {
        r = value;
        mean += value / count;
        value = rho * value + std::sqrt(1.0 - rho * rho) * normal(random);
      }
      squares += std::pow(count * mean, 2) / kSeries;  // of the sum of the scores
      for (double& r : residual) r -= mean;            // as a fit leaves them
      expected += score_covariance(slopes, residual)[0] / kSeries;
    }
    // Variances of 400 series are known to 7 %, and 1/(1 - rho)^2 of an estimate is some 10 %
    // large; that of the scores themselves was short by half.
    EXPECT_NEAR(expected / squares, 1.0, 0.15) << rho;
  }
}

TEST(ScoreCovariance, OfIndependentResidualsIsTheNormalMatrix) {
  constexpr int kCount = 20000;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> slopes, residual;
  std::array<double, 4> expected{};
  for (int i = 0; i < kCount; ++i) {
    const double x = static_cast<double>(i) / kCount;
    slopes.insert(slopes.end(), {1.0, x});
    residual.push_back(normal(random));
    const std::array<double, 4> products{1.0, x, x, x * x};
    for (std::size_t k = 0; k < 4; ++k) expected[k] += products[k];
  }
  const std::vector<double> covariance = score_covariance(slopes, residual);
  for (std::size_t k = 0; k < 4; ++k) {
    // Four standard deviations of the mean of n squares, and of twice the correlation of
    // neighbours.
    EXPECT_NEAR(covariance[k] / expected[k], 1.0, 4.0 * std::sqrt(6.0 / kCount)) << k;
  }
}

}  // namespace
}  // namespace plastica::calibrate
