#include "plastica/solve/first_roots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace plastica::solve {
namespace {

/// How many of some roots are below x.
std::function<int(double)> passed(std::vector<double> roots) {
  return [roots = std::move(roots)](double x) {
    return static_cast<int>(
        std::count_if(roots.begin(), roots.end(), [&](double root) { return root < x; }));
  };
}

TEST(FirstRoots, AreFoundToRoundingAndInOrder) {
  const std::vector<double> roots{1e-7, std::numbers::pi, 1e3 / 3.0, 2e9 / 7.0};
  const auto found = first_roots(passed(roots), {.reach = 1.0, .count = 4}).at;
  ASSERT_EQ(found.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found[k] / roots[k], 1.0, 2e-13);
}

TEST(FirstRoots, ComeAsOftenAsTheyCount) {
  const auto found = first_roots(passed({2.0, 3.0, 3.0, 3.0 + 1e-9, 4.0}), {.count = 4}).at;
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[1], found[2]);
  EXPECT_NEAR(found[3] - found[2], 1e-9, 1e-12);
}

TEST(FirstRoots, OfARepeatedOneAreNoMoreThanAskedFor) {
  EXPECT_EQ(first_roots(passed({3.0, 3.0, 3.0}), {.count = 2}).at.size(), 2U);
}

TEST(FirstRoots, AreFewerWhereThereAreNoMore) {
  EXPECT_EQ(first_roots(passed({5.0, 1e20}), {.most = 1e6, .count = 3}).at.size(), 1U);
  EXPECT_TRUE(first_roots(passed({}), {.count = 3}).at.empty());
}

TEST(FirstRoots, BelowTheBeginningAreNotCounted) {
  const auto found = first_roots(passed({-1.0, 0.5, 7.0}), {.from = 1.0, .count = 1}).at;
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0], 7.0, 1e-12);
}

TEST(FirstRoots, SayThatACountFallsBetween) {
  const auto falls = [](double x) { return x < 0.4 ? 0 : x < 0.7 ? 3 : 2; };
  EXPECT_TRUE(first_roots(falls, {.reach = 1.0, .count = 2}).falls);
}

TEST(FirstRoots, SayThatACountFallsOnTheWayOut) {
  const auto falls = [](double x) { return x < 2.0 ? 0 : x < 3.0 ? 3 : 1; };
  EXPECT_TRUE(first_roots(falls, {.reach = 2.5, .count = 4}).falls);
}

TEST(FirstRoots, TakeRoundingBesideThemForNoFall) {
  const auto rounds = [](double x) {
    const bool odd = std::fmod(x * 1e12, 2.0) > 1.0;
    if (std::fabs(x - 0.3) < 1e-11) return odd ? 2 : 0;
    return x < 0.3 ? 0 : 1;
  };
  const Roots found = first_roots(rounds, {.reach = 1.0, .count = 1});
  EXPECT_FALSE(found.falls);
  ASSERT_EQ(found.at.size(), 1U);
  EXPECT_NEAR(found.at[0], 0.3, 1e-11);
}

}  // namespace
}  // namespace plastica::solve
