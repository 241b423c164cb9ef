#include "plastica/io/nearest_word.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace plastica::io {
namespace {

TEST(NearestWord, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("files", "files"), 0U);
  EXPECT_EQ(edit_distance("", "file"), 4U);
  EXPECT_EQ(edit_distance("file", "files"), 1U);
  EXPECT_EQ(edit_distance("flies", "files"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(NearestWord, IgnoresCase) { EXPECT_EQ(edit_distance("YIELD", "yield"), 0U); }

TEST(NearestWord, FindsTheNearestOfSeveral) {
  const std::vector<std::string> words{"stress", "strain", "area"};
  EXPECT_EQ(nearest_word("strian", words), "strain");
  EXPECT_EQ(nearest_word("stres", words), "stress");
}

TEST(NearestWord, SuggestsNothingForAWordThatIsNotLikeAny) {
  EXPECT_EQ(nearest_word("colour", std::vector<std::string>{"stress", "files"}), std::nullopt);
  EXPECT_EQ(nearest_word("x", std::vector<std::string>{"y"}), std::nullopt);
}

}  // namespace
}  // namespace plastica::io
