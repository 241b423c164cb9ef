#include "plastica/io/csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/support/sanitized.hpp"

namespace plastica::io {
namespace {

using Names = std::vector<std::string>;

CsvTable parse(const std::string& text, const CsvOptions& options = {}) {
  return CsvTable::parse(text, "curve.csv", options);
}

TEST(Csv, ReadsCommaSeparatedNumbersUnderAHeader) {
  const CsvTable table = parse("Strain,Stress\n0,0\n1e-3,2.5E+2\n+0.5,-1.25\n");
  EXPECT_EQ(table.separator(), ',');
  EXPECT_EQ(table.decimal(), '.');
  EXPECT_EQ(table.names(), (Names{"Strain", "Stress"}));
  EXPECT_EQ(table.units(), (Names{"", ""}));
  EXPECT_EQ(table.numbers(0), (std::vector<double>{0.0, 1e-3, 0.5}));
  EXPECT_EQ(table.numbers(1), (std::vector<double>{0.0, 250.0, -1.25}));
  EXPECT_EQ(table.line_of_row(2), 4);
  EXPECT_FALSE(table.torn_last_row());
}

TEST(Csv, ReadsAMachineFileWithSemicolonsDecimalCommasUnitRowAndRemovedExtensometer) {
  const CsvTable table = parse(
      "Time;Crosshead separation;Load;Extensometer elongation\r\n(sec);(mm);(kN);(%)\r\n"
      "0;-0,00004;0,17097;-0,06942\r\n0,1;0,00188;1,7292E+1;0,5\r\n0,2;0,00412;17,5;\r\n"
      "0,3;0,005;17,6;\r\n");
  EXPECT_EQ(table.separator(), ';');
  EXPECT_EQ(table.decimal(), ',');
  EXPECT_EQ(table.names(),
            (Names{"Time", "Crosshead separation", "Load", "Extensometer elongation"}));
  EXPECT_EQ(table.units(), (Names{"sec", "mm", "kN", "%"}));
  EXPECT_EQ(table.rows(), 4U);
  EXPECT_EQ(table.line_of_row(0), 3);
  EXPECT_EQ(table.numbers(2), (std::vector<double>{0.17097, 17.292, 17.5, 17.6}));
  EXPECT_EQ(table.number(0, 3), -0.06942);
  EXPECT_TRUE(std::isnan(table.number(2, 3)));
}

TEST(Csv, KeepsAMetadataLineWithCommasOfItsOwnApart) {
  const CsvTable table = parse(
      "{'temperature':533.07, 'direction':'R22' }\nengineering_stress,engineering_strain\n"
      "2.48e-01,1.76e-06\n0.55,2.5e-05\n");
  EXPECT_EQ(table.preamble(), Names{"{'temperature':533.07, 'direction':'R22' }"});
  EXPECT_EQ(table.names(), (Names{"engineering_stress", "engineering_strain"}));
  EXPECT_EQ(table.number(0, 0), 0.248);
  EXPECT_EQ(table.line_of_row(0), 3);
}

TEST(Csv, KeepsKeyValueLinesOverAHeaderApart) {
  const CsvTable table = parse(
      "Specimen;Zx 1\nArea mm2;120,5\nSpeed;3\n\nStrain;Stress\n%;MPa\n0,1;20\n0,2;40\n0,3;60\n");
  EXPECT_EQ(table.preamble(), (Names{"Specimen;Zx 1", "Area mm2;120,5", "Speed;3"}));
  EXPECT_EQ(table.names(), (Names{"Strain", "Stress"}));
  EXPECT_EQ(table.units(), (Names{"%", "MPa"}));
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_EQ(table.line_of_row(0), 7);
}

TEST(Csv, KeepsMetadataAboveDataWithoutHeaderApart) {
  const CsvTable table = parse("{'temperature':533.07, 'direction':'R22'}\n0,0\n1,2\n2,4\n");
  EXPECT_EQ(table.preamble().size(), 1U);
  EXPECT_EQ(table.names(), (Names{"", ""}));
  EXPECT_EQ(table.rows(), 3U);
}

TEST(Csv, ReadsTabsAndAByteOrderMark) {
  const CsvTable table = parse("\xEF\xBB\xBFx\ty\n1,5\t\n2,5\t3\n");
  EXPECT_EQ(table.separator(), '\t');
  EXPECT_EQ(table.decimal(), ',');
  EXPECT_EQ(table.names(), (Names{"x", "y"}));
  EXPECT_EQ(table.number(1, 0), 2.5);
  EXPECT_TRUE(std::isnan(table.number(0, 1)));
}

TEST(Csv, ReadsDataWithoutHeaderFromTheFirstLine) {
  const CsvTable table = parse("0.0;1.0\n0.5;2.0\n");
  EXPECT_EQ(table.names(), (Names{"", ""}));
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.line_of_row(0), 1);
  EXPECT_EQ(table.find("2"), 1U);
}

TEST(Csv, TakesUnitsOutOfColumnNames) {
  const CsvTable table = parse(
      "Stress (MPa),Strain [%],Force / kN,Stress_MPa,Stress (true),Weg in mm,Run (2),E [N/mm^2]\n"
      "1,2,3,4,5,6,7,8\n1,2,3,4,5,6,7,8\n");
  EXPECT_EQ(table.names(), (Names{"Stress", "Strain", "Force", "Stress_MPa", "Stress (true)", "Weg",
                                  "Run (2)", "E"}));
  EXPECT_EQ(table.units(), (Names{"MPa", "%", "kN", "", "", "mm", "", "N/mm^2"}));
  EXPECT_EQ(table.find("Stress (MPa)"), 0U);
  EXPECT_EQ(table.find("Stress (true)"), 4U);
}

TEST(Csv, KeepsWhatIsNoUnitInANameAndKnowsAUnitThatTheRowOfUnitsContradicts) {
  const CsvTable table =
      parse("Strain,Stress (20 °C),Stress (150 °C),Force (N)\n%,MPa,MPa,N\n1,2,3,4\n1,2,3,4\n");
  EXPECT_EQ(table.names(), (Names{"Strain", "Stress (20 °C)", "Stress (150 °C)", "Force"}));
  EXPECT_EQ(table.units(), (Names{"%", "MPa", "MPa", "N"}));
  EXPECT_EQ(parse("a (N/mm^2),b\nMPa,%\n1,2\n1,2\n").units(), (Names{"MPa", "%"}));
  const CsvTable unlike = parse("Stress (GPa),b,Strain [1]\nMPa,%,%\n1,2,3\n1,2,3\n");
  EXPECT_EQ(unlike.units(), (Names{"MPa", "%", "%"}));
  EXPECT_EQ(unlike.unit_by_name(0), "GPa");
  EXPECT_EQ(unlike.unit_by_name(2), "") << "the first of several";
}

TEST(Csv, TurnsLatin1UnitsIntoUtf8) {
  const CsvTable table = parse(
      "Spannung [N/mm\xB2];Temperatur [\xB0"
      "C]\n1,5;20\n2,5;20\n");
  EXPECT_EQ(table.units(), (Names{"N/mm²", "°C"}));
}

TEST(Csv, ReadsQuotedCellsWithSeparatorsAndQuotesInside) {
  const CsvTable table = parse(
      "\"name, long\", \"a\"\"b\" ,value\n\"x, y\",\"5\"\" pipe\",\"1.5\"\n  p , 6\" pipe , 2.5 "
      "\n");
  EXPECT_EQ(table.names(), (Names{"name, long", "a\"b", "value"}));
  EXPECT_EQ(table.cell(0, 0), "x, y");
  EXPECT_EQ(table.cell(0, 1), "5\" pipe");
  EXPECT_EQ(table.cell(1, 1), "6\" pipe");
  EXPECT_EQ(table.numbers(2), (std::vector<double>{1.5, 2.5}));
}

TEST(Csv, ReadsQuotedDecimalCommasBetweenCommas) {
  const CsvTable table = parse("a,b\n\"0,5\",\"1,5\"\n\"0,75\",\"2,5\"\n");
  EXPECT_EQ(table.decimal(), ',');
  EXPECT_EQ(table.numbers(1), (std::vector<double>{1.5, 2.5}));
}

TEST(Csv, KeepsAnEmptyNameAtTheBeginningOfAHeaderOfTabs) {
  const CsvTable table = CsvTable::parse(
      "Test report\t\t\tOperator\n\tStrain [%]\tStress [MPa]\n1\t0.1\t70\n2\t0.2\t140\n", "a.tsv");
  ASSERT_EQ(table.columns(), 3U);
  EXPECT_EQ(table.names()[0], "");
  EXPECT_EQ(table.names()[1], "Strain");
  EXPECT_EQ(table.number(1, 2), 140.0);
}

TEST(Csv, DropsTheEmptyColumnOfTrailingSeparators) {
  for (const char* text : {"a,b,\n1,2,\n3,4,\n", "a,b\n1,2,\n3,4,\n", "a,b,\n1,2\n3,4\n"}) {
    const CsvTable table = parse(text);
    EXPECT_EQ(table.names(), (Names{"a", "b"})) << text;
    EXPECT_EQ(table.numbers(1), (std::vector<double>{2.0, 4.0})) << text;
  }
}

TEST(Csv, TakesLinesWithAHashAmidTheDataForComments) {
  const CsvTable table = parse("# a machine\na,b\n1,2\n# paused\n# on, again\n3,4\n#the end\n");
  EXPECT_EQ(table.numbers(1), (std::vector<double>{2.0, 4.0}));
  EXPECT_EQ(table.line_of_row(1), 6);
  EXPECT_FALSE(table.torn_last_row());
  EXPECT_EQ(parse("id,b\n#1,2\n#2,3\nx,4\n").rows(), 3U) << "a column of words";
}

TEST(Csv, SkipsBlankLinesAndRowsOfSeparators) {
  const CsvTable table = parse("a,b\n\n1,2\n , \n\n3,4\n,\n");
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.line_of_row(1), 6);
}

