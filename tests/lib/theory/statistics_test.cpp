#include "plastica/theory/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace plastica::theory {
namespace {

// Expected values by mpmath with 25 digits unless a closed form stands beside them.

TEST(ChiSquared, IsTheDistributionOfSumsOfSquares) {
  // Of two degrees it is exponential, of one the square of a normal variable.
  for (const double p : {1e-6, 0.025, 0.3, 0.5, 0.9, 0.999}) {
    EXPECT_NEAR(chi_squared_quantile(p, 2.0) / (-2.0 * std::log1p(-p)), 1.0, 1e-9) << p;
    EXPECT_NEAR(chi_squared_quantile(p, 1.0) / std::pow(normal_quantile(0.5 + 0.5 * p), 2), 1.0,
                1e-7)
        << p;
    EXPECT_NEAR(chi_squared_cdf(chi_squared_quantile(p, 7.5), 7.5), p, 1e-12);
  }
  // Abramowitz & Stegun, table 26.8.
  EXPECT_NEAR(chi_squared_quantile(0.975, 11.0), 21.9200, 1e-4);
  EXPECT_NEAR(chi_squared_quantile(0.025, 11.0), 3.81575, 1e-5);
  EXPECT_EQ(chi_squared_cdf(0.0, 3.0), 0.0);
  EXPECT_EQ(chi_squared_cdf(std::numeric_limits<double>::infinity(), 3.0), 1.0);
}

TEST(NormalQuantile, MatchesKnownValues) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.995), 2.575829303548901, 1e-13);
  EXPECT_NEAR(normal_quantile(0.3), -0.524400512708041, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-13);
  EXPECT_NEAR(normal_quantile(1e-300), -37.047096299361199, 1e-12);
  EXPECT_EQ(normal_quantile(0.5), 0.0);
}

TEST(NormalQuantile, InvertsTheDistribution) {
  for (const double p : {1e-200, 1e-20, 1e-6, 0.01, 0.2, 0.4999999, 0.5000001, 0.7, 0.999}) {
    EXPECT_NEAR(normal_cdf(normal_quantile(p)) / p, 1.0, 1e-12) << p;
  }
}

TEST(StudentQuantile, OfOneDegreeIsCauchys) {
  for (const double p : {1e-6, 0.01, 0.3, 0.6, 0.975, 0.9999}) {
    const double cauchy = -1.0 / std::tan(std::numbers::pi * p);
    EXPECT_NEAR(student_t_quantile(p, 1.0) / cauchy, 1.0, 1e-9) << p;
  }
}

TEST(StudentQuantile, OfTwoDegreesHasItsClosedForm) {
  for (const double p : {1e-6, 0.01, 0.3, 0.6, 0.975, 0.9999}) {
    const double exact = (2.0 * p - 1.0) / std::sqrt(2.0 * p * (1.0 - p));
    EXPECT_NEAR(student_t_quantile(p, 2.0) / exact, 1.0, 1e-9) << p;
  }
}

TEST(StudentQuantile, MatchesKnownValues) {
  EXPECT_NEAR(student_t_quantile(0.975, 5.0), 2.570581835636316, 1e-9);
  EXPECT_NEAR(student_t_quantile(0.975, 30.0), 2.042272456301238, 1e-9);
  EXPECT_NEAR(student_t_quantile(0.995, 10.0), 3.169272672616951, 1e-9);
  EXPECT_NEAR(student_t_quantile(0.9, 3.0), 1.637744353696210, 1e-9);
  EXPECT_NEAR(student_t_quantile(0.975, 2.5), 3.574654842003683, 1e-9);
  EXPECT_NEAR(student_t_quantile(0.975, 1000.0), 1.962339080826408, 1e-9);
  EXPECT_NEAR(student_t_quantile(0.975, 9999.0), 1.960201263621358, 1e-9);
  EXPECT_NEAR(student_t_quantile(0.975, 10001.0), 1.960201216164651, 1e-9);
  EXPECT_NEAR(student_t_quantile(0.975, 20000.0), 1.960082605158135, 1e-9);
  EXPECT_EQ(student_t_quantile(0.5, 7.0), 0.0);
}

TEST(StudentQuantile, TendsToTheNormalQuantile) {
  EXPECT_EQ(student_t_quantile(0.975, std::numeric_limits<double>::infinity()),
            normal_quantile(0.975));
}

