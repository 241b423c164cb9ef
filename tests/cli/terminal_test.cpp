#include "cli/terminal.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace plastica::cli
