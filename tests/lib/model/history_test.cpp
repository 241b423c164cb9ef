#include "plastica/model/history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace plastica {
namespace {

const History kTable{{0.0, 1.0}, {0.0, 1.0}};

TEST(History, GoesOnAlongARampAfterItsEnd) {
  const History ramp = History::ramp();
  for (const double time : {0.0, 0.25, 1.0, 2.0, 3.0, 1e6}) {
    EXPECT_EQ(ramp.at(time), time);
    EXPECT_EQ(ramp.slope_at(time), 1.0);
  }
}

TEST(History, OfATableHoldsItsLastFactorWhateverItsNumbersAre) {
  for (const History& history : {kTable, History::turning_points({1.0})}) {
    EXPECT_EQ(history.at(0.5), 0.5);
    EXPECT_EQ(history.slope_at(0.5), 1.0);
    for (const double time : {1.0, 2.0, 3.0}) {
      EXPECT_EQ(history.at(time), 1.0);
      EXPECT_EQ(history.slope_at(time), 0.0);
    }
  }
  EXPECT_NE(kTable, History::ramp());
  EXPECT_EQ(kTable, History{});
}

TEST(History, GoesOnAlongTheLastOfSeveralLines) {
  // 2 at 1 s, 3 at 3 s, so half a unit a second from there on.
  const History history{{0.0, 1.0, 3.0}, {0.0, 2.0, 3.0}, true};
  EXPECT_EQ(history.at(0.5), 1.0);
  EXPECT_EQ(history.at(2.0), 2.5);
  EXPECT_EQ(history.at(3.0), 3.0);
  EXPECT_EQ(history.at(5.0), 4.0);
  EXPECT_EQ(history.slope_at(0.5), 2.0);
  EXPECT_EQ(history.slope_at(7.0), 0.5);
}

/// A path that snaps through may need a load against the one that is given: a factor below 0.
TEST(History, GoesOnBeforeItsBeginningToo) {
  EXPECT_EQ(History::ramp().at(-0.5), -0.5);
  EXPECT_EQ(kTable.at(-0.5), 0.0);
  EXPECT_EQ(kTable.slope_at(-0.5), 0.0);
  const History history{{1.0, 2.0}, {3.0, 5.0}, true};
  EXPECT_EQ(history.at(0.5), 2.0);
  EXPECT_EQ(history.slope_at(0.5), 2.0);
  EXPECT_EQ(history.at(4.0), 9.0);
}

TEST(History, OfOnePointIsConstant) {
  EXPECT_EQ(History::constant().at(0.0), 1.0);
  EXPECT_EQ(History::constant().at(9.0), 1.0);
  EXPECT_EQ(History::constant().slope_at(0.0), 0.0);
}

TEST(History, OfASineIsThatWithin2e8) {
  const History sine = History::sine(0.4, 2.25, 0.3, 0.5);
  const double rate = 2.0 * std::numbers::pi / 0.4;
  for (double time = 0.0; time < 0.9; time += 0.000777) {
    EXPECT_NEAR(sine.at(time), 0.5 + std::sin(rate * time + 0.3), 2e-8);
    EXPECT_NEAR(sine.slope_at(time), rate * std::cos(rate * time + 0.3), 2e-4);
  }
  EXPECT_NEAR(sine.end(), 0.9, 1e-15);
  EXPECT_NEAR(sine.at(5.0), 0.5 + std::sin(4.5 * std::numbers::pi + 0.3), 1e-12);
  EXPECT_EQ(sine.corners(), (std::vector<double>{0.0, sine.end()}));
}

TEST(History, OfASineThatHardlyBeginsHasTwoPoints) {
  const History sine = History::sine(1.0, 1e-12, 0.0, 0.5);
  ASSERT_EQ(sine.time.size(), 2U);
  EXPECT_EQ(sine.at(0.0), 0.5);
  EXPECT_NEAR(sine.at(1.0), 0.5, 1e-11);
}

TEST(History, OfASineTurnsAtItsPeaks) {
  const auto reversals = History::sine(1.0, 2.0, 0.3).reversals();
  ASSERT_EQ(reversals.size(), 4U);
  const double first = 0.25 - 0.3 / (2.0 * std::numbers::pi);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(reversals[k], first + 0.5 * static_cast<double>(k), 1e-6);
  }
  // The peaks are points of the table.
  EXPECT_EQ(History::sine(1.0, 3.0).reversals().size(), 6U);
}

TEST(History, OfASmoothStepHasNoCornerInside) {
  const History step = History::smooth_step(1.0, 3.0);
  EXPECT_EQ(step.at(0.5), 0.0);
  EXPECT_EQ(step.at(2.0), 0.5);
  EXPECT_DOUBLE_EQ(step.at(1.5), 3.0 / 16.0 - 2.0 / 64.0);
  EXPECT_EQ(step.slope_at(1.0), 0.0);
  EXPECT_DOUBLE_EQ(step.slope_at(2.0), 0.75);
  EXPECT_EQ(step.at(4.0), 1.0);
  EXPECT_TRUE(step.reversals().empty());
}

}  // namespace
}  // namespace plastica
