#include "sweeps/report/markup.hpp"

#include <gtest/gtest.h>

#include "tests/support/has.hpp"
#include "tests/sweeps/run_record.hpp"

namespace plastica::sweeps {
namespace {

using plastica::testing::has;

TEST(MarkdownTable, HasATableForEachGroup) {
  const std::string text = markdown_table(two_groups());
  EXPECT_TRUE(has(text,
                  "\n**rules.end\\_rule = equal**\n\n"
                  "| beam.segments | tip, end \\[m\\] | error \\[%\\] | order | "
                  "work \\[segment-it.\\] |\n| --: | --: | --: | --: | --: |\n| 4 | "))
      << text;
  EXPECT_TRUE(has(text, "|\n\norder 0.9")) << text;
}

TEST(MarkdownTable, EscapesWhatMarkdownReads) {
  SweepRecord record = two_groups();
  record.results[0].reason = "a|b *c*\n`d`";
  const std::string text = markdown_table(record);
  EXPECT_TRUE(has(text, "| a\\|b \\*c\\* \\`d\\` |\n")) << text;
  EXPECT_TRUE(has(text, "| :-- |\n")) << "a column of remarks";
}

TEST(LatexTable, IsOneTabular) {
  const std::string text = latex_table(two_groups());
  EXPECT_TRUE(has(text,
                  "\n\\begin{tabular}{rrrrr}\n\\hline\n"
                  "beam.segments & tip, end & error & order & work \\\\\n"
                  " & m & \\% &  & segment-it. \\\\\n\\hline\n"
                  "\\multicolumn{5}{l}{rules.end\\_rule = half\\_joint} \\\\\n4 & $-$0.7"))
      << text;
  EXPECT_TRUE(text.ends_with("\\hline\n\\end{tabular}\n"));
}

TEST(LatexTable, EscapesWhatLatexReads) {
  SweepRecord record = two_groups();
  record.results[0].reason = "50% of $a_b$ {c} \\d ~ ^ # & -- <<";
  EXPECT_TRUE(has(latex_table(record),
                  "50\\% of \\$a\\_b\\$ \\{c\\} \\textbackslash{}d \\textasciitilde{} "
                  "\\textasciicircum{} \\# \\& -{}- \\textless{}\\textless{} \\\\\n"))
      << latex_table(record);
}

TEST(LatexTable, ShowsADashWhereThereIsNoValue) {
  SweepRecord record = two_groups();
  record.results[0].value.reset();
  record.comparison.error[0].reset();
  EXPECT_TRUE(has(latex_table(record), "\n4 & -- & -- &  & ")) << latex_table(record);
}

}  // namespace
}  // namespace plastica::sweeps
