#include <gtest/gtest.h>

#include <string>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"

/// `plastica inspect` of files as laboratories export them, and fits of the blocks that it prints.
namespace plastica::testing {
namespace {

/// Rows of E = 200 GPa that yields at 400 MPa, 100 mm^2 and 50 mm. @param begin  of each row
std::string rows(const std::string& begin, double strain_factor, double stress_factor) {
  std::string text;
  for (int i = 0; i <= 60; ++i) {
    const double strain = 0.0001 * i;
    const double stress = std::min(200e3 * strain, 400.0) + 0.3 * (i % 3);
    text += begin + std::to_string(strain * strain_factor) + "," +
            std::to_string(stress * stress_factor) + "\n";
  }
  return text;
}

std::string block_in(const std::string& report) { return report.substr(report.find("[[target]]")); }

TEST(Inspect, PrintsABlockThatRunsAsItIsWhereTheFileSaysAll) {
  const Workplace place;
  place.write("bar.csv", "Width,10,mm\nThickness,10,mm\nL0,50,mm\n\nStroke,Force\nmm,kN\n" +
                             rows("", 50.0, 0.1));
  const CommandResult seen = place.run({"inspect", "bar.csv"});
  EXPECT_EQ(seen.code, 0) << seen.err;
  EXPECT_NE(seen.out.find("crosshead travel (name, unit)"), std::string::npos) << seen.out;
  const std::string block = block_in(seen.out);
  EXPECT_NE(block.find("gauge_length = \"50 mm\"  # \"L0\" = 50 mm\n"), std::string::npos) << block;
  EXPECT_NE(block.find("area = \"100 mm^2\""), std::string::npos) << block;
  place.write("f.toml", block);
  const CommandResult fit = place.run({"calibrate", "f.toml"});
  EXPECT_EQ(fit.code, 0) << fit.err;
  EXPECT_NE(fit.out.find("is crosshead travel by its name"), std::string::npos) << fit.out;
  EXPECT_NE(fit.out.find("fitted 1"), std::string::npos);
}

TEST(Inspect, APlaceholderIsRefusedByItsLineUntilItIsFilled) {
  const Workplace place;
  place.write("bar.csv", "Strain (%),Load (kN)\n" + rows("", 100.0, 0.1));
  const std::string block = block_in(place.run({"inspect", "bar.csv"}).out);
  place.write("f.toml", block);
  const CommandResult refused = place.run({"calibrate", "f.toml"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(refused.err.find(": target[1].area = ? mm^2: ") != std::string::npos) << refused.err;
  place.write("f.toml", changed(block, "? mm^2", "100 mm^2"));
  EXPECT_EQ(place.run({"calibrate", "f.toml"}).code, 0);
}

TEST(Inspect, SplitsSpecimensThatStandOneUnderTheOther) {
  const Workplace place;
  place.write("all.csv", "Specimen,Strain (%),Stress (MPa)\n" + rows("a,", 100.0, 1.0) +
                             rows("b,", 100.0, 0.5) + rows("c,", 100.0, 1.0));
  const std::string block = block_in(place.run({"inspect", "all.csv"}).out);
  EXPECT_NE(block.find("split = [\"Specimen\"]"), std::string::npos) << block;
  place.write("f.toml", block);
  const CommandResult fit = place.run({"calibrate", "f.toml"});
  EXPECT_EQ(fit.code, 0) << fit.err;
  EXPECT_NE(fit.out.find("fitted 3"), std::string::npos) << fit.out;
  EXPECT_NE(fit.out.find("all:b"), std::string::npos);
  // The same without a fit file, and told.
  const CommandResult bare = place.run({"calibrate", "all.csv"});
  EXPECT_NE(bare.out.find("fitted 3"), std::string::npos) << bare.out;
  EXPECT_NE(bare.err.find("all.csv: split: the rows are 3 specimens"), std::string::npos)
      << bare.err;
}

TEST(Inspect, KeepsTheColumnsThatAreGiven) {
  const Workplace place;
  std::string text = "Strain 1 (%),Strain 2 (%),Stress (MPa)\n";
  for (int i = 0; i < 9; ++i) {
    const std::string n = std::to_string(i);
    text += "0.0" + n + ",0.0" + n + "1," + n + "5.5\n";
  }
  place.write("bar.csv", text);
  EXPECT_NE(place.run({"inspect", "bar.csv"}).out.find("it may be \"Strain 2\" (no. 2) as well"),
            std::string::npos);
  const std::string given = place.run({"inspect", "bar.csv", "--strain", "Strain 2:%"}).out;
  EXPECT_NE(given.find("strain = { column = \"Strain 2\", unit = \"%\" }"), std::string::npos);
  expect_refusal({"",
                  {{"bar.csv", "Strain (%),Stress (MPa)\n0,0\n1,2\n"}},
                  {"inspect", "bar.csv", "--strain", "Strain:kN"},
                  "--strain = Strain:kN: \"kN\" …"});
}

TEST(Inspect, BareFilesTakeTheirGeometryFromTheHeaderAndSaySo) {
  const Workplace place;
  place.write("bar.csv", "Diameter,10,mm\n\nStrain,Force\n%,kN\n" + rows("", 100.0, 0.1));
  const CommandResult fit = place.run({"calibrate", "bar.csv"});
  EXPECT_EQ(fit.code, 0) << fit.err;
  EXPECT_NE(fit.err.find("bar.csv: area: pi/4 d^2 of \"Diameter\" = 10 mm\n"), std::string::npos)
      << fit.err;
}

TEST(Inspect, SpecimensSideBySideAreNoBareFile) {
  expect_refusal(
      {"",
       {{"two.csv", "Strain 1 (%),Stress 1 (MPa),Strain 2 (%),Stress 2 (MPa)\n0,0,0,0\n1,2,1,2\n"}},
       {"calibrate", "two.csv"},
       "two.csv: holds 2 specimens side by side: put the blocks that `plastica inspect` "
       "prints into a fit file"});
}

/// The hint of the error works, in both commands.
TEST(Inspect, TakesTheDecimalMarkThatTheNumbersDoNotShow) {
  const Workplace place;
  std::string text = "Strain (um/m);Stress (MPa)\n0;0\n";
  for (int i = 1; i < 30; ++i) {
    const int stress = i < 15 ? 20125 * i : 290000 + 1001 * i;
    text += std::to_string(100 * i) + ";" + std::to_string(stress / 1000) + "." +
            std::to_string(1000 + stress % 1000).substr(1) + "\n";
  }
  place.write("bar.csv", text);
  const CommandResult refused = place.run({"inspect", "bar.csv"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("say which by decimal = \".\" or \",\" (--decimal)"),
            std::string::npos)
      << refused.err;
  const std::string block = block_in(place.run({"inspect", "bar.csv", "--decimal", "."}).out);
  EXPECT_NE(block.find("decimal = \".\"\n"), std::string::npos) << block;
  place.write("f.toml", block);
  EXPECT_EQ(place.run({"calibrate", "f.toml"}).code, 0);
  EXPECT_EQ(place.run({"calibrate", "bar.csv", "--decimal", ".", "-o", "b.h5"}).code, 0);
  EXPECT_EQ(place.run({"calibrate", "bar.csv", "--decimal", ",", "-o", "c.h5"}).code, 1);
  EXPECT_EQ(place.run({"inspect", "bar.csv", "--decimal", "x"}).code, 2);
}

}  // namespace
}  // namespace plastica::testing
