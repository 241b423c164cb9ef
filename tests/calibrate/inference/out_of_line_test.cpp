#include "calibrate/inference/out_of_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace plastica::calibrate {
namespace {

using Values = std::vector<double>;

/// By hand: the median of 10, 11, 12, 13, 30 is 12, the distances from it 2, 1, 0, 1, 18 have the
/// median 1.
TEST(ModifiedZScores, AreThoseWorkedByHand) {
  const ModifiedZScores found = modified_z_scores({11.0, 30.0, 13.0, 10.0, 12.0});
  EXPECT_EQ(found.median, 12.0);
  EXPECT_EQ(found.scores, (Values{-0.6745, 0.6745 * 18.0, 0.6745, -0.6745 * 2.0, 0.0}));
  // Of six the medians are means of two: 12.5; of 2.5, 1.5, 0.5, 0.5, 1.5, 17.5 it is 1.5.
  const ModifiedZScores even = modified_z_scores({10.0, 11.0, 12.0, 13.0, 14.0, 30.0});
  EXPECT_EQ(even.median, 12.5);
  EXPECT_EQ(even.scores.back(), 0.6745 * 17.5 / 1.5);
}

/// One value that is far off hides itself from the standard deviation: (n - 1)/sqrt(n) is the most
/// that a score by it can be, 1.79 of five.
TEST(ModifiedZScores, AreLargeOfAValueThatIsFarOff) {
  const ModifiedZScores found = modified_z_scores({1.0, 1.1, 0.9, 1.05, 1e6});
  EXPECT_GT(found.scores.back(), 1e6);
  EXPECT_LT(*std::max_element(found.scores.begin(), found.scores.end() - 1), kOutOfLine);
}

TEST(ModifiedZScores, AreOddInTheValues) {
  const Values values{3.0, 1.0, 4.0, 1.5, 9.0, 2.6};
  Values mirrored;
  for (const double value : values) mirrored.push_back(-value);
  const ModifiedZScores found = modified_z_scores(values);
  const ModifiedZScores other = modified_z_scores(mirrored);
  ASSERT_EQ(found.scores.size(), values.size());
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_EQ(other.scores[k], -found.scores[k]);
}

/// A power of two changes no bit; an offset rounds, by less than 1e-13 of these values.
TEST(ModifiedZScores, HaveNoUnitAndNoOrigin) {
  const Values values{3.0, 1.0, 4.0, 1.5, 9.0, 2.6};
  Values scaled;
  Values shifted;
  for (const double value : values) {
    scaled.push_back(value * 1048576.0);
    shifted.push_back(value + 8.0);
  }
  EXPECT_EQ(modified_z_scores(scaled).scores, modified_z_scores(values).scores);
  const Values moved = modified_z_scores(shifted).scores;
  const Values found = modified_z_scores(values).scores;
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(moved[k], found[k], 1e-13);
}

TEST(ModifiedZScores, SayNothingWithoutEnoughOrWithoutScatter) {
  EXPECT_TRUE(modified_z_scores({}).scores.empty());
  EXPECT_TRUE(modified_z_scores({1.0, 2.0, 3.0, 100.0}).scores.empty());
  EXPECT_EQ(modified_z_scores({1.0, 2.0, 3.0, 4.0, 100.0}).scores.size(), 5U);
  // More than half of them are the same.
  EXPECT_TRUE(modified_z_scores({2.0, 2.0, 2.0, 2.0, 100.0, 3.0}).scores.empty());
  EXPECT_TRUE(modified_z_scores(Values(7, 2.0)).scores.empty());
}

TEST(ModifiedZScores, StandTheLargestNumbers) {
  const double huge = std::numeric_limits<double>::max();
  EXPECT_EQ(modified_z_scores({huge, huge, huge, huge, huge, huge}).median, huge);
}

}  // namespace
}  // namespace plastica::calibrate
