#include "calibrate/search/screening.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plastica::calibrate {
namespace {

using Indices = std::vector<std::size_t>;
constexpr double kNone = std::numeric_limits<double>::infinity();

/// Ten points a tenth apart on a line: those within (2 ln(10)/10)/2 = 0.23 are near.
const std::vector<double> kLine{0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};

TEST(ChooseStarts, TakesTheBestOfEachBasinFirst) {
  const std::vector<double> costs{5.0, 4.0, 3.0, 4.0, 6.0, 9.0, 8.0, 7.0, 6.5, 8.0};
  EXPECT_EQ(choose_starts(kLine, costs, 2), (Indices{2, 8}));
  EXPECT_EQ(choose_starts(kLine, costs, 1), (Indices{2}));
}

TEST(ChooseStarts, FillsUpWithTheBestOfTheOthers) {
  const std::vector<double> costs{5.0, 4.0, 3.0, 4.5, 6.0, 9.0, 8.0, 7.0, 6.5, 8.0};
  EXPECT_EQ(choose_starts(kLine, costs, 4), (Indices{2, 1, 3, 8}));
}

TEST(ChooseStarts, PutsTiesInOrderAndLeavesOutWhatHasNoCost) {
  const double nan = std::nan("");
  const std::vector<double> costs{1.0, kNone, nan, kNone, 1.0, nan, kNone, kNone, 1.0, kNone};
  EXPECT_EQ(choose_starts(kLine, costs, 2), (Indices{0, 4}));
  EXPECT_EQ(choose_starts(kLine, costs, 10), (Indices{0, 4, 8}));
  EXPECT_EQ(choose_starts(kLine, std::vector<double>(10, nan), 3), Indices{});
  EXPECT_EQ(choose_starts({}, {}, 3), Indices{});
}

}  // namespace
}  // namespace plastica::calibrate
