#include <gtest/gtest.h>

#include <string>
#include <vector>

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
  const auto row = [](int i) {
    const std::string n = std::to_string(i);
    return "0." + n + ",1" + n + ",0." + n + ",2" + n + "\n";
  };
  for (int i = 0; i < 10; ++i) text += row(i);
  const FileGuess guess = guess_file(io::CsvTable::parse(text, "two.csv"));
  ASSERT_EQ(guess.blocks.size(), 2U);
  EXPECT_EQ(guess.blocks[1].source.strain->column, "Strain 2");
  EXPECT_EQ(guess.blocks[1].source.stress->column, "Stress 2");
  // By their numbers, where the names are the same.
  std::string same = "Strain,Stress,Strain,Stress\n%,MPa,%,MPa\n";
  for (int i = 0; i < 10; ++i) same += row(i);
  const FileGuess numbered = guess_file(io::CsvTable::parse(same, "two.csv"));
  ASSERT_EQ(numbered.blocks.size(), 2U);
  EXPECT_EQ(numbered.blocks[1].source.strain->column, "3");
  EXPECT_EQ(numbered.blocks[0].source.stress->column, "2");
}

TEST(GuessFile, OtherColumnsThatMayBeMeantAreTold) {
  std::string text = "Strain 1 [%],Strain 2 [%],Stress [MPa]\n";
  for (int i = 0; i < 10; ++i) {
    text += "0." + std::to_string(i) + ",0.1" + std::to_string(i) + ",20\n";
  }
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

/// A table of a rising stress, and columns of `cells`, each a factor of it; the last is the stress.
FileGuess guess_of(const std::string& header, const std::vector<double>& factors,
                   const TargetSource& given = {}) {
  std::string text = header + "\n";
  for (int i = 0; i < 20; ++i) {
    for (std::size_t k = 0; k < factors.size(); ++k) {
      text += (k > 0 ? "," : "") + std::to_string(factors[k] * i);
    }
    text += "\n";
  }
  return guess_file(io::CsvTable::parse(text, "g.csv"), given);
}

TEST(GuessFile, WhatWasMeasuredGoesBeforeWhatWasWantedOrWorkedOut) {
  const auto taken = [](const std::string& header, const std::vector<double>& factors) {
    const TargetSource source = guess_of(header, factors).blocks.front().source;
    const auto& deformation = source.strain ? source.strain : source.elongation;
    const auto& load = source.stress ? source.stress : source.force;
    return deformation->column + ", " + load->column;
  };
  EXPECT_EQ(taken("Set strain (%),Strain (%),Stress (MPa)", {0.1, 0.1, 20}), "Strain, Stress");
  EXPECT_EQ(taken("Command displacement (mm),Displacement (mm),Load (kN)", {0.1, 0.1, 2}),
            "Displacement, Load");
  EXPECT_EQ(taken("eps_x (%),eps_y (%),Stress (MPa)", {-0.03, 0.1, 20}), "eps_y, Stress");
  EXPECT_EQ(taken("Strain Transv. (%),Strain Axial (%),Stress (MPa)", {-0.03, 0.1, 20}),
            "Strain Axial, Stress");
  EXPECT_EQ(taken("Plastic strain (%),Total strain (%),Stress (MPa)", {0.05, 0.1, 20}),
            "Total strain, Stress");
  EXPECT_EQ(taken("Strain error (%),Strain (%),Stress std (MPa),Stress (MPa)", {0.01, 0.1, 1, 20}),
            "Strain, Stress");
  EXPECT_EQ(taken("Extension (mm),Extensometer (mm),Load (N)", {0.1, 0.0, 20}), "Extension, Load");
}

TEST(GuessFile, AllOthersOfTheKindAreTold) {
  const FileGuess guess =
      guess_of("Dehnung vorn (%),Dehnung hinten (%),Spannung (MPa)", {0.1, 0.11, 20});
  ASSERT_EQ(guess.notes.size(), 1U);
  EXPECT_EQ(guess.notes[0],
            "the strain is column 1, \"Dehnung vorn\"; it may be \"Dehnung hinten\" (no. 2) as "
            "well");
}

TEST(GuessFile, OppositeSignsAreTold) {
  const FileGuess guess = guess_of("Strain (%),Stress (MPa)", {-0.03, 20});
  ASSERT_EQ(guess.notes.size(), 1U);
  EXPECT_NE(guess.notes[0].find("have opposite signs: is the strain a transverse one?"),
            std::string::npos);
}

TEST(GuessFile, SpecimensWithLettersStandSideBySideToo) {
  const FileGuess guess =
      guess_of("Strain A (%),Stress A (MPa),Strain B (%),Stress B (MPa)", {0.1, 20, 0.1, 21});
  ASSERT_EQ(guess.blocks.size(), 2U);
  EXPECT_EQ(guess.blocks[1].source.strain->column, "Strain B");
  EXPECT_EQ(guess.blocks[1].source.stress->column, "Stress B");
}

TEST(GuessFile, TrueMeasuresGoTogether) {
  const auto source = [](const std::string& header, const std::vector<double>& factors) {
    return guess_of(header, factors).blocks.front().source;
  };
  const TargetSource german =
      source("Wahre Dehnung [%],Spannung [MPa],Wahre Spannung [MPa]", {0.1, 20, 21});
  EXPECT_EQ(german.stress->column, "Wahre Spannung");
  EXPECT_EQ(german.measure, Measure::True);
  EXPECT_EQ(source("Analog strain (%),Stress (MPa)", {0.1, 20}).measure, std::nullopt);
  // The import warns of one alone.
  EXPECT_EQ(source("True strain (%),Engineering stress (MPa)", {0.1, 20}).measure, std::nullopt);
}

TEST(GuessFile, TrueMeasuresAreTrueWhoeverNamesThem) {
  TargetSource given;
  given.strain = ColumnSource{"True strain", std::nullopt, {}};
  given.stress = ColumnSource{"True stress", std::nullopt, {}};
  const auto measure = [&] {
    return guess_of("True strain (%),True stress (MPa)", {0.1, 20}, given)
        .blocks.front()
        .source.measure;
  };
  EXPECT_EQ(measure(), Measure::True);
  given.measure = Measure::Engineering;
  EXPECT_EQ(measure(), Measure::Engineering);
  // A logger's names, and a test that has no true measure.
  EXPECT_EQ(guess_of("Log displacement (mm),Log force (kN)", {0.1, 2}).blocks[0].source.measure,
            std::nullopt);
  given.measure.reset();
  given.test = calibrate::Test::Bending;
  EXPECT_EQ(measure(), std::nullopt);
}

/// What a sensor shows when it is taken off turns no test.
TEST(GuessFile, AFewNegativeRowsTurnNothing) {
  std::string text = "Strain (%),Stress (MPa)\n";
  for (int i = 0; i < 20; ++i)
    text += std::to_string(0.1 * i) + "," + std::to_string(20 * i) + "\n";
  text += "-35.0,0.0\n-35.0,0.0\n";
  const FileGuess guess = guess_file(io::CsvTable::parse(text, "r.csv"));
  EXPECT_EQ(guess.blocks.front().source.strain->factor, 1.0);
}

}  // namespace
}  // namespace plastica::calibrate