TEST(Csv, ReadsEveryWayToSayThatAValueIsMissingAsNaN) {
  const CsvTable table =
      parse("a,b\n1,1\n2,NaN\n3,nan\n4,NA\n5,n/a\n6,-\n7,null\n8,-nan(ind)\n9,\n10,-NaN\n11,1\n");
  EXPECT_EQ(table.rows(), 11U);
  for (std::size_t row = 1; row < 10; ++row) EXPECT_TRUE(std::isnan(table.number(row, 1))) << row;
}

TEST(Csv, CountsALeadingRowOfNaNAsData) {
  const CsvTable table = parse("a,b\nNaN,NaN\n1,2\n3,4\n");
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_EQ(table.names(), (Names{"a", "b"}));
}

TEST(Csv, ReadsAUnitRowOfDashesAsUnits) {
  const CsvTable table = parse("strain;stress\n-;MPa\n0,1;2\n0,2;3\n");
  EXPECT_EQ(table.units(), (Names{"-", "MPa"}));
  EXPECT_EQ(table.rows(), 2U);
}

TEST(Csv, DropsATornLastRowAndSaysSo) {
  for (const char* text : {"a,b\n1,2\n3,4\n5", "a,b\n1,2\n3,4\n5,", "a,b\n1,2\n3,4\n5,6e-",
                           "a,b\n1,2\n3,4\n5,-", "a,b\n1,2\n3,4\n5,\"6", "a,b\n1,2\n3,4\n5\n"}) {
    const CsvTable table = parse(text);
    EXPECT_TRUE(table.torn_last_row()) << text;
    EXPECT_EQ(table.rows(), 2U) << text;
  }
}

