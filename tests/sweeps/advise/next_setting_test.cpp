#include "sweeps/advise/next_setting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sweeps/advise/axis_models.hpp"

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

/// How far a run at h is off one at h/2, of two quantities: one that falls with h^2, and one with
/// the error h^2 - c h of its own size.
Deviation halved_from(double h, double c) {
  const double one = 0.01 * h * h * (1.0 - 0.25);
  const double other = h * h * (1.0 - 0.25) - c * h * (1.0 - 0.5);
  Deviation off;
  off.largest = std::max(one, std::abs(other));
  off.quantity = std::abs(other) > one ? "other" : "one";
  off.quantities = 2;
  off.parts = {{"one", one}, {"other", other}};
  return off;
}

TEST(AxisModels, SaysWhatMayBeHiddenWhereChangesCancelAndMeasuresIt) {
  // At h = 1/8 both of its terms change alike.
  const double h = 0.125;
  const double c = 1.5 * h;
  AxisModels models(1);
  EXPECT_EQ(models.measured(0, 2.0 * h, h, halved_from(2.0 * h, c)).hidden, 0.0);
  const AxisError once = models.measured(0, h, 0.5 * h, halved_from(h, c));
  const double error = std::abs(h * h - c * h);
  EXPECT_LT(once.error, 0.05 * error) << "what the power law makes of it";
  EXPECT_GE(once.hidden, error);
  const AxisError twice =
      models.measured_twice(0, h, 0.5 * h, 0.25 * h, halved_from(h, c), halved_from(0.5 * h, c));
  EXPECT_GE(twice.error, 0.999 * error);
  EXPECT_LE(twice.error, 1.5 * error);
  EXPECT_EQ(twice.hidden, 0.0);
  EXPECT_EQ(models.foretold(0, h).error, twice.error);
}

TEST(AxisModels, HidesNothingWhereAllFallsAsAPowerDoes) {
  AxisModels models(1);
  models.measured(0, 0.25, 0.125, halved_from(0.25, 0.0));
  const AxisError once = models.measured(0, 0.125, 0.0625, halved_from(0.125, 0.0));
  EXPECT_EQ(once.hidden, 0.0);
  EXPECT_NEAR(once.error, 0.125 * 0.125, 1e-15);
  const AxisError twice = models.measured_twice(0, 0.125, 0.0625, 0.03125, halved_from(0.125, 0.0),
                                                halved_from(0.0625, 0.0));
  EXPECT_NEAR(twice.error, once.error, 1e-15);
  EXPECT_NEAR(twice.order, 2.0, 1e-12);
}

}  // namespace
}  // namespace plastica::sweeps
