#include "plastica/report/format.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "plastica/report/table.hpp"

namespace plastica::report {
namespace {

TEST(Numbers, HaveAsManyDecimalsAsTheirErrorHasTwoDigits) {
  EXPECT_EQ(with_error(281.2345, 0.41234), "281.23 ± 0.41");
  EXPECT_EQ(with_error(281.2345, 12.34), "281 ± 12");
  EXPECT_EQ(with_error(70.0, 0.0996), "70.000 ± 0.100");
  EXPECT_EQ(with_error(-3.25, 0.5), "-3.25 ± 0.50");
}

TEST(Numbers, WithTinyErrorsShowSevenDigitsAndTheErrorStillShows) {
  EXPECT_EQ(with_error(281.2345, 3.2e-8), "281.2345 ± 3.2e-08");
  EXPECT_EQ(with_error(281.2345, 0.0), "281.23 ± 0");
  EXPECT_EQ(with_error(1e-7, 2e-9), "1.0000e-07 ± 2.0e-09");
}

TEST(Numbers, KeepTheirSignificantDigits) {
  EXPECT_EQ(significant(281.2345), "281.23");
  EXPECT_EQ(significant(0.0123456, 3), "0.0123");
  EXPECT_EQ(significant(0.0), "0.0000");
  EXPECT_EQ(significant(1.5e-9, 3), "1.50e-09");
  EXPECT_EQ(significant(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(brief(2000.0), "2000");
  EXPECT_EQ(brief(0.1), "0.1");
}

TEST(DisplayUnits, FollowTheMagnitudeOfAStress) {
  EXPECT_EQ(display_unit(Dimension::Stress, 280e6).name, "MPa");
  EXPECT_EQ(display_unit(Dimension::Stress, 3e9).name, "MPa");
  EXPECT_EQ(display_unit(Dimension::Stress, 3e9, true).name, "GPa");
  EXPECT_EQ(display_unit(Dimension::Stress, -70e9).name, "GPa");
  EXPECT_EQ(display_unit(Dimension::Stress, 0.1).name, "Pa");
  EXPECT_EQ(display_unit(Dimension::Strain, 0.1).name, "%");
  EXPECT_EQ(display_unit(Dimension::None, 0.1).name, "");
  EXPECT_EQ(display_unit(Dimension::Length, 0.1).name, "m");
}

TEST(UserText, LosesControlCharactersAndBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("a\x1b[31m\tb\n"), "a [31m b ");
  EXPECT_EQ(printable("stahl-\xFC-\xC3\xBC"), "stahl-?-ü");
  EXPECT_EQ(printable("\xC0\xAF\xED\xA0\x80"), "?????");
  EXPECT_EQ(printable("\xEF\xBF\xBF\xC2\x85 σ_y ± 3 %"), "?  σ_y ± 3 %");
}

TEST(UserText, IsCutAtWholeCharacters) {
  EXPECT_EQ(width_of("σ_y ± 1"), 7U);
  EXPECT_EQ(cut("σσσσ", 4), "σσσσ");
  EXPECT_EQ(cut("σσσσσ", 4), "σσσ…");
}

TEST(Paragraphs, AreWrappedBelowTheirFirstLine) {
  EXPECT_EQ(wrapped("  - ", "one two three four five six seven", 24),
            "  - one two three four\n    five six seven\n");
  EXPECT_EQ(
      wrapped("", std::string(50, 'x'), 20),
      std::string(20, 'x') + "\n" + std::string(20, 'x') + "\n" + std::string(10, 'x') + "\n");
  EXPECT_EQ(wrapped("a: ", "", 20), "a: \n");
}

TEST(Tables, AlignPlusMinusSignsWhateverStandsAround) {
  Table table({{"name", Table::Align::Left}, {"value", Table::Align::PlusMinus}, {"n"}});
  table.add({"a", "281.23 ± 0.41", "1"});
  table.add({"bcd", "9.1 ± 12.5", "10"});
  table.add({"e", "12"});
  table.add_note("a remark");
  EXPECT_EQ(table.text(2, 80),
            "  name          value   n\n"
            "  a     281.23 ± 0.41   1\n"
            "  bcd      9.1 ± 12.5  10\n"
            "  e         12\n"
            "        a remark\n");
}

TEST(Tables, CutTheFirstColumnWhereTheyAreTooWide) {
  Table table({{"name", Table::Align::Left}, {"x"}});
  table.add({std::string(60, 'n'), "123456"});
  for (const std::size_t width : {30U, 40U}) {
    const std::string text = table.text(2, width);
    EXPECT_NE(text.find("n…  123456\n"), std::string::npos) << text;
    EXPECT_EQ(width_of(text.substr(text.find('\n') + 1)), width + 1) << text;
  }
}

}  // namespace
}  // namespace plastica::report
