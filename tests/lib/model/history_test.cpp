#include "plastica/model/history.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace plastica