TEST(StudentQuantile, InvertsTheDistributionAndIsOdd) {
  for (const double nu : {0.5, 1.5, 4.0, 77.0, 9000.0}) {
    for (const double p : {1e-5, 0.025, 0.4, 0.6, 0.975}) {
      const double t = student_t_quantile(p, nu);
      EXPECT_NEAR(student_t_cdf(t, nu) / p, 1.0, 1e-9) << nu << " " << p;
      EXPECT_NEAR(student_t_quantile(1.0 - p, nu) / t, -1.0, 1e-9) << nu << " " << p;
    }
  }
}

TEST(StudentDistribution, IsTheIntegralOfItsDensity) {
  // Four degrees: density (3/8)(1 + t^2/4)^(-5/2).
  constexpr int kPoints = 20000;
  const double t = 1.3;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double x = (i + 0.5) * t / kPoints;
    sum += 0.375 * std::pow(1.0 + x * x / 4.0, -2.5) * t / kPoints;
  }
  EXPECT_NEAR(student_t_cdf(t, 4.0), 0.5 + sum, 1e-9);
}

TEST(HalfInterval, IsStudentsWithoutEvenErrors) {
  EXPECT_EQ(half_interval(0.95, 2.0, 7.0, {}), 2.0 * student_t_quantile(0.975, 7.0));
  const std::vector<double> none{0.0, 0.0};
  EXPECT_EQ(half_interval(0.9, 2.0, 7.0, none), 2.0 * student_t_quantile(0.95, 7.0));
}

TEST(HalfInterval, HasClosedFormsOfEvenErrorsAlone) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<double> one{3.0}, two{3.0, 3.0};
  EXPECT_NEAR(half_interval(0.95, 0.0, kInfinity, one), 0.95 * 3.0, 3.0 * 1e-3);
  // A triangle of half width 6.
  EXPECT_NEAR(half_interval(0.95, 0.0, kInfinity, two), 6.0 * (1.0 - std::sqrt(0.05)), 3.0 * 1e-3);
}

TEST(HalfInterval, OfNormalAndEvenErrorHoldsItsConfidence) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto density = [](double x) {
    return std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
  };
  // The integral of the normal distribution function is x cdf(x) + density(x).
  const auto integral = [&](double x) { return x * normal_cdf(x) + density(x); };
  for (const double h : {1e-3, 0.1, 1.0, 5.0, 100.0}) {
    const std::vector<double> halves{h};
    const double q = half_interval(0.95, 1.0, kInfinity, halves);
    const double below = (integral(q + h) - integral(q - h)) / (2.0 * h);
    EXPECT_NEAR(below, 0.975, 1e-9) << h;
  }
}

TEST(HalfInterval, OfStudentsAndEvenErrorHoldsItsConfidence) {
  // Two degrees of freedom: cdf 1/2 + t/(2 sqrt(2 + t^2)), whose integral is (t + sqrt(2 + t^2))/2.
  const auto integral = [](double t) { return 0.5 * (t + std::sqrt(2.0 + t * t)); };
  for (const double scale : {1e-9, 0.01, 1.0, 30.0}) {
    const std::vector<double> halves{2.0};
    const double q = half_interval(0.95, scale, 2.0, halves);
    const double below = scale / 4.0 * (integral((q + 2.0) / scale) - integral((q - 2.0) / scale));
    EXPECT_NEAR(below, 0.975, 1e-8) << scale;
  }
}

TEST(HalfInterval, IsTheSameByItsFormulaAndOnTheGrid) {
  for (const double nu : {1.5, 7.0, 98.0, 1e3, 1e5}) {
    const std::vector<double> one{0.7}, on_the_grid{0.7, 0.0};
    EXPECT_NEAR(half_interval(0.99, 0.4, nu, one), half_interval(0.99, 0.4, nu, on_the_grid), 2e-3)
        << nu;
  }
}

TEST(HalfInterval, OfOneDegreeOfFreedomHoldsItsConfidence) {
  // Cauchy: the integral of the distribution function is x/2 + (x atan x - ln(1 + x^2)/2)/pi.
  const auto integral = [](double x) {
    return 0.5 * x + (x * std::atan(x) - 0.5 * std::log1p(x * x)) / std::numbers::pi;
  };
  const std::vector<double> halves{4.0};
  const double q = half_interval(0.95, 1.0, 1.0, halves);
  EXPECT_NEAR((integral(q + 4.0) - integral(q - 4.0)) / 8.0, 0.975, 5e-4);
  // Degrees of freedom come out of a sum: rounding changes nothing.
  for (const double nu : {std::nextafter(1.0, 2.0), 1.0 + 1e-9, 1.0 - 1e-12}) {
    EXPECT_NEAR(half_interval(0.95, 1.0, nu, halves), q, 1e-3 * q) << nu - 1.0;
  }
}

}  // namespace
}  // namespace plastica::theory
