#include <gtest/gtest.h>

#include <string>

#include "calibrate/guess/guess_file.hpp"

namespace plastica::calibrate {
namespace {

TargetSource guess(const std::string& header) {
  std::string text = header + "\n";
  for (const char* row : {"0.0,1.0,2.0,3.0\n", "0.1,1.5,2.5,3.5\n", "0.2,2.0,3.0,4.0\n"})
    text += row;
  return guess_file(io::CsvTable::parse(text, "guess.csv")).blocks.front().source;
}

TEST(GuessFile, ReadsAUnitFromTheEndOfAName) {
  const TargetSource source = guess("Strain,Stress_MPa,a,b");
  EXPECT_EQ(source.strain.value().column, "Strain");
  EXPECT_FALSE(source.strain->unit.has_value());
  EXPECT_EQ(source.stress.value().column, "Stress_MPa");
  EXPECT_EQ(source.stress->unit, "MPa");
}

TEST(GuessFile, TakesNoWordForAUnitThatIsNone) {
  const TargetSource source = guess("engineering_stress,engineering_strain,a,b");
  EXPECT_EQ(source.stress.value().column, "engineering_stress");
  EXPECT_FALSE(source.stress->unit.has_value());
  EXPECT_EQ(source.strain.value().column, "engineering_strain");
}

TEST(GuessFile, SeesTrueMeasuresAndSkipsRates) {
  const TargetSource source = guess("strain_rate,e_true,Sigma_true,b");
  EXPECT_EQ(source.strain.value().column, "e_true");
  EXPECT_EQ(source.stress.value().column, "Sigma_true");
  EXPECT_EQ(source.measure, Measure::True);
}

TEST(GuessFile, TakesLoadAndExtensometerWhereThereIsNoStress) {
  const TargetSource source = guess("Time (s),Load (kN),Extensometer elongation (mm),x");
  EXPECT_EQ(source.force.value().column, "Load");
  EXPECT_EQ(source.force->unit, "kN");
  EXPECT_EQ(source.elongation.value().unit, "mm");
  EXPECT_FALSE(source.strain.has_value());
  const TargetSource fraction = guess("Time (s),Load (kN),Extensometer elongation (%),x");
  EXPECT_EQ(fraction.strain.value().unit, "%");
  EXPECT_FALSE(fraction.elongation.has_value());
}

TEST(GuessFile, LeavesEmptyWhatItCannotTell) {
  const TargetSource source = guess("a,b,c,d");
  EXPECT_FALSE(source.strain || source.elongation || source.stress || source.force);
}

TEST(GuessFile, SpecimensSideBySideAreABlockEach) {
  std::string text = "Strain 1 [%],Stress 1 [MPa],Strain 2 [%],Stress 2 [MPa]\n";
  for (int i = 0; i < 10; ++i) text += "0." + std::to_string(i) + ",10,0.2,20\n";
  const FileGuess guess = guess_file(io::CsvTable::parse(text, "two.csv"));
  ASSERT_EQ(guess.blocks.size(), 2U);
  EXPECT_EQ(guess.blocks[1].source.strain->column, "Strain 2");
  EXPECT_EQ(guess.blocks[1].source.stress->column, "Stress 2");
  // By their numbers, where the names are the same.
  std::string same = "Strain,Stress,Strain,Stress\n%,MPa,%,MPa\n";
  for (int i = 0; i < 10; ++i) same += "0." + std::to_string(i) + ",10,0.2,20\n";
  const FileGuess numbered = guess_file(io::CsvTable::parse(same, "two.csv"));
  ASSERT_EQ(numbered.blocks.size(), 2U);
  EXPECT_EQ(numbered.blocks[1].source.strain->column, "3");
  EXPECT_EQ(numbered.blocks[0].source.stress->column, "2");
}

TEST(GuessFile, OtherColumnsThatMayBeMeantAreTold) {
  std::string text = "Strain 1 [%],Strain 2 [%],Stress [MPa]\n";
  for (int i = 0; i < 10; ++i) text += "0." + std::to_string(i) + ",0.1,20\n";
  const FileGuess guess = guess_file(io::CsvTable::parse(text, "two.csv"));
  ASSERT_EQ(guess.blocks.size(), 1U);
  EXPECT_EQ(guess.notes, std::vector<std::string>{"the strain is column 1, \"Strain 1\"; it may be "
                                                  "\"Strain 2\" (no. 2) as well"});
}

TEST(GuessFile, CompressionIsTurned) {
  std::string text = "Strain [%],Stress [MPa]\n0,1\n";
  for (int i = 0; i < 10; ++i) text += "-0." + std::to_string(i) + ",-" + std::to_string(i) + "0\n";
  const BlockGuess block = guess_file(io::CsvTable::parse(text, "c.csv")).blocks.front();
  EXPECT_EQ(block.source.strain->factor, -1.0);
  EXPECT_EQ(block.source.stress->factor, -1.0);
}

}  // namespace
}  // namespace plastica::calibrate
