#include "calibrate/inference/bootstrap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace plastica::calibrate {
namespace {

TEST(Draws, AreThoseOfSeedAndIndex) {
  Draws one(7, 3), same(7, 3), other_index(7, 4), other_seed(8, 3);
  const std::uint64_t first = one.bits();
  EXPECT_EQ(first, same.bits());
  EXPECT_NE(first, other_index.bits());
  EXPECT_NE(first, other_seed.bits());
  EXPECT_EQ(one.uniform(), same.uniform());
}

TEST(Draws, AreEvenAndNormal) {
  // Means of 1e5: within five of their standard errors.
  constexpr int kCount = 100'000;
  double uniform = 0.0, normal = 0.0, squares = 0.0, third = 0.0;
  for (int i = 0; i < kCount; ++i) {
    Draws draws(1, static_cast<std::uint64_t>(i));  // the first of each: indices do not go together
    uniform += draws.uniform() / kCount;
    const double z = draws.normal();
    normal += z / kCount;
    squares += z * z / kCount;
    third += draws.below(3) == 2 ? 1.0 / kCount : 0.0;
  }
  const double root = std::sqrt(static_cast<double>(kCount));
  EXPECT_NEAR(uniform, 0.5, 5.0 * std::sqrt(1.0 / 12.0) / root);
  EXPECT_NEAR(normal, 0.0, 5.0 / root);
  EXPECT_NEAR(squares, 1.0, 5.0 * std::sqrt(2.0) / root);
  EXPECT_NEAR(third, 1.0 / 3.0, 5.0 * std::sqrt(2.0 / 9.0) / root);
}

TEST(DrawnResiduals, AreCentredAndInflated) {
  const std::vector<double> residual{1.0, 2.0, 3.0, 6.0};  // mean 3
  Draws draws(1, 0);
  std::set<double> seen;
  for (int i = 0; i < 50; ++i) {
    for (const double r : drawn_residuals(residual, 2.0, 1, draws)) seen.insert(r);
  }
  EXPECT_EQ(seen, (std::set<double>{-4.0, -2.0, 0.0, 6.0}));
}

TEST(DrawnResiduals, OfBlocksKeepTheirNeighbours) {
  std::vector<double> residual;
  for (int i = 0; i < 12; ++i) residual.push_back(i - 5.5);
  Draws draws(1, 0);
  bool goes_round = false;
  for (int k = 0; k < 40; ++k) {
    const std::vector<double> drawn = drawn_residuals(residual, 1.0, 4, draws);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (i % 4 == 0) continue;
      const double step = drawn[i] - drawn[i - 1];
      EXPECT_TRUE(step == 1.0 || step == -11.0);
      goes_round = goes_round || step == -11.0;
    }
  }
  EXPECT_TRUE(goes_round);
}

TEST(BootstrapInterval, HasThePercentilesOfTheValues) {
  std::vector<double> values;
  for (int i = 99; i >= 1; --i) values.push_back(i);
  // (99 + 1) 0.05 = the 5th, (99 + 1) 0.95 = the 95th.
  const BootstrapInterval found = bootstrap_interval(values, 0.9);
  EXPECT_DOUBLE_EQ(found.low, 5.0);
  EXPECT_DOUBLE_EQ(found.high, 95.0);
  EXPECT_DOUBLE_EQ(found.standard_error, std::sqrt(99.0 * 100.0 / 12.0));
  // Between two of them.
  EXPECT_DOUBLE_EQ(bootstrap_interval({1.0, 2.0, 4.0}, 0.25).low, 1.5);
}

TEST(BootstrapInterval, SaysNothingOfASingleValue) {
  EXPECT_TRUE(std::isnan(bootstrap_interval({1.0}, 0.95).low));
  EXPECT_TRUE(std::isnan(bootstrap_interval({}, 0.95).standard_error));
}

TEST(Bootstrap, OfALinearModelHasTheCovariancesErrors) {
  // a + b t of 40 samples: the resampled estimates have exactly the covariance s^2 (J^T J)^-1 with
  // s^2 = sum r^2/(m - n) over all resamples; of 4000 its root within 5/sqrt(2 4000) = 5.6 %.
  constexpr std::size_t kSamples = 40;
  LeastSquaresProblem problem;
  problem.lower = {-10.0, -10.0};
  problem.upper = {10.0, 10.0};
  problem.start = {0.0, 0.0};
  problem.residuals = kSamples;
  Draws noise(5, 0);
  std::vector<double> y;
  for (std::size_t i = 0; i < kSamples; ++i) {
    y.push_back(1.0 + 2.0 * static_cast<double>(i) / kSamples + 0.1 * noise.normal());
  }
  problem.evaluate = one_by_one([&y](std::span<const double> x, std::span<double> r) {
    for (std::size_t i = 0; i < kSamples; ++i) {
      r[i] = x[0] + x[1] * static_cast<double>(i) / kSamples - y[i];
    }
    return true;
  });
  const LeastSquares best = minimize_squares(problem, {});
  double s0 = 0.0, s1 = 0.0, s2 = 0.0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double t = static_cast<double>(i) / kSamples;
    s0 += 1.0;
    s1 += t;
    s2 += t * t;
  }
  const double variance = best.cost / (kSamples - 2);
  const double error_b = std::sqrt(variance * s0 / (s0 * s2 - s1 * s1));
  std::vector<double> values;
  for (std::uint64_t b = 0; b < 4000; ++b) {
    Draws draws(1, b);
    std::vector<double> shift = drawn_residuals(best.residual, std::sqrt(40.0 / 38.0), 1, draws);
    for (std::size_t i = 0; i < kSamples; ++i) shift[i] -= best.residual[i];
    LeastSquaresProblem resampled = changed(problem, std::vector<double>(kSamples, 1.0), shift);
    resampled.start = best.x;
    values.push_back(minimize_squares(resampled, {}).x[1]);
  }
  const BootstrapInterval found = bootstrap_interval(values, 0.95);
  EXPECT_NEAR(found.standard_error, error_b, 0.056 * error_b);
  // The mean of 40 residuals is close to normal; percentiles of 4000 are off by 3 % of the error.
  EXPECT_NEAR(found.low, best.x[1] - 1.96 * error_b, 0.15 * error_b);
  EXPECT_NEAR(found.high, best.x[1] + 1.96 * error_b, 0.15 * error_b);
}

}  // namespace
}  // namespace plastica::calibrate
