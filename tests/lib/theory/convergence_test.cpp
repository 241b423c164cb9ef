#include "plastica/theory/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "tests/support/message.hpp"

namespace plastica::theory {
namespace {

using testing::message_of;

std::vector<double> halved(double coarsest, int count) {
  std::vector<double> sizes;
  for (int i = 0; i < count; ++i) sizes.push_back(std::ldexp(coarsest, -i));
  return sizes;
}

std::vector<double> power(const std::vector<double>& sizes, double constant, double order) {
  std::vector<double> errors;
  for (const double h : sizes) errors.push_back(constant * std::pow(h, order));
  return errors;
}

std::vector<bool> mask(const std::string& text) {
  std::vector<bool> used;
  for (const char c : text) used.push_back(c == '1');
  return used;
}

TEST(ObservedOrder, IsExactForAPowerLaw) {
  const std::vector<double> sizes{0.5, 0.3, 0.2, 0.05, 0.011};
  for (const double order : {0.5, 1.0, 2.0, 3.7}) {
    const OrderFit fit = observed_order(sizes, power(sizes, -3.0, order), {.scale = 1e-6});
    ASSERT_TRUE(fit.order);
    EXPECT_NEAR(*fit.order, order, 1e-13);
    EXPECT_NEAR(*fit.constant, 3.0, 1e-12);
    EXPECT_NEAR(*fit.correlation, 1.0, 1e-14);
    EXPECT_EQ(fit.points, 5U);
  }
}

TEST(ObservedOrder, IsTheSlopeOfLeastSquares) {
  // x = 0, 1, 2 and y = 0, 2, 3 in powers of e: slope 3/2, r = 3/sqrt(2 * 14/3).
  const double e = std::numbers::e;
  const OrderFit fit =
      observed_order(std::vector{1.0, e, e * e}, std::vector{1.0, e * e, e * e * e});
  EXPECT_NEAR(*fit.order, 1.5, 1e-14);
  EXPECT_NEAR(*fit.constant, std::exp(1.0 / 6.0), 1e-14);
  EXPECT_NEAR(*fit.correlation, 3.0 / std::sqrt(28.0 / 3.0), 1e-14);
}

TEST(ObservedOrder, DoesNotDependOnTheOrderOfTheInput) {
  const std::vector<double> sizes{0.25, 1.0, 0.125, 0.5};
  const std::vector<double> errors{1.1e-12, 1e-2, 3e-12, 1e-7};
  const OrderFit fit = observed_order(sizes, errors);
  EXPECT_EQ(fit.used, mask("1101"));
  const OrderFit sorted =
      observed_order(std::vector{1.0, 0.5, 0.25, 0.125}, std::vector{1e-2, 1e-7, 1.1e-12, 3e-12});
  EXPECT_EQ(sorted.used, mask("1110"));
  EXPECT_EQ(*fit.order, *sorted.order);
}

TEST(ObservedOrder, LeavesOutTheFloorOfRounding) {
  // Central difference of sin at 1: error h^2 cos(1)/6 until eps/h takes over.
  std::vector<double> errors;
  const std::vector<double> sizes = halved(0.25, 22);
  for (const double h : sizes) {
    errors.push_back((std::sin(1.0 + h) - std::sin(1.0 - h)) / (2.0 * h) - std::cos(1.0));
  }
  const OrderFit fit = observed_order(sizes, errors);
  EXPECT_NEAR(*fit.order, 2.0, 0.01);
  EXPECT_GE(fit.points, 12U);
  EXPECT_LE(fit.points, 18U);
  EXPECT_FALSE(fit.used.back());
}

TEST(ObservedOrder, LeavesOutTheFloorOfATolerance) {
  // Iterations that end at 1e-11 leave errors of that size, of any sign, and no more order.
  const std::vector<double> errors{1e-3,    6.2e-5, 3.9e-6, 2.44e-7, 1.5e-8, 9.6e-10,
                                   6.3e-11, -4e-11, 2e-11,  6e-11,   -1e-11};
  const OrderFit fit = observed_order(halved(1.0, 11), errors);
  EXPECT_EQ(fit.used, mask("11111110000"));
  EXPECT_NEAR(*fit.order, 4.0, 0.02);
}

TEST(ObservedOrder, FindsTheFloorAfterTwoPointsOfAHighOrder) {
  const OrderFit fit =
      observed_order(halved(1.0, 5), std::vector{1e-7, 1e-11, 4e-13, 9e-13, 5e-13});
  EXPECT_EQ(fit.used, mask("11000"));
}

TEST(ObservedOrder, DoesNotExcuseAWrongValue) {
  // The same shape far above the limit: an inconsistent method. All points stay, the order is low.
  const std::vector<double> sizes = halved(1.0, 8);
  const std::vector<double> errors{1e-1, 2.5e-2, 6.3e-3, 1.6e-3, 4e-4, 2e-4, 2.1e-4, 2e-4};
  const OrderFit fit = observed_order(sizes, errors);
  EXPECT_EQ(fit.points, 8U);
  EXPECT_LT(*fit.order, 1.5);
  // A limit above it, or a scale, excuses it.
  EXPECT_NEAR(*observed_order(sizes, errors, {.floor_limit = 1e-3}).order, 2.0, 0.02);
  EXPECT_NEAR(*observed_order(sizes, errors, {.scale = 1e6}).order, 2.0, 0.02);
}

TEST(ObservedOrder, KeepsANoisySeriesAtEverySize) {
  // Noise of a fifth about order one, every size between the limit of the floor and rounding.
  std::mt19937 random(3);
  for (int series = 0; series < 2000; ++series) {
    const std::vector<double> sizes = halved(1.0, 7);
    std::vector<double> errors = power(sizes, 9e-10, 1.0);
    for (double& error : errors) {
      error *= 0.8 + 0.4 * static_cast<double>(random()) / 4294967296.0;
    }
    const OrderFit fit = observed_order(sizes, errors);
    ASSERT_EQ(fit.points, 7U) << series;
    ASSERT_NEAR(*fit.order, 1.0, 0.2);
  }
}

TEST(ObservedOrder, LeavesOutZerosAndWhatIsWithinRounding) {
  const std::vector<double> sizes = halved(1.0, 5);
  const OrderFit fit = observed_order(sizes, std::vector{0.4, 0.1, 0.0, 0.00625, 1e-16});
  EXPECT_EQ(fit.used, mask("11010"));
  EXPECT_NEAR(*fit.order, 2.0, 1e-12);
  // The same 1e-16 belongs to values of 1e-10: no rounding.
  EXPECT_EQ(
      observed_order(sizes, std::vector{0.4, 0.1, 0.0, 0.00625, 1e-16}, {.scale = 1e-10}).used,
      mask("11011"));
}

TEST(ObservedOrder, IsEmptyWithFewerThanTwoPoints) {
  for (const std::vector<double>& errors : {std::vector{1e-17, 0.0, 1e-16}, {0.0, 0.1, 0.0}}) {
    const OrderFit fit = observed_order(halved(1.0, 3), errors);
    EXPECT_FALSE(fit.order);
    EXPECT_FALSE(fit.correlation);
    EXPECT_LT(fit.points, 2U);
  }
  EXPECT_FALSE(observed_order({}, {}).order);
}

TEST(ObservedOrder, OfEqualErrorsIsZeroWithoutCorrelation) {
  const OrderFit fit = observed_order(halved(1.0, 4), std::vector{0.1, 0.1, 0.1, 0.1});
  EXPECT_NEAR(*fit.order, 0.0, 1e-15);
  EXPECT_EQ(*fit.correlation, 0.0);
}

TEST(ConvergenceErrors, NameWhatIsWrongWithASeries) {
  const std::vector<double> two{0.1, 0.2};
  EXPECT_EQ(message_of([&] {
              observed_order(std::vector{0.1, 0.0}, two);
            }),
            "sizes = 0: must be positive and finite");
  EXPECT_EQ(message_of([&] {
              pairwise_orders(std::vector{0.5, 0.5}, two);
            }),
            "sizes = 0.5: must not appear twice");
  EXPECT_EQ(message_of([&] { observed_order(std::vector{0.5}, two); }),
            "errors = 2 numbers: must be as many as sizes, 1");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] {
              observed_order(two, std::vector{0.1, nan});
            }),
            "errors = nan: must be finite");
  EXPECT_EQ(message_of([&] { grid_convergence(two, two); }),
            "values = 2 numbers: must be three or more, or two with a given order");
  EXPECT_EQ(message_of([&] { grid_convergence(two, two, {.order = 0.0}); }),
            "order = 0: must be positive");
  EXPECT_EQ(message_of([&] { grid_convergence(two, two, {.safety_factor = -1.0, .order = 1.0}); }),
            "safety_factor = -1: must be positive");
}

