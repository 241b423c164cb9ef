#include "plastica/base/median.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace plastica {
namespace {

TEST(Median, IsTheMiddleOne) {
  EXPECT_EQ(median_of({7.0}), 7.0);
  EXPECT_EQ(median_of({3.0, -1.0, 100.0}), 3.0);
  EXPECT_EQ(median_of({5.0, 1.0, 4.0, 2.0, 3.0}), 3.0);
}

TEST(Median, IsBetweenTheTwoInTheMiddle) {
  EXPECT_EQ(median_of({2.0, 1.0}), 1.5);
  EXPECT_EQ(median_of({100.0, 2.0, 4.0, -50.0}), 3.0);
  EXPECT_EQ(median_of({2.0, 2.0, 2.0, 9.0}), 2.0);
}

TEST(Median, OfTheLargestNumbersDoesNotOverflow) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  EXPECT_EQ(median_of({kLargest, kLargest}), kLargest);
  EXPECT_EQ(median_of({-kLargest, kLargest}), 0.0);
}

}  // namespace
}  // namespace plastica
