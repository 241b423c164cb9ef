#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "plastica/theory/convergence.hpp"

// Values whose errors are of two orders, or of one that no method has.

namespace plastica::theory {
namespace {

std::vector<double> squared_twice(const std::vector<double>& sizes) {
  std::vector<double> values;
  for (const double h : sizes) values.push_back(std::pow(h, 4.0));
  return values;
}

TEST(LimitOfTwoOrders, IsExactForBothTogetherAndEachAlone) {
  for (const auto& [a, b] : {std::pair{0.7, -3.0}, std::pair{0.7, 0.0}, std::pair{0.0, -3.0}}) {
    const std::vector<double> sizes{0.3, 0.11, 0.2};
    std::vector<double> values;
    for (const double h : sizes) values.push_back(5.0 + a * h + b * h * h);
    EXPECT_NEAR(limit_of_two_orders(sizes, values), 5.0, 1e-13);
  }
}

TEST(GridConvergence, WithAHighestOrderJudgesAPowerAsBefore) {
  const std::vector<double> sizes{1.0, 2.0, 4.0};
  for (const double order : {1.0, 2.0}) {
    std::vector<double> values;
    for (const double h : sizes) values.push_back(2.0 + 0.3 * std::pow(h, order));
    const GridConvergence grid = grid_convergence(sizes, values);
    const GridConvergence limited = grid_convergence(sizes, values, {.highest_order = 2.0});
    EXPECT_EQ(limited.kind, ConvergenceKind::Monotone);
    EXPECT_NEAR(*limited.extrapolated, *grid.extrapolated, 1e-14);
    EXPECT_NEAR(*limited.uncertainty, *grid.uncertainty, 1e-14);
    EXPECT_FALSE(limited.coarse_index || limited.asymptotic_ratio);
  }
}

TEST(GridConvergence, WithAHighestOrderExtrapolatesNothingThatFallsFasterOrToAndFro) {
  const std::vector<double> sizes{1.0, 2.0, 4.0};
  const GridConvergence fast =
      grid_convergence(sizes, squared_twice(sizes), {.highest_order = 2.0});
  EXPECT_EQ(fast.kind, ConvergenceKind::TooFast);
  EXPECT_NEAR(*fast.observed_order, 4.0, 1e-12);
  EXPECT_FALSE(fast.extrapolated || fast.order);
  EXPECT_EQ(fast.safety_factor, 3.0);
  EXPECT_NEAR(*fast.uncertainty, 3.0 * 255.0 / 3.0, 1e-11);  // by order 1 from the coarsest
  const GridConvergence swings =
      grid_convergence(sizes, std::vector{1.0, 1.5, 0.0}, {.highest_order = 2.0});
  EXPECT_EQ(swings.kind, ConvergenceKind::Oscillatory);
  EXPECT_FALSE(swings.extrapolated);
  EXPECT_NEAR(*swings.uncertainty, 3.0 * 0.5, 1e-14);
}

TEST(GridConvergence, WithAHighestOrderIsSafeWhereErrorsOfOrdersOneAndTwoCancel) {
  // 1 + h^2 - c h at h = 1, 2, 4: from c = 3, where the two finest agree, to both sides.
  const std::vector<double> sizes{1.0, 2.0, 4.0};
  for (double c = -4.0; c < 12.0; c += 0.01) {
    std::vector<double> values;
    for (const double h : sizes) values.push_back(1.0 + h * h - c * h);
    const GridConvergence grid = grid_convergence(sizes, values, {.highest_order = 2.0});
    if (grid.kind == ConvergenceKind::Divergent) continue;
    EXPECT_GE(*grid.uncertainty, (1.0 - 1e-9) * std::abs(values[0] - 1.0)) << c;
  }
}

TEST(GridConvergence, WithAHighestOrderDoesNotTakeTwoThatAgreeForConvergedIfTheThirdDoesNot) {
  // -1 = 1 + h^2 - 3 h at h = 1 and 2, and 5 at 4: both are 2 off.
  const std::vector<double> sizes{1.0, 2.0, 4.0};
  const GridConvergence grid =
      grid_convergence(sizes, std::vector{-1.0, -1.0, 5.0}, {.highest_order = 2.0});
  EXPECT_EQ(grid.kind, ConvergenceKind::TooFast);
  EXPECT_GE(*grid.uncertainty, 2.0);
  EXPECT_FALSE(grid.extrapolated);
  const GridConvergence same =
      grid_convergence(sizes, std::vector{2.0, 2.0, 2.0}, {.highest_order = 2.0});
  EXPECT_EQ(same.kind, ConvergenceKind::Unchanged);
  EXPECT_EQ(*same.uncertainty, 0.0);
}

}  // namespace
}  // namespace plastica::theory