TEST(PairwiseOrders, GoFromCoarseToFineWithUnequalRatios) {
  const std::vector<double> sizes{0.1, 1.0, 0.5, 0.01};
  const auto orders = pairwise_orders(sizes, std::vector{0.25, 16.0, -4.0, 0.0});
  ASSERT_EQ(orders.size(), 3U);
  EXPECT_NEAR(*orders[0], 2.0, 1e-14);
  EXPECT_NEAR(*orders[1], std::log(16.0) / std::log(5.0), 1e-14);
  EXPECT_FALSE(orders[2]);
  EXPECT_TRUE(pairwise_orders({}, {}).empty());
}

TEST(Richardson, IsExactForAPowerLaw) {
  EXPECT_NEAR(richardson(7.0 + 0.3 * std::pow(0.2, 1.5), 7.0 + 0.3 * std::pow(0.5, 1.5), 2.5, 1.5),
              7.0, 1e-14);
}

TEST(GridConvergence, MatchesThePublishedExampleOfEqualRatios) {
  // Pressure recovery of an inlet: NASA Glenn, NPARC Alliance verification archive, "Examining
  // spatial (grid) convergence"; six digits of the values are printed.
  const GridConvergence grid =
      grid_convergence(std::vector{1.0, 2.0, 4.0}, std::vector{0.97050, 0.96854, 0.96178});
  EXPECT_EQ(grid.kind, ConvergenceKind::Monotone);
  EXPECT_EQ(grid.safety_factor, 1.25);
  EXPECT_NEAR(*grid.order, 1.78617, 1e-5);
  EXPECT_EQ(grid.order, grid.observed_order);
  EXPECT_NEAR(*grid.extrapolated, 0.97130, 5e-6);
  EXPECT_NEAR(*grid.fine_index, 0.001031, 5e-7);
  EXPECT_NEAR(*grid.coarse_index, 0.003562, 5e-7);
  EXPECT_NEAR(*grid.asymptotic_ratio, 0.97050 / 0.96854, 1e-12);
}

