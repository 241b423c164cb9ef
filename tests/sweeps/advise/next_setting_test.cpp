#include "sweeps/advise/next_setting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plastica::sweeps {
namespace {

/// 16 segments and a step of 1 ms.
std::vector<FinenessAxis> segments_and_step() {
  return {{&find_field("beam.segments"), 4.0, 20'000.0},
          {&find_field("solver.time_step"), 1.0, 1e-9}};
}

AxisError error_of(double error, double order) {
  AxisError made;
  made.change = error * (1.0 - std::pow(2.0, -order));
  made.order = order;
  made.error = error;
  return made;
}

TEST(NextSetting, LeavesOfAChangeWhatALawHasDownToItsLimit) {
  // f(h) = 3 h^1.5: of f(0.1) - f(0.1/1.7), all of f(0.1) is left.
  const double coarse = 3.0 * std::pow(0.1, 1.5);
  const double fine = 3.0 * std::pow(0.1 / 1.7, 1.5);
  EXPECT_NEAR(left_of(coarse - fine, 1.7, 1.5), coarse, 1e-15);
  EXPECT_NEAR(seen_order(0.1, coarse, 0.1 / 1.7, fine, 2.0), 1.5, 1e-12);
}

TEST(NextSetting, HasTheLeastCostOfAllThatComeToTheWantedError) {
  const auto axes = segments_and_step();
  const Setting setting{400.0, 1e-3};
  const std::vector<AxisError> errors{error_of(0.04, 2.0), error_of(0.02, 1.0)};
  const double wanted = 0.03;
  const Setting next = next_setting(axes, setting, errors, wanted);
  const auto error_at = [&](const Setting& at) {
    return 0.04 * std::pow(setting[0] / at[0], 2.0) + 0.02 * at[1] / setting[1];
  };
  // Segments are whole: 1/400 of their error at most.
  EXPECT_LE(error_at(next), wanted);
  EXPECT_GE(error_at(next), 0.99 * wanted);
  const double cost = next[0] / next[1];
  for (double segments = 250.0; segments < 1600.0; segments += 1.0) {
    const double left = wanted - 0.04 * std::pow(setting[0] / segments, 2.0);
    if (left <= 0.0) continue;
    const double step = left / 0.02 * setting[1];
    EXPECT_GE(segments / step, 0.99 * cost) << segments;
  }
}

TEST(NextSetting, HalvesWhatCannotBeComparedAndCoarsensWhatDoesNothing) {
  const auto axes = segments_and_step();
  AxisError unknown;
  unknown.change = std::numeric_limits<double>::infinity();
  unknown.error = unknown.change;
  const Setting next = next_setting(axes, {16.0, 1e-3}, {unknown, error_of(0.0, 1.0)}, 0.01);
  EXPECT_EQ(next[0], 32.0);
  EXPECT_EQ(next[1], 2e-3);
}

}  // namespace
}  // namespace plastica::sweeps