TEST(Csv, KeepsAWholeLastRowWithoutNewline) {
  const CsvTable table = parse("a,b\n1,2\n3,4");
  EXPECT_FALSE(table.torn_last_row());
  EXPECT_EQ(table.rows(), 2U);
}

TEST(Csv, ReadsATableWithTextColumns) {
  const CsvTable table =
      parse("test_id,test_type,temperature\r\ntest_ID_055,T,20\r\ntest_ID_056,T,150\r\n");
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.cell(1, 0), "test_ID_056");
  EXPECT_EQ(table.number(1, 2), 150.0);
}

TEST(Csv, ReadsATableOfTextAlone) {
  const CsvTable table = parse("id;lot\na1;A\na2;B\n");
  EXPECT_EQ(table.separator(), ';');
  EXPECT_EQ(table.names(), (Names{"id", "lot"}));
  EXPECT_EQ(table.rows(), 2U);
}

TEST(Csv, ReadsASingleColumn) {
  const CsvTable table = parse("stress\n1.5\n2.5\n");
  EXPECT_EQ(table.columns(), 1U);
  EXPECT_EQ(table.numbers(0), (std::vector<double>{1.5, 2.5}));
}

TEST(Csv, ReadsAHeaderAndOneRow) {
  const CsvTable table = parse("id,area,lot\nx1,2.5,A\n");
  EXPECT_EQ(table.names(), (Names{"id", "area", "lot"}));
  EXPECT_EQ(table.number(0, 1), 2.5);
}