/// A column of table 1 of Celik et al., J. Fluids Eng. 130 (2008) 078001; errors in percent.
struct CelikColumn {
  std::vector<double> cells;  // in a plane
  std::vector<double> values;
  ConvergenceKind kind;
  double order, extrapolated, approximate_error, extrapolated_error, fine_index;
};

TEST(GridConvergence, MatchesThePublishedTableOfUnequalRatios) {
  // The second column's extrapolated error is printed as 0.9, which its own 10.8801 contradicts.
  const std::vector<CelikColumn> table{
      {{18000, 8000, 4500},
       {6.063, 5.972, 5.863},
       ConvergenceKind::Monotone,
       1.53,
       6.1685,
       1.5,
       1.7,
       2.2},
      {{18000, 4500, 980},
       {10.7880, 10.7250, 10.6050},
       ConvergenceKind::Monotone,
       0.75,
       10.8801,
       0.6,
       0.85,
       1.1},
      {{18000, 4500, 980},
       {6.0042, 5.9624, 6.0909},
       ConvergenceKind::Oscillatory,
       1.51,
       6.0269,
       0.7,
       0.4,
       0.5},
  };
  for (const CelikColumn& column : table) {
    std::vector<double> sizes;
    for (const double cells : column.cells) sizes.push_back(1.0 / std::sqrt(cells));
    const GridConvergence grid = grid_convergence(sizes, column.values);
    EXPECT_EQ(grid.kind, column.kind);
    // Half a unit of the last digit that is printed.
    EXPECT_NEAR(*grid.order, column.order, 0.005);
    EXPECT_NEAR(*grid.extrapolated, column.extrapolated, 0.00005);
    EXPECT_NEAR(100.0 * *grid.approximate_error, column.approximate_error, 0.05);
    EXPECT_NEAR(100.0 * *grid.extrapolated_error, column.extrapolated_error, 0.05);
    EXPECT_NEAR(100.0 * *grid.fine_index, column.fine_index, 0.05);
  }
}

TEST(GridConvergence, FindsThePowerLawOfAnyOrderAndRatios) {
  for (const double order : {0.05, 0.7, 2.0, 6.0, 25.0}) {
    for (const double r32 : {1.1, 1.5, 4.0}) {
      const std::vector<double> sizes{1.0, 1.5, 1.5 * r32};
      std::vector<double> values = power(sizes, -2.0, order);
      for (double& value : values) value += 5.0;
      const GridConvergence grid = grid_convergence(sizes, values);
      EXPECT_EQ(grid.kind, ConvergenceKind::Monotone);
      EXPECT_NEAR(*grid.observed_order, order, 1e-10) << r32;
      EXPECT_NEAR(*grid.extrapolated, 5.0, 1e-10);
      EXPECT_NEAR(*grid.uncertainty, 1.25 * 2.0, 1e-10);
    }
  }
}

TEST(GridConvergence, TakesTheThreeFinestInAnyOrder) {
  const std::vector<double> sizes{8.0, 2.0, 1.0, 4.0, 16.0};
  const std::vector<double> values{50.0, 1.4, 1.1, 2.6, -3.0};
  const GridConvergence grid = grid_convergence(sizes, values, {.safety_factor = 2.0});
  EXPECT_NEAR(*grid.observed_order, 2.0, 1e-12);
  EXPECT_NEAR(*grid.extrapolated, 1.0, 1e-12);
  EXPECT_NEAR(*grid.uncertainty, 0.2, 1e-12);
}

