#include "plastica/base/star_pattern.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace plastica {
namespace {

TEST(StarPattern, MatchesTheWholeName) {
  EXPECT_TRUE(matches_stars("stress", "stress"));
  EXPECT_FALSE(matches_stars("stress", "stress 1"));
  EXPECT_FALSE(matches_stars("stress", "Stress"));
  EXPECT_TRUE(matches_stars("", ""));
  EXPECT_FALSE(matches_stars("", "a"));
}

TEST(StarPattern, AStarStandsForAnyTextAndForNone) {
  EXPECT_TRUE(matches_stars("stress *", "stress 12"));
  EXPECT_TRUE(matches_stars("stress*", "stress"));
  EXPECT_TRUE(matches_stars("*", ""));
  EXPECT_TRUE(matches_stars("***", "a"));
  EXPECT_TRUE(matches_stars("*_MPa", "s_1_MPa"));
  EXPECT_TRUE(matches_stars("a*b*c", "axxbyybzzc"));
  EXPECT_FALSE(matches_stars("a*b*c", "axxbyybzz"));
  EXPECT_FALSE(matches_stars("a*a", "a"));
  EXPECT_TRUE(matches_stars("*ab", "aab"));
}

/// What the pattern means, word for word.
bool by_trying_all(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  if (pattern[0] != '*') {
    return !name.empty() && pattern[0] == name[0] &&
           by_trying_all(pattern.substr(1), name.substr(1));
  }
  for (std::size_t skip = 0; skip <= name.size(); ++skip) {
    if (by_trying_all(pattern.substr(1), name.substr(skip))) return true;
  }
  return false;
}

TEST(StarPattern, AgreesWithTryingAllTextsForEachStar) {
  std::mt19937 random(1);
  const auto word = [&](std::string_view letters) {
    std::string text;
    for (std::size_t left = random() % 8; left > 0; --left)
      text += letters[random() % letters.size()];
    return text;
  };
  for (int i = 0; i < 20'000; ++i) {
    const std::string pattern = word("ab**");
    const std::string name = word("ab");
    ASSERT_EQ(matches_stars(pattern, name), by_trying_all(pattern, name)) << pattern << " " << name;
  }
}

TEST(StarPattern, ManyStarsTakeNoLongerThanTheirNumber) {
  std::string pattern;
  for (int i = 0; i < 1000; ++i) pattern += "*a";
  const std::string name(5000, 'a');
  EXPECT_TRUE(matches_stars(pattern, name));
  EXPECT_FALSE(matches_stars(pattern + "*b", name));
}

}  // namespace
}  // namespace plastica
