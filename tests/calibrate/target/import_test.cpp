#include "calibrate/target/import.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "plastica/base/check.hpp"
#include "tests/calibrate/target/curve_files.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::CurveFiles;
using plastica::testing::IdealPlastic;
using plastica::testing::message_of;

void expect_ideal(const Target& target) {
  EXPECT_EQ(target.status, TargetStatus::Ready) << target.reason;
  const Curve ideal = IdealPlastic{}.curve();
  ASSERT_EQ(target.raw.size(), ideal.size());
  EXPECT_NEAR(target.raw.strain[77], ideal.strain[77], 1e-12);
  EXPECT_NEAR(target.raw.stress[77], ideal.stress[77], 1e-3);
  EXPECT_NEAR(target.characteristics.proof_stress.value(), 400e6, 1.0);
}

TEST(ImportTargets, ReadsStrainAndStressWithTheUnitsOfTheBlock) {
  const CurveFiles files("block_units");
  TargetSource source = CurveFiles::source({files.write_curve("one.csv", 100.0, 1e-6)});
  source.strain->unit = "%";
  const auto targets = import_targets(source);
  ASSERT_EQ(targets.size(), 1U);
  expect_ideal(targets[0]);
  EXPECT_EQ(targets[0].name, "one");
  EXPECT_EQ(targets[0].file, source.files[0]);
}

TEST(ImportTargets, ReadsTheUnitsOfTheFileAndColumnsByNumber) {
  const CurveFiles files("file_units");
  TargetSource source =
      CurveFiles::source({files.write_curve("one.csv", 100.0, 1e-9, "a [%],b [GPa]")});
  source.strain->column = "1";
  source.stress = ColumnSource{"2", std::nullopt, {}};
  expect_ideal(import_targets(source).at(0));
}

TEST(ImportTargets, DividesForceByAreaAndElongationByGaugeLengthPerSpecimen) {
  const CurveFiles files("table");
  TargetSource source = CurveFiles::source({});
  // Gauge lengths 50 and 80 mm, areas 20 and 30 mm^2.
  source.files = {files.write_curve("s1.csv", 50.0, 20e-9),
                  files.write_curve("s2.csv", 80.0, 30e-9)};
  source.strain.reset();
  source.stress.reset();
  source.elongation = ColumnSource{"a", "mm", {}};
  source.force = ColumnSource{"b", "kN", {}};
  source.gauge_length = SpecimenValue{std::nullopt, "Le", "mm", {}};
  source.area = SpecimenValue{std::nullopt, "S0", std::nullopt, {}};
  source.table = TableSource{
      files.write("info.csv", "id,S0 (mm^2),Le,lot\ns2,30,80,B\ns1,20,50,A\n"), "id", {}, {}};
  source.group = {"lot"};
  const auto targets = import_targets(source);
  ASSERT_EQ(targets.size(), 2U);
  expect_ideal(targets[0]);
  expect_ideal(targets[1]);
  using Group = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(targets[0].group, (Group{{"lot", "A"}}));
  EXPECT_EQ(targets[1].group, (Group{{"lot", "B"}}));
  EXPECT_EQ(targets[0].properties[0].first, "gauge_length");
  EXPECT_NEAR(targets[0].properties[0].second, 0.05, 1e-15);
  EXPECT_NEAR(targets[1].properties[1].second, 30e-6, 1e-18);
}

TEST(ImportTargets, TakesFixedValuesForAllSpecimens) {
  const CurveFiles files("fixed");
  TargetSource source = CurveFiles::source({files.write_curve("one.csv", 1.0, 20e-6)});
  source.stress.reset();
  source.force = ColumnSource{"b", "N", {}};
  source.area = SpecimenValue{20e-6, "", std::nullopt, {}};
  expect_ideal(import_targets(source).at(0));
}

TEST(ImportTargets, MakesATargetOfEachColumnThatMatches) {
  const CurveFiles files("pattern");
  TargetSource source = CurveFiles::source(
      {files.write("many.csv", "a,stress_1,stress_2,other\n0,0,0,0\n1,1,2,0\n2,2,4,0\n")});
  source.stress->column = "stress_*";
  const auto targets = import_targets(source);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[0].name, "many:stress_1");
  EXPECT_EQ(targets[1].name, "many:stress_2");
  EXPECT_EQ(targets[1].raw.stress[2], 4e6);
}

TEST(ImportTargets, TellsAlikeNamesApartByTheirFolder) {
  const CurveFiles files("alike");
  const auto targets = import_targets(CurveFiles::source(
      {files.write_curve("x/one.csv", 1.0, 1e-6), files.write_curve("y/one.csv", 1.0, 1e-6)}));
  EXPECT_EQ(targets.at(0).name, "x/one");
  EXPECT_EQ(targets.at(1).name, "y/one");
}

TEST(ImportTargets, RejectsABadSpecimenAlone) {
  const CurveFiles files("bad");
  TargetSource source = CurveFiles::source(
      {files.write("cell.csv", "a,b\n0,0\n1,oops\n2,2\n"), files.write("empty.csv", ""),
       files.write_curve("good.csv", 1.0, 1e-6), files.write_curve("lost.csv", 1.0, 1e-6)});
  source.table =
      TableSource{files.write("info.csv", "id,lot\ncell,A\nempty,A\ngood,B\n"), "id", {}, {}};
  source.group = {"lot"};
  const auto targets = import_targets(source);
  ASSERT_EQ(targets.size(), 4U);
  EXPECT_EQ(targets[0].status, TargetStatus::Rejected);
  EXPECT_NE(targets[0].reason.find("oops"), std::string::npos) << targets[0].reason;
  EXPECT_EQ(targets[1].status, TargetStatus::Rejected);
  EXPECT_EQ(targets[2].status, TargetStatus::Ready);
  EXPECT_EQ(targets[3].status, TargetStatus::Rejected);
  EXPECT_NE(targets[3].reason.find("has no row in the table"), std::string::npos)
      << targets[3].reason;
}

