#include "calibrate/guess/specimens.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace plastica::calibrate {
namespace {

using Columns = std::vector<std::size_t>;

/// Runs of eleven rows, whose strain rises from 0 to 10; `begin` are the first cells of a run.
std::string rows_of(const std::vector<std::string>& begins) {
  std::string text;
  for (const std::string& begin : begins) {
    for (int i = 0; i <= 10; ++i) {
      text += begin + "," + std::to_string(i) + "," + std::to_string(i * 20) + "\n";
    }
  }
  return text;
}

Columns split_of(const std::string& header, const std::vector<std::string>& begins) {
  const io::CsvTable table = io::CsvTable::parse(header + "\n" + rows_of(begins), "s.csv");
  const std::size_t strain = table.columns() - 2;
  return find_split(table, table.numbers(strain), {strain, strain + 1}).columns;
}

TEST(FindSplit, TakesTheColumnThatChangesWhereTheStrainBeginsAnew) {
  EXPECT_EQ(split_of("Specimen,Strain,Stress", {"1", "2", "3"}), Columns{0});
  EXPECT_EQ(split_of("Width,Specimen,Strain,Stress", {"5.1,a", "5.2,b"}), Columns{1});
  EXPECT_EQ(split_of("Width,Strain,Stress", {"5.1", "5.2"}), Columns{0});
}

TEST(FindSplit, TakesAsManyAsItNeeds) {
  EXPECT_EQ(split_of("Heat,TestID,RepeatID,Strain,Stress", {"9,0,1", "9,0,2", "9,1,1"}),
            (Columns{1, 2}));
}

TEST(FindSplit, LeavesOneSpecimenWhole) {
  EXPECT_EQ(split_of("Specimen,Strain,Stress", {"1", "1", "1"}), Columns{});
  EXPECT_EQ(split_of("Specimen,Strain,Stress", {"1"}), Columns{});
  // A column that changes amid a rising strain, such as a stage of the test, is none.
  const io::CsvTable table = io::CsvTable::parse(
      "Stage,Strain,Stress\n1,0,0\n1,1,20\n1,2,40\n1,3,60\n2,4,80\n2,5,90\n2,6,95\n2,7,97\n", "s");
  EXPECT_TRUE(find_split(table, table.numbers(1), {1, 2}).columns.empty());
}

TEST(FindSplit, MixesNoSpecimensOfOneTemperature) {
  EXPECT_EQ(split_of("Temp,Strain,Stress", {"20", "20", "100"}), Columns{});
  EXPECT_EQ(split_of("Temp,Strain,Stress", {"20", "80", "100"}), Columns{0});
  EXPECT_EQ(split_of("Width,Strain,Stress", {"12.5", "12.5", "12.48"}), Columns{});
}

TEST(FindSplit, CountsWhatOneNameHasSeveralTimes) {
  const io::CsvTable table =
      io::CsvTable::parse("Specimen,Strain,Stress\n" + rows_of({"A", "A", "B"}), "s.csv");
  const FoundSplit split = find_split(table, table.numbers(1), {1, 2});
  EXPECT_EQ(split.columns, Columns{0});
  EXPECT_EQ(split.parts, 2U);
  EXPECT_EQ(split.untold, 1U);
}

TEST(FindSplit, TakesNoStagesOfOneTestAndNoGapsForSpecimens) {
  EXPECT_EQ(split_of("Cycle,Strain,Stress", {"1", "2", "3"}), Columns{});
  EXPECT_EQ(split_of("Schritt,Strain,Stress", {"1", "2", "3"}), Columns{});
  EXPECT_EQ(split_of("Area,Strain,Stress", {"80", ""}), Columns{});
}

TEST(Restarts, AreFallsBelowATenthOfWhatWasReached) {
  EXPECT_EQ(restarts_of(std::vector<double>{0, 1, 2, 0.1, 1, 2, 3, 0.29, 1}), (Columns{3, 7}));
  EXPECT_EQ(restarts_of(std::vector<double>{0, 1, 2, 1.5, 3}), Columns{});
}

}  // namespace
}  // namespace plastica::calibrate
