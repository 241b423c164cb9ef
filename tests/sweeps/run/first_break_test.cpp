#include "sweeps/run/first_break.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plastica::sweeps {
namespace {

ChainBreak event_at(double time, int joint, BreakCause cause) {
  ChainBreak event;
  event.time = time;
  event.factor = 2.0 * time;
  event.joints.resize(1);
  event.joints[0].joint = joint;
  event.joints[0].cause = cause;
  return event;
}

TEST(FirstBreak, IsNoCut) {
  ChainHistory chain;
  chain.joints = 9;
  EXPECT_FALSE(first_break(chain).has_value());
  chain.events.push_back(event_at(0.5, 4, BreakCause::Cut));
  EXPECT_FALSE(first_break(chain).has_value());
  chain.events.push_back(event_at(1.5, 2, BreakCause::BendingX));
  chain.events.push_back(event_at(2.5, 6, BreakCause::BendingX));
  const auto found = first_break(chain);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->time, 1.5);
  EXPECT_EQ(found->factor, 3.0);
  EXPECT_EQ(found->joint, 2);
  EXPECT_EQ(found->place, 0.25);
}

TEST(BreakAlike, HoldsForTheJointsNextToOnePointInAllPairsOfRuns) {
  for (const double point : {0.0, 0.013, 0.31, 0.5, 0.777, 1.0}) {
    for (int n = 2; n < 40; ++n) {
      for (int m = n; m < 160; m += 3) {
        EXPECT_TRUE(break_alike(std::round(point * n) / n, n, std::round(point * m) / m, m))
            << point << ' ' << n << ' ' << m;
      }
    }
  }
}

TEST(BreakAlike, DoesNotHoldForAJointFurtherOrWhereOneDoesNotBreak) {
  EXPECT_TRUE(break_alike(0.5, 8, 0.625, 16));
  EXPECT_FALSE(break_alike(0.5, 8, 0.6875, 16));
  EXPECT_FALSE(break_alike(0.5, 8, std::nullopt, 16));
  EXPECT_TRUE(break_alike(std::nullopt, 8, std::nullopt, 16));
}

}  // namespace
}  // namespace plastica::sweeps
