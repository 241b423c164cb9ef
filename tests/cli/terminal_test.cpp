#include "cli/terminal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace plastica::cli {
namespace {

TEST(InAscii, KeepsAsciiAndPutsWhatReportsUse) {
  EXPECT_EQ(in_ascii("E 205.0 GPa\n").text, "E 205.0 GPa\n");
  EXPECT_EQ(in_ascii("σ_y ± 2 µm²").text, "s_y +- 2 um2");
  EXPECT_EQ(in_ascii("力x\xf0\x9f\x98\x80y").text, "?x?y");
}

// A letter may be cut between two writes.
TEST(InAscii, LeavesALetterThatIsNotWhole) {
  const std::string text = "ab±";
  const AsciiText ascii = in_ascii(std::string_view(text).substr(0, 3));
  EXPECT_EQ(ascii.text, "ab");
  EXPECT_EQ(ascii.taken, 2U);
  EXPECT_EQ(in_ascii("").taken, 0U);
}

TEST(BrokenLine, LeavesShortOnesAsTheyAre) {
  EXPECT_EQ(broken_line("", 20), "");
  EXPECT_EQ(broken_line("  exactly twenty col", 20), "  exactly twenty col");
}

TEST(BrokenLine, BreaksBetweenWordsAndStandsFurtherIn) {
  EXPECT_EQ(broken_line("  one two three four five six seven", 20),
            "  one two three four\n      five six seven");
  EXPECT_EQ(broken_line("0123456789012345678901234567890", 20),
            "01234567890123456789\n    01234567890");
  EXPECT_EQ(broken_line("σσσσσσσσσσ σσσσσσσσσσσσ", 20), "σσσσσσσσσσ\n    σσσσσσσσσσσσ");
}

TEST(BrokenLine, CountsNoColours) {
  EXPECT_EQ(broken_line("\033[1mone two three four\033[0m", 20),
            "\033[1mone two three four\033[0m");
}

// Whatever the line: no piece is too long, and no letter is lost.
TEST(BrokenLine, LosesNothing) {
  std::string line;
  for (int i = 0; i < 200; ++i) {
    line += std::string(static_cast<std::size_t>(i * 7 % 31), 'x') + (i % 3 == 0 ? "  " : " ");
    for (const std::size_t width : {20U, 37U, 60U}) {
      const std::string broken = broken_line(line, width);
      std::size_t column = 0;
      for (const char c : broken) {
        column = c == '\n' ? 0 : column + 1;
        ASSERT_LE(column, width) << broken;
      }
      EXPECT_EQ(std::ranges::count(broken, 'x'), std::ranges::count(line, 'x'));
    }
  }
}

}  // namespace
}  // namespace plastica::cli
