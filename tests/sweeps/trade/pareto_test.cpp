#include "sweeps/trade/pareto.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace plastica::sweeps {
namespace {

using Points = std::vector<TradePoint>;
using Indices = std::vector<std::size_t>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ParetoFront, HoldsWhatNoOtherPointBeatsByRisingCost) {
  const Points points{{4.0, 0.1}, {1.0, 0.5}, {2.0, 0.6}, {3.0, 0.2}, {3.0, 0.3}, {9.0, 0.1}};
  EXPECT_EQ(pareto_front(points), (Indices{1, 3, 0}));
}

TEST(ParetoFront, TakesTheFirstOfEqualPoints) {
  EXPECT_EQ(pareto_front(Points{{2.0, 0.2}, {1.0, 0.3}, {1.0, 0.3}, {2.0, 0.2}}), (Indices{1, 0}));
}

TEST(ParetoFront, NeverHoldsAPointThatFailed) {
  const Points points{{0.1, kNan}, {kNan, 0.0}, {1.0, kInfinity}, {kInfinity, 0.0}, {5.0, 0.5}};
  EXPECT_EQ(pareto_front(points), (Indices{4}));
  EXPECT_TRUE(pareto_front(Points{{kNan, kNan}}).empty());
  EXPECT_TRUE(pareto_front({}).empty());
}

/// Two refinements: group 0 falls steadily; group 1 changes its error's sign at size 0.5.
Points two_groups() {
  return {{1.0, 0.40, 0, {1.0}},  {2.0, 0.10, 0, {0.5}},  {4.0, 0.025, 0, {0.25}},
          {0.5, 0.30, 1, {1.0}},  {0.6, 0.001, 1, {0.5}}, {0.9, 0.08, 1, {0.25}},
          {1.5, 0.02, 1, {0.125}}};
}

TEST(AssuredErrors, AreTheLargestOfAllFinerPointsOfTheGroup) {
  EXPECT_EQ(assured_errors(two_groups()),
            (std::vector<double>{0.40, 0.10, 0.025, 0.30, 0.08, 0.08, 0.02}));
}

TEST(AssuredErrors, OfPointsAloneFailedOrEquallyFineAreTheirOwn) {
  const Points points{{1.0, 0.1},
                      {2.0, 0.5},
                      {1.0, 0.1, 3, {1.0}},
                      {1.0, 0.4, 3, {1.0}},
                      {1.0, kNan, 3, {0.5}},
                      {kNan, 0.9, 3, {0.25}}};
  EXPECT_EQ(assured_errors(points),
            (std::vector<double>{0.1, 0.5, 0.1, 0.4, kInfinity, kInfinity}));
}

TEST(RecommendForError, TakesTheCheapestThatMeetsItWithoutLuck) {
  const Recommendation choice = recommend_for_error(two_groups(), 0.05);
  EXPECT_EQ(choice.chosen, 6U);
  EXPECT_EQ(choice.why_none, NoChoice::None);
  EXPECT_FALSE(choice.lucky);
  EXPECT_DOUBLE_EQ(choice.margin, 2.5);
  EXPECT_EQ(choice.assured_error, 0.02);
  EXPECT_EQ(choice.passed_over, 4U);
  EXPECT_EQ(choice.next, 5U);
}

TEST(RecommendForError, AcceptsASmallErrorThatFinerPointsMeetToo) {
  const Recommendation choice = recommend_for_error(two_groups(), 0.08);
  EXPECT_EQ(choice.chosen, 4U);
  EXPECT_FALSE(choice.lucky);
  EXPECT_FALSE(choice.passed_over);
  EXPECT_EQ(choice.next, 3U);
}

TEST(RecommendForError, SaysWhenLuckAloneMeetsIt) {
  const Recommendation choice = recommend_for_error(two_groups(), 0.01);
  EXPECT_EQ(choice.chosen, 4U);
  EXPECT_TRUE(choice.lucky);
  EXPECT_DOUBLE_EQ(choice.margin, 10.0);
  EXPECT_EQ(choice.assured_error, 0.08);
  EXPECT_FALSE(choice.passed_over);
  EXPECT_EQ(choice.next, 3U);
}

TEST(RecommendForError, NamesTheMostAccurateWhenNothingMeetsIt) {
  const Recommendation choice = recommend_for_error(two_groups(), 0.0005);
  EXPECT_FALSE(choice.chosen);
  EXPECT_EQ(choice.why_none, NoChoice::TooInaccurate);
  EXPECT_EQ(choice.nearest, 4U);
  EXPECT_DOUBLE_EQ(choice.margin, 0.5);
  EXPECT_TRUE(choice.lucky);
  EXPECT_EQ(choice.assured_error, 0.08);
  EXPECT_FALSE(choice.next || choice.passed_over);
}

TEST(RecommendForError, TakesTheFirstOfEqualPointsAndNamesNoCheaperOne) {
  const Recommendation choice =
      recommend_for_error(Points{{3.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {2.0, 0.7}}, 0.0);
  EXPECT_EQ(choice.chosen, 1U);
  EXPECT_EQ(choice.margin, kInfinity);
  EXPECT_FALSE(choice.next);
}

TEST(RecommendForBudget, TakesTheMostAccurateByAssuredError) {
  const Recommendation choice = recommend_for_budget(two_groups(), 1.2);
  EXPECT_EQ(choice.chosen, 4U);  // 0.08 is assured, as for the costlier point 5
  EXPECT_TRUE(choice.lucky);
  EXPECT_DOUBLE_EQ(choice.margin, 2.0);
  EXPECT_EQ(choice.assured_error, 0.08);
  EXPECT_EQ(choice.next, 6U);
  const Recommendation rich = recommend_for_budget(two_groups(), 100.0);
  EXPECT_EQ(rich.chosen, 6U);
  EXPECT_FALSE(rich.lucky || rich.next);
}

TEST(RecommendForBudget, NamesTheCheapestWhenNothingIsAffordable) {
  const Recommendation choice = recommend_for_budget(two_groups(), 0.25);
  EXPECT_FALSE(choice.chosen);
  EXPECT_EQ(choice.why_none, NoChoice::TooCostly);
  EXPECT_EQ(choice.nearest, 3U);
  EXPECT_DOUBLE_EQ(choice.margin, 0.5);
}

TEST(Recommend, TellsNothingFromNothingThatRan) {
  for (const auto& choice : {recommend_for_error({}, 1.0), recommend_for_budget({}, 1.0)}) {
    EXPECT_EQ(choice.why_none, NoChoice::NoPoints);
    EXPECT_FALSE(choice.chosen || choice.nearest);
  }
  const Points failed{{kNan, 0.1}, {1.0, kNan}};
  for (const auto& choice : {recommend_for_error(failed, 1.0), recommend_for_budget(failed, 9.0)}) {
    EXPECT_EQ(choice.why_none, NoChoice::AllFailed);
    EXPECT_FALSE(choice.chosen || choice.nearest);
    EXPECT_TRUE(std::isnan(choice.margin));
  }
}

}  // namespace
}  // namespace plastica::sweeps
