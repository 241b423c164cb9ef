#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "calibrate/inference/score_covariance.hpp"

namespace plastica::calibrate {
namespace {

TEST(ScoreCovariance, OfAnAutoregressionIsItsLongRunVariance) {
  constexpr int kCount = 200000;
  constexpr double kRho = 0.8;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::vector<double> residual;
  double last = 0.0;
  for (int i = 0; i < kCount; ++i) {
    last = kRho * last + normal(random);
    residual.push_back(last);
  }
  const std::vector<double> ones(residual.size(), 1.0);
  const double variance = score_covariance(ones, residual)[0] / kCount;
  // 1/(1 - rho)^2 = 25. Bartlett's weights leave out 2 rho/(1 - rho)^2/L of it, 1.6 % at this n,
  // and chance as much again.
  EXPECT_NEAR(variance, 25.0, 0.05 * 25.0);
}

}  // namespace
}  // namespace plastica::calibrate