TEST(GridConvergence, NamesDivergenceAndGivesNoFigures) {
  const std::vector<double> sizes{1.0, 2.0, 4.0};
  for (const std::vector<double>& values :
       {std::vector{3.0, 1.0, 0.0}, {3.0, 1.0, 2.0}, {3.0, 2.0, 1.0}, {3.0, 1.0, 1.0}}) {
    for (const GridOptions& options : {GridOptions{}, GridOptions{.order = 2.0}}) {
      const GridConvergence grid = grid_convergence(sizes, values, options);
      EXPECT_EQ(grid.kind, ConvergenceKind::Divergent);
      EXPECT_FALSE(grid.observed_order || grid.order || grid.extrapolated || grid.uncertainty);
      EXPECT_FALSE(grid.fine_index || grid.coarse_index || grid.asymptotic_ratio);
      EXPECT_NEAR(*grid.approximate_error, std::abs(values[1] - 3.0) / 3.0, 1e-15);
    }
  }
}

TEST(GridConvergence, JudgesDivergenceByTheRatiosOfSizes) {
  // With r21 = 4 and r32 = 2 a logarithm, order zero, has e_32/e_21 = 1/2.
  const std::vector<double> sizes{1.0, 4.0, 8.0};
  EXPECT_EQ(grid_convergence(sizes, std::vector{0.0, 2.0, 2.99}).kind, ConvergenceKind::Divergent);
  const GridConvergence grid = grid_convergence(sizes, std::vector{0.0, 2.0, 3.01});
  EXPECT_EQ(grid.kind, ConvergenceKind::Monotone);
  EXPECT_LT(*grid.order, 0.02);
}

TEST(GridConvergence, OfEqualValuesLeavesNothing) {
  const std::vector<double> sizes{1.0, 2.0, 4.0};
  for (const double third : {0.3, 0.4}) {
    const GridConvergence grid =
        grid_convergence(sizes, std::vector{0.3, 0.1 + 0.2, third}, {.safety_factor = 1.5});
    EXPECT_EQ(grid.kind, ConvergenceKind::Unchanged);
    EXPECT_FALSE(grid.order);
    EXPECT_EQ(*grid.extrapolated, 0.3);
    EXPECT_EQ(*grid.uncertainty, 0.0);
    EXPECT_EQ(*grid.fine_index, 0.0);
    EXPECT_FALSE(grid.asymptotic_ratio);
  }
  const GridConvergence zero = grid_convergence(sizes, std::vector{0.0, 0.0, 0.0});
  EXPECT_EQ(zero.kind, ConvergenceKind::Unchanged);
  EXPECT_EQ(*zero.uncertainty, 0.0);
  EXPECT_FALSE(zero.fine_index || zero.approximate_error);
}

TEST(GridConvergence, HasNoRelativeFiguresOfAZero) {
  const GridConvergence grid =
      grid_convergence(std::vector{1.0, 2.0, 4.0}, std::vector{0.0, 3.0, 15.0});
  EXPECT_EQ(grid.kind, ConvergenceKind::Monotone);
  EXPECT_NEAR(*grid.order, 2.0, 1e-12);
  EXPECT_NEAR(*grid.uncertainty, 1.25, 1e-12);
  EXPECT_FALSE(grid.approximate_error || grid.fine_index || grid.asymptotic_ratio);
  EXPECT_NEAR(*grid.coarse_index, 1.25 * 4.0 / 3.0, 1e-12);
}

TEST(GridConvergence, TwoValuesNeedAnOrderAndALargerMargin) {
  const GridConvergence grid =
      grid_convergence(std::vector{2.0, 1.0}, std::vector{1.4, 1.1}, {.order = 2.0});
  EXPECT_EQ(grid.kind, ConvergenceKind::Unknown);
  EXPECT_EQ(grid.safety_factor, 3.0);
  EXPECT_FALSE(grid.r32 || grid.observed_order || grid.coarse_index);
  EXPECT_NEAR(*grid.extrapolated, 1.0, 1e-15);
  EXPECT_NEAR(*grid.uncertainty, 0.3, 1e-15);
  EXPECT_NEAR(*grid.fine_index, 0.3 / 1.1, 1e-15);
}

TEST(GridConvergence, ComparesAGivenOrderWithTheAsymptoticRange) {
  // Values of order one, judged by order two: GCI_23/(r^p GCI_12) = r/r^2 times f_1/f_2.
  const std::vector<double> values{10.1, 10.2, 10.4};
  const GridConvergence grid = grid_convergence(std::vector{1.0, 2.0, 4.0}, values, {.order = 2.0});
  EXPECT_NEAR(*grid.observed_order, 1.0, 1e-12);
  EXPECT_EQ(*grid.order, 2.0);
  EXPECT_NEAR(*grid.asymptotic_ratio, 0.5 * 10.1 / 10.2, 1e-12);
}

}  // namespace
}  // namespace plastica::theory
