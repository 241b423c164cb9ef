#include "plastica/theory/elastica.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/reference/reference_table.hpp"

namespace plastica::theory {
namespace {

using std::numbers::pi;

TEST(Elastica, UnderATipForceMatchesTheReferenceTable) {
  const testing::ReferenceTable table("elastica-cantilever/tip_dead_load.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double alpha = table.at("alpha_PL2_over_EI", i);
    SCOPED_TRACE(alpha);
    const ElasticaTip tip = elastica_tip_force(alpha);
    // Twelve printed digits.
    EXPECT_NEAR(tip.slope, table.at("tip_slope_rad", i), 1e-11);
    EXPECT_NEAR(tip.deflection, table.at("deflection_over_L", i), 1e-12);
    EXPECT_NEAR(tip.position, table.at("horizontal_position_x_over_L", i), 1e-12);
  }
}

TEST(Elastica, UnderATipMomentMatchesTheReferenceTable) {
  const testing::ReferenceTable table("elastica-cantilever/tip_moment_rollup.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double turns = table.at("lambda_ML_over_2piEI", i);
    SCOPED_TRACE(turns);
    const ElasticaTip tip = elastica_tip_moment(2.0 * pi * turns);
    EXPECT_NEAR(tip.position, table.at("tip_x_over_L", i), 1e-12);
    EXPECT_NEAR(tip.deflection, table.at("tip_y_over_L", i), 1e-12);
    EXPECT_NEAR(tip.slope, table.at("tip_rotation_rad", i), 1e-12);
  }
}

TEST(Elastica, TendsToItsSeriesForSmallLoads) {
  for (const double alpha : {1e-8, 1e-5, 1e-3}) {
    SCOPED_TRACE(alpha);
    const ElasticaTip tip = elastica_tip_force(alpha);
    // What is left out is of the order alpha^4 of each.
    const double tolerance = alpha * alpha * alpha * alpha + 1e-13;
    EXPECT_NEAR(tip.slope / (alpha / 2.0), 1.0, alpha * alpha);
    EXPECT_NEAR(tip.deflection / (alpha / 3.0 - 4.0 * alpha * alpha * alpha / 105.0), 1.0,
                tolerance);
    EXPECT_NEAR(tip.position, 1.0 - alpha * alpha / 15.0, tolerance);
  }
  EXPECT_EQ(elastica_tip_force(0.0).position, 1.0);
}

TEST(Elastica, HangsStraightDownUnderALargeLoad) {
  // The bend at the clamp becomes short: y/L -> 1 - (2 - sqrt 2)/sqrt alpha, x/L -> sqrt(2/alpha).
  const ElasticaTip tip = elastica_tip_force(1e4);
  EXPECT_NEAR(tip.slope, pi / 2.0, 1e-15);
  EXPECT_NEAR(tip.deflection, 1.0 - (2.0 - std::numbers::sqrt2) / 100.0, 1e-14);
  EXPECT_NEAR(tip.position, std::numbers::sqrt2 / 100.0, 1e-14);
}

TEST(Elastica, IsTheSolutionOfItsEquationIntegratedInSteps) {
  // Runge-Kutta from the tip, s = 0, where theta' = 0, to the clamp: theta'' = -alpha cos theta.
  const double alpha = 7.0;
  const ElasticaTip tip = elastica_tip_force(alpha);
  constexpr int kSteps = 2000;
  const double h = 1.0 / kSteps;
  double theta = tip.slope, kappa = 0.0, x = 0.0, y = 0.0;  // kappa = d theta/ds from the tip
  for (int i = 0; i < kSteps; ++i) {
    const double t1 = kappa, k1 = -alpha * std::cos(theta);
    const double t2 = kappa + 0.5 * h * k1, k2 = -alpha * std::cos(theta + 0.5 * h * t1);
    const double t3 = kappa + 0.5 * h * k2, k3 = -alpha * std::cos(theta + 0.5 * h * t2);
    const double t4 = kappa + h * k3, k4 = -alpha * std::cos(theta + h * t3);
    const double middle = theta + h * (t1 / 2.0 + h * k1 / 8.0);
    const double next = theta + h / 6.0 * (t1 + 2.0 * t2 + 2.0 * t3 + t4);
    x += h / 6.0 * (std::cos(theta) + 4.0 * std::cos(middle) + std::cos(next));
    y += h / 6.0 * (std::sin(theta) + 4.0 * std::sin(middle) + std::sin(next));
    theta = next;
    kappa += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  EXPECT_NEAR(theta, 0.0, 1e-9);  // the clamp
  EXPECT_NEAR(x, tip.position, 1e-8);
  EXPECT_NEAR(y, tip.deflection, 1e-8);
}

TEST(CarlsonIntegrals, HaveTheirKnownValues) {
  EXPECT_NEAR(carlson_rf(2.0, 2.0, 2.0), 1.0 / std::numbers::sqrt2, 1e-15);
  EXPECT_NEAR(carlson_rd(2.0, 2.0, 2.0), 1.0 / (2.0 * std::numbers::sqrt2), 1e-15);
  EXPECT_NEAR(carlson_rf(0.0, 1.0, 1.0), pi / 2.0, 1e-14);
  // The first lemniscate constant, Gamma(1/4)^2/(4 sqrt(2 pi)).
  EXPECT_NEAR(carlson_rf(0.0, 1.0, 2.0), std::pow(std::tgamma(0.25), 2) / std::sqrt(32.0 * pi),
              1e-14);
  // The second: R_D(0, 2, 1) = 3 pi/(4 times the first).
  EXPECT_NEAR(carlson_rd(0.0, 2.0, 1.0), 3.0 * pi / (4.0 * carlson_rf(0.0, 1.0, 2.0)), 1e-13);
}

}  // namespace
}  // namespace plastica::theory
