#include <gtest/gtest.h>

#include <string>

#include "calibrate/target/import.hpp"

namespace plastica::calibrate {
namespace {

TargetSource guess(const std::string& header) {
  std::string text = header + "\n";
  for (const char* row : {"0.0,1.0,2.0,3.0\n", "0.1,1.5,2.5,3.5\n", "0.2,2.0,3.0,4.0\n"})
    text += row;
  return guess_source(io::CsvTable::parse(text, "guess.csv"));
}

TEST(GuessSource, ReadsAUnitFromTheEndOfAName) {
  const TargetSource source = guess("Strain,Stress_MPa,a,b");
  EXPECT_EQ(source.strain.value().column, "Strain");
  EXPECT_FALSE(source.strain->unit.has_value());
  EXPECT_EQ(source.stress.value().column, "Stress_MPa");
  EXPECT_EQ(source.stress->unit, "MPa");
}

TEST(GuessSource, TakesNoWordForAUnitThatIsNone) {
  const TargetSource source = guess("engineering_stress,engineering_strain,a,b");
  EXPECT_EQ(source.stress.value().column, "engineering_stress");
  EXPECT_FALSE(source.stress->unit.has_value());
  EXPECT_EQ(source.strain.value().column, "engineering_strain");
}

TEST(GuessSource, SeesTrueMeasuresAndSkipsRates) {
  const TargetSource source = guess("strain_rate,e_true,Sigma_true,b");
  EXPECT_EQ(source.strain.value().column, "e_true");
  EXPECT_EQ(source.stress.value().column, "Sigma_true");
  EXPECT_EQ(source.measure, Measure::True);
}

TEST(GuessSource, TakesLoadAndExtensometerWhereThereIsNoStress) {
  const TargetSource source = guess("Time (s),Load (kN),Extensometer elongation (mm),x");
  EXPECT_EQ(source.force.value().column, "Load");
  EXPECT_EQ(source.force->unit, "kN");
  EXPECT_EQ(source.elongation.value().unit, "mm");
  EXPECT_FALSE(source.strain.has_value());
  const TargetSource fraction = guess("Time (s),Load (kN),Extensometer elongation (%),x");
  EXPECT_EQ(fraction.strain.value().unit, "%");
  EXPECT_FALSE(fraction.elongation.has_value());
}

TEST(GuessSource, LeavesEmptyWhatItCannotTell) {
  const TargetSource source = guess("a,b,c,d");
  EXPECT_FALSE(source.strain || source.elongation || source.stress || source.force);
}

}  // namespace
}  // namespace plastica::calibrate
