#include "plastica/base/median.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

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

/// Orders values by the library, and asks for each rank.
void expect_ranks_of(const std::vector<double>& values) {
  std::vector<double> ordered = values;
  std::ranges::sort(ordered);
  for (std::size_t rank = 0; rank < values.size(); ++rank) {
    std::vector<double> left = values;
    ASSERT_EQ(value_of_rank(left, rank), ordered[rank]) << rank << " of " << values.size();
    std::ranges::sort(left);
    ASSERT_EQ(left, ordered);  // it moves them, and nothing else
  }
}

TEST(ValueOfRank, IsWhereOrderWouldPutIt) {
  std::mt19937_64 random(1);
  constexpr std::array<std::size_t, 7> kCounts{1, 2, 3, 12, 13, 40, 201};
  for (const std::size_t n : kCounts) {
    std::vector<double> some(n), rising(n), falling(n), alike(n, 2.5), few(n), pipe(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto number = static_cast<double>(i);
      some[i] = static_cast<double>(random() % 1000) - 500.0;
      rising[i] = number;
      falling[i] = -number;
      few[i] = static_cast<double>(random() % 3);
      pipe[i] = std::min(number, static_cast<double>(n) - number);
    }
    for (const auto& values : {some, rising, falling, alike, few, pipe}) expect_ranks_of(values);
  }
}

}  // namespace
}  // namespace plastica