TEST(ImportTargets, RefusesATableThatHasNoneOfTheSpecimens) {
  const CurveFiles files("rowless");
  TargetSource source = CurveFiles::source(
      {files.write_curve("one.csv", 1.0, 1e-6), files.write_curve("two.csv", 1.0, 1e-6)});
  const std::string info = files.write("info.csv", "id,lot\nA,one\nB,three\n");
  source.table = TableSource{info, "id", {}, {}};
  EXPECT_EQ(message_of([&] { (void)import_targets(source); }),
            info + ": id = one: has no row in the table");
  source.table->key = "lot";
  const auto targets = import_targets(source);
  EXPECT_EQ(targets.at(0).status, TargetStatus::Ready);
  EXPECT_EQ(targets.at(1).status, TargetStatus::Rejected);
  // Of specimens one under the other.
  source =
      CurveFiles::source({files.write("many.csv", "a,b [MPa],n\n0,0,1\n1,1,1\n0,0,2\n1,1,2\n")});
  source.split = {"n"};
  source.table = TableSource{info, "id", {}, {}};
  EXPECT_EQ(message_of([&] { (void)import_targets(source); }),
            info + ": id = 1: has no row in the table");
}

TEST(ImportTargets, RejectsOneOfTheSpecimensOfAFileAlone) {
  const CurveFiles files("split");
  // Rows of the first stand in two runs.
  TargetSource source =
      CurveFiles::source({files.write("many.csv",
                                      "n,a,b [MPa]\n1,0,0\n1,0.001,200\n2,0,0\n2,oops,200\n3,0,0\n"
                                      "3,0.001,100\n1,0.002,200\n")});
  source.split = {"n"};
  source.stress->unit.reset();
  for (const int threads : {1, 2}) {
    const auto targets = import_targets(source, {}, threads);
    ASSERT_EQ(targets.size(), 3U);
    EXPECT_EQ(targets[0].name, "many:1");
    EXPECT_EQ(targets[0].raw.strain, (std::vector{0.0, 0.001, 0.002}));
    EXPECT_EQ(targets[0].raw.stress, (std::vector{0.0, 200e6, 200e6}));
    EXPECT_EQ(targets[1].status, TargetStatus::Rejected);
    EXPECT_NE(targets[1].reason.find("oops"), std::string::npos) << targets[1].reason;
    EXPECT_EQ(targets[2].raw.stress, (std::vector{0.0, 100e6}));
  }
}

TEST(ImportTargets, RejectsAFileWithoutTheColumnOrUnitAlone) {
  const CurveFiles files("lacking");
  TargetSource source = CurveFiles::source({files.write_curve("other.csv", 1.0, 1e-6, "x,b [MPa]"),
                                            files.write_curve("no_unit.csv", 1.0, 1e-6),
                                            files.write_curve("no_b.csv", 1.0, 1e-6, "a,y [MPa]"),
                                            files.write_curve("good.csv", 1.0, 1e-6, "a,b [MPa]")});
  source.stress->unit.reset();
  const auto targets = import_targets(source);
  ASSERT_EQ(targets.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(targets[i].status, TargetStatus::Rejected) << targets[i].name;
    EXPECT_FALSE(targets[i].reason.empty());
  }
  EXPECT_NE(targets[1].reason.find("needs a unit"), std::string::npos) << targets[1].reason;
  expect_ideal(targets[3]);
  source.files.pop_back();
  EXPECT_THROW(import_targets(source), InputError);
}

TEST(ImportTargets, WarnsOfStrainsAbove100PercentWithoutAUnit) {
  const CurveFiles files("percent");
  TargetSource source = CurveFiles::source({files.write_curve("one.csv", 100.0, 1e-6)});
  const auto warned = [&] {
    const auto warnings = import_targets(source).at(0).warnings;
    return std::count(warnings.begin(), warnings.end(),
                      "strains above 100 %: if they are in percent, write unit = \"%\"");
  };
  EXPECT_EQ(warned(), 1);
  source.strain->unit = "1";
  EXPECT_EQ(warned(), 0);
  source.strain->unit.reset();
  source.files = {files.write_curve("small.csv", 1.0, 1e-6)};
  EXPECT_EQ(warned(), 0);
}

TEST(ImportTargets, ReportsATornLastRow) {
  const CurveFiles files("torn");
  const std::string path = files.write_curve("torn.csv", 1.0, 1e-6);
  std::ofstream(path, std::ios::app) << "0.07";
  const auto target = import_targets(CurveFiles::source({path})).at(0);
  const bool reported = std::any_of(target.repairs.begin(), target.repairs.end(),
                                    [](const Repair& r) { return r.kind == "torn-last-row"; });
  EXPECT_TRUE(reported);
  EXPECT_EQ(target.raw.size(), IdealPlastic{}.curve().size());
}

TEST(ImportTargets, GivesTheBlocksTestAndMeasurePrecedence) {
  const CurveFiles files("measure");
  TargetSource source = CurveFiles::source({files.write_curve("one.csv", 1.0, 1e-6)});
  source.measure = Measure::True;
  source.loading = Loading::Cyclic;
  const auto target = import_targets(source).at(0);
  EXPECT_EQ(target.measure, Measure::True);
  EXPECT_EQ(target.loading, Loading::Cyclic);
  source.measure.reset();
  source.test = calibrate::Test::Bending;
  EXPECT_EQ(import_targets(source).at(0).test, calibrate::Test::Bending);
}

}  // namespace
}  // namespace plastica::calibrate
