#include "calibrate/inference/score_covariance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace plastica::calibrate {
namespace {

TEST(ScoreCovariance, OfFourResidualsIsTheSumByHand) {
  const std::vector<double> ones(4, 1.0);
  // Products of neighbours sum to -0.5, squares to 6.25: rho = -0.08, L = 1.1447 (0.0259 4)^(1/3)
  // = 0.54, none.
  const std::vector<double> mixed{1.0, 2.0, -1.0, 0.5};
  EXPECT_DOUBLE_EQ(score_covariance(ones, mixed)[0], 6.25);
  // rho = 8/10, a = 19.75, L = 4.9, held to 3: weights 3/4, 1/2, 1/4 of 8, 4 and 1.
  const std::vector<double> run{1.0, 2.0, 2.0, 1.0};
  EXPECT_NEAR(score_covariance(ones, run)[0], 10.0 + 2.0 * (6.0 + 2.0 + 0.25), 1e-12);
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
    // Four standard deviations of the mean of n squares.
    EXPECT_NEAR(covariance[k] / expected[k], 1.0, 4.0 * std::sqrt(2.0 / kCount)) << k;
  }
}

}  // namespace
}  // namespace plastica::calibrate