TEST(Csv, ReadsACommentedHeader) {
  const CsvTable table = parse("# strain, stress\n0.1,2\n0.2,3\n");
  EXPECT_EQ(table.names(), (Names{"strain", "stress"}));
}

TEST(Csv, ObeysGivenSeparatorDecimalMarkAndHeaderLine) {
  const CsvTable semicolons = parse("1,5;2,5\n3,5;4,5\n", {.separator = ',', .decimal = '.'});
  EXPECT_EQ(semicolons.columns(), 3U);
  const CsvTable given = parse("2019,2020\n1,2\n3,4\n", {.header = 1});
  EXPECT_EQ(given.names(), (Names{"2019", "2020"}));
  EXPECT_EQ(given.rows(), 2U);
  const CsvTable none = parse("x,y\n1,2\n3,4\n", {.header = 0});
  EXPECT_EQ(none.names(), (Names{"", ""}));
  EXPECT_EQ(none.preamble(), Names{"x,y"});
}

TEST(Csv, FindsColumnsByNameWithoutCaseAndByNumber) {
  const CsvTable table = parse("Strain,Stress,2\n1,2,3\n4,5,6\n");
  EXPECT_EQ(table.find("Stress", {}, "column"), 1U);
  EXPECT_EQ(table.find("STRESS"), 1U);
  EXPECT_EQ(table.find("3"), 2U);
  EXPECT_EQ(table.find("4"), std::nullopt);
  EXPECT_EQ(table.find("0"), std::nullopt);
  EXPECT_EQ(table.find(""), std::nullopt);
}

TEST(Csv, PrefersANameToANumber) {
  const CsvTable table = parse("3;1;2\n1,5;2;3\n4;5;6\n", {.header = 1});
  EXPECT_EQ(table.find("3"), 0U);
}

TEST(Csv, KeepsItsCellsWhenMoved) {
  CsvTable table = parse("a,b\n1,2\n3,4\n");
  const CsvTable moved = std::move(table);
  EXPECT_EQ(moved.cell(1, 1), "4");
}

// To read the text once more for each of its rows would take the test beyond its time limit.
TEST(Csv, ReadsMegabytes) {
  constexpr std::size_t kRows = testing::kSanitized ? 100'000 : 1'000'000;
  std::string text = "Time;Force\n(s);(kN)\n";
  for (std::size_t row = 0; row < kRows; ++row) text += "1234,5;0,123456789\n";
  const CsvTable table = parse(text);
  EXPECT_EQ(table.rows(), kRows);
  EXPECT_EQ(table.numbers(1).back(), 0.123456789);
}

/// A table of specimens in which a value is missing, above all in its first rows.
TEST(Csv, RowsOfWordsWithoutTheirNumbersAreRows) {
  for (const std::string missing : {"", "n/a"}) {
    const std::string one = "A-01," + missing + ",A\n";
    const std::string two = "A-02," + missing + ",A\n";
    for (const std::string& rows :
         {one + "A-02,78.5,A\nA-03,78.5,B\n", one + two + "A-03,78.5,A\nA-04,78.5,A\n",
          "A-01,78.5,A\n" + two + "A-03,78.5,\nB-01,785.4,B\nB-02,7854,B\n"}) {
      const CsvTable table = CsvTable::parse("specimen,S0_mm2,batch\n" + rows, "info.csv");
      EXPECT_EQ(table.names(), (std::vector<std::string>{"specimen", "S0_mm2", "batch"})) << rows;
      EXPECT_EQ(table.cell(0, 0), "A-01") << rows;
      EXPECT_EQ(table.rows(), static_cast<std::size_t>(std::ranges::count(rows, '\n'))) << rows;
    }
  }
}

}  // namespace
}  // namespace plastica::io
