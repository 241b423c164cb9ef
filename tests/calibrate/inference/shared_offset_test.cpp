#include "calibrate/inference/shared_offset.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace plastica::calibrate {
namespace {

/// Residuals of the line through the origin that is fitted to y = 3 x + offset and noise.
struct Line {
  std::vector<double> slopes, residual;

  Line(double offset, double noise, int samples = 40) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> scatter(0.0, 1.0);
    std::vector<double> y;
    double xx = 0.0, xy = 0.0;
    for (int i = 1; i <= samples; ++i) {
      const double x = 0.1 * i;
      slopes.push_back(x);
      y.push_back(3.0 * x + offset + noise * scatter(random));
      xx += x * x;
      xy += x * y.back();
    }
    for (std::size_t i = 0; i < y.size(); ++i) residual.push_back(xy / xx * slopes[i] - y[i]);
  }
};

TEST(SharedOffset, IsFoundBesideAFittedSlope) {
  const Line line(0.7, 0.0);
  const SharedOffset found = shared_offset(line.slopes, line.residual);
  EXPECT_NEAR(found.value, 0.7, 1e-12);
  EXPECT_NEAR(found.of_squares, 1.0, 1e-9);
  EXPECT_TRUE(found.stands_out());
  // The slopes' and the residuals' scale do not matter.
  std::vector<double> scaled = line.slopes;
  for (double& s : scaled) s *= -1e9;
  EXPECT_NEAR(shared_offset(scaled, line.residual).value, 0.7, 1e-9);
}

TEST(SharedOffset, StandsOutOfNoiseOnlyWhereItIsThere) {
  EXPECT_FALSE(shared_offset(Line(0.0, 0.1).slopes, Line(0.0, 0.1).residual).stands_out());
  const Line line(0.2, 0.1);
  const SharedOffset found = shared_offset(line.slopes, line.residual);
  EXPECT_TRUE(found.stands_out());
  // Its standard error, of a line with a constant: s sqrt(1/n + mean^2/sum (x - mean)^2) = 0.032.
  EXPECT_NEAR(found.value, 0.2, 3.0 * 0.032);
  EXPECT_NEAR(found.value / found.errors, 0.032, 0.01);
}

TEST(SharedOffset, IsNoneWhereAParameterIsAConstantAndOfNothing) {
  const std::vector<double> ones(20, 2.0);
  std::vector<double> residual(20, 0.0);
  for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = i % 2 == 0 ? 1.0 : -1.0;
  EXPECT_EQ(shared_offset(ones, residual).errors, 0.0);
  EXPECT_FALSE(shared_offset({}, {}).stands_out());
  EXPECT_FALSE(shared_offset({}, std::vector<double>(5, 0.0)).stands_out());
}

}  // namespace
}  // namespace plastica::calibrate
