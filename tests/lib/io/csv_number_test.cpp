#include "plastica/io/csv.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Numbers and lines as laboratories in other countries, and other programs, write them.
namespace plastica::io {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;

CsvTable table_of(const std::string& text, const CsvOptions& options = {}) {
  return CsvTable::parse(text, "curve.csv", options);
}

TEST(CsvNumbers, ThousandsMayStandApart) {
  const Values wanted{999.5, 1234.5, -1234567.25};
  EXPECT_EQ(table_of("a,b\n1,999.5\n2,\"1,234.5\"\n3,\"-1,234,567.25\"\n").numbers(1), wanted);
  EXPECT_EQ(table_of("a;b\n1;999,5\n2;1.234,5\n3;-1.234.567,25\n").numbers(1), wanted);
  EXPECT_EQ(table_of("a;b\n1;999,5\n2;1 234,5\n3;-1 234 567,25\n").numbers(1), wanted);
  EXPECT_EQ(table_of("a;b\n1;999.5\n2;1'234.5\n3;-1'234'567.25\n").numbers(1), wanted);
  EXPECT_EQ(table_of("a;b\n1;999,5\n2;1\u00A0234,5\n3;-1\u202F234\u202F567,25\n").numbers(1),
            wanted);
}

TEST(CsvNumbers, WhereTheDecimalMarkIsKnownTheOtherPartsThousands) {
  EXPECT_EQ(table_of("a;b\n0,1;999\n0,2;1.000\n0,25;12.000\n").numbers(1),
            (Values{999.0, 1000.0, 12000.0}));
  EXPECT_EQ(table_of("a;b\n0.1;999\n0.2;1,000\n0.25;12,000\n").numbers(1),
            (Values{999.0, 1000.0, 12000.0}));
  // Numbers of three decimals are no thousands.
  EXPECT_EQ(table_of("a;b\n0,1;1,234\n0,2;2,345\n").numbers(1), (Values{1.234, 2.345}));
  EXPECT_EQ(table_of("a;b\n1;1,234\n2;2,345\n").numbers(1), (Values{1.234, 2.345}));
  EXPECT_EQ(table_of("a,b\n1,1.234\n2,100\n").numbers(1), (Values{1.234, 100.0}));
}

/// 2.333 N beside 1667 um/m: a decimal or 2333?
TEST(CsvNumbers, WhatMayBeThousandsIsRefusedWithEitherMark) {
  for (const char* text : {"a;b\n0;0\n1667;2.333\n3333;3.667\n", "a;b\n0;998\n1;1.002\n",
                           "a;b\n0;0\n1667;2,333\n3333;3,667\n", "a\tb\n0\t998\n1\t1.002\n"}) {
    EXPECT_THROW(table_of(text), InputError) << text;
  }
  EXPECT_EQ(table_of("a;b\n0.000;1.234\n1.250;2.345\n").numbers(1), (Values{1.234, 2.345}));
  EXPECT_EQ(table_of("a;b\n0;0.5\n1;1.234\n").numbers(1), (Values{0.5, 1.234}));
}

TEST(CsvNumbers, DecimalCommasBetweenBlanksAreNoCellsOfThousands) {
  const CsvTable table =
      table_of("Dehnung(%) Spannung(MPa)\n0,10 100,00\n0,11 126,67\n0,12 153,33\n");
  EXPECT_EQ(table.names(), (std::vector<std::string>{"Dehnung", "Spannung"}));
  EXPECT_EQ(table.numbers(1), (Values{100.0, 126.67, 153.33}));
}

TEST(CsvNumbers, BlanksOfATimeStampSeparateNothing) {
  const CsvTable table = table_of(
      "Specimen A 12\nWidth 10 mm\nTime,Strain,Stress (MPa)\n2024-01-05 10:00:00,0.0005,105.0\n"
      "2024-01-05 10:00:01,0.0010,205.0\n2024-01-05 10:00:02,0.0015,305.0\n");
  EXPECT_EQ(table.columns(), 3U);
  EXPECT_EQ(table.numbers(2), (Values{105.0, 205.0, 305.0}));
}

TEST(CsvNumbers, RowsOfMissingNumbersAreNoHeader) {
  const CsvTable table = table_of("0.0,0\n0.1,20\nn/a,n/a\n0.2,40\n0.3,60\n");
  EXPECT_EQ(table.rows(), 5U);
}

TEST(CsvNumbers, AShortTableOfResultsIsNotTheCurve) {
  const CsvTable table = table_of(
      "\"\",\"Maximum Load (N)\",\"Stress at Maximum (MPa)\"\n\"1\",\"39840.00\",\"498.00\"\n"
      "\"Time\",\"Strain\",\"Load\"\n\"(s)\",\"(%)\",\"(N)\"\n0.0,0.0,0.0\n0.1,0.1,900.5\n"
      "0.2,0.2,1800.5\n0.3,0.3,2700.5\n0.4,0.4,3600.5\n");
  EXPECT_EQ(table.names(), (std::vector<std::string>{"Time", "Strain", "Load"}));
  EXPECT_EQ(table.units(), (std::vector<std::string>{"s", "%", "N"}));
  EXPECT_EQ(table.rows(), 5U);
}

TEST(CsvNumbers, NamesOfColumnsAreNoUnits) {
  const CsvTable table = table_of("Sample,A1\nstrain,force\n0.0,0.5\n0.1,1.5\n0.2,2.5\n");
  EXPECT_EQ(table.names(), (std::vector<std::string>{"strain", "force"}));
}

TEST(CsvNumbers, UnitsStandInWideBracketsAndAtTheEndOfNames) {
  const CsvTable table = table_of(
      "\u65f6\u95f4\uff08s\uff09,Strain %,Kraft/kN,\"Force, N\",Strain\uff08%\uff09,N/mm2\n"
      "0.1,0.5,1.5,1,2,3\n0.2,0.7,2.5,2,3,4\n");
  EXPECT_EQ(table.units(), (std::vector<std::string>{"s", "%", "kN", "N", "%", ""}));
  EXPECT_EQ(table.names()[2], "Kraft");
}

TEST(CsvNumbers, WhatIsNotGroupedByThreesIsNoNumber) {
  for (const char* cell : {"1,23.5", "1,2345.5", "0,123.5", "1,234,5", "1 23", "12.34.567"}) {
    const CsvTable table =
        table_of("a;b\n0.5;1.25\n0.7;1.5\n0.75;" + std::string(cell) + "\n1.5;2\n");
    EXPECT_THROW(table.numbers(1), InputError) << cell;
  }
}

TEST(CsvNumbers, BlanksSeparateAsManyAsThereAre) {
  const CsvTable table = table_of(
      "Bar 7\n Axial Strain  (%)   Stress (MPa)\n  0.00    1.5\n\n"
      "  0.25   20.5 \n\t10.5  350\n");
  EXPECT_EQ(table.separator(), ' ');
  EXPECT_EQ(table.names(), (Names{"Axial Strain", "Stress"}));
  EXPECT_EQ(table.units(), (Names{"%", "MPa"}));
  EXPECT_EQ(table.numbers(0), (Values{0.0, 0.25, 10.5}));
  EXPECT_EQ(table.numbers(1), (Values{1.5, 20.5, 350.0}));
  const CsvTable single = table_of("Strain Stress\n% MPa\n0 1\n1 \"2\"\n");
  EXPECT_EQ(single.names(), (Names{"Strain", "Stress"}));
  EXPECT_EQ(single.units(), (Names{"%", "MPa"}));
  EXPECT_EQ(single.numbers(1), (Values{1.0, 2.0}));
  // A comma and a blank is a comma.
  EXPECT_EQ(table_of("a, b, c\n1, 2, 3\n4, 5, 6\n").columns(), 3U);
  EXPECT_EQ(table_of("a b\n1,5 2\n2,5 3\n", {.separator = ' '}).numbers(0), (Values{1.5, 2.5}));
}

TEST(CsvNumbers, CommentsBeginWithPercentOrTwoSlashes) {
  const CsvTable table =
      table_of("% by rig\n// 7\nStrain,Stress\n0,1\n% paused\n//2,3\n4,5\n# end\n");
  EXPECT_EQ(table.names(), (Names{"Strain", "Stress"}));
  EXPECT_EQ(table.numbers(1), (Values{1.0, 5.0}));
  EXPECT_EQ(table.commented_rows(), 1U);
}

TEST(CsvNumbers, Utf16IsReadInEitherOrderWithAMarkOrWithout) {
  const std::string text = "Strain,Stress\n0,1\n2,3\n";
  for (const bool big : {false, true}) {
    for (const bool mark : {false, true}) {
      std::string wide;
      const auto put = [&](char low, char high) {
        wide += big ? high : low;
        wide += big ? low : high;
      };
      if (mark) put('\xFF', '\xFE');
      for (const char c : text) put(c, '\0');
      EXPECT_EQ(table_of(wide).numbers(1), (Values{1.0, 3.0})) << big << mark;
    }
  }
  // "ε (%)" and a character beyond the first plane, as its two halves.
  const std::string greek(
      "\xFF\xFE\xB5\x03 \0(\0%\0)\0,\0=\xD8\x00\xDE\n\0"
      "1\0,\0"
      "2\0\n\0",
      28);
  EXPECT_EQ(table_of(greek).names(), (Names{"\u03B5", "\U0001F600"}));
  EXPECT_EQ(table_of(greek).units(), (Names{"%", ""}));
}

}  // namespace
}  // namespace plastica::io
