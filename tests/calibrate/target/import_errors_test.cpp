#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/target/import.hpp"
#include "plastica/base/check.hpp"
#include "tests/calibrate/target/curve_files.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::CurveFiles;

/// Runs an import that must fail and checks the line and field of its error.
void expect_error(const TargetSource& source, int line, const std::string& field,
                  const std::string& rule) {
  try {
    import_targets(source);
    FAIL() << "no error for " << field;
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, line) << error.what();
    EXPECT_EQ(error.field(), field) << error.what();
    EXPECT_NE(error.rule().find(rule), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(ImportErrors, NameTheLineAndFieldOfABlockThatContradictsItself) {
  const CurveFiles files("errors");
  const TargetSource good = CurveFiles::source({files.write_curve("one.csv", 1.0, 1e-6)});
  TargetSource bad = good;
  bad.files.clear();
  expect_error(bad, 3, "files", "at least one");
  bad = good;
  bad.strain.reset();
  expect_error(bad, 3, "strain", "either");
  bad = good;
  bad.force = bad.stress;
  expect_error(bad, 3, "stress", "either");
  bad = good;
  bad.elongation = bad.strain;
  bad.strain.reset();
  expect_error(bad, 3, "gauge_length", "required");
  bad = good;
  bad.force = bad.stress;
  bad.stress.reset();
  expect_error(bad, 3, "area", "required");
  bad.area = SpecimenValue{-1.0, "", std::nullopt, {"fit.toml", 9}};
  expect_error(bad, 9, "area", "positive");
  bad.area = SpecimenValue{std::nullopt, "S0", std::nullopt, {"fit.toml", 9}};
  expect_error(bad, 9, "area", "needs a table");
  bad.test = calibrate::Test::Torsion;
  expect_error(bad, 3, "test", "tension");
  bad = good;
  bad.group = {"lot"};
  expect_error(bad, 3, "group", "needs a table");
  bad = good;
  bad.strain->column = "a*";
  expect_error(bad, 5, "strain", "one column");
}

TEST(ImportErrors, NameTheLineAndFieldOfWhatIsNotThere) {
  const CurveFiles files("missing");
  const TargetSource good = CurveFiles::source({files.write_curve("one.csv", 1.0, 1e-6)});
  TargetSource bad = good;
  bad.files.push_back(files.path("nowhere.csv"));
  expect_error(bad, 3, "files", "is not a file");
  bad = good;
  bad.strain->column = "nowhere";
  expect_error(bad, 5, "strain", "");
  bad = good;
  bad.stress->column = "nowhere_*";
  expect_error(bad, 6, "stress", "matches no column");
  bad = good;
  bad.stress->unit = "mm";
  expect_error(bad, 6, "stress", "");
  bad = good;
  bad.table = TableSource{
      files.write("info.csv", "id,lot\none,A\ntwo,B\n"), "nowhere", {}, {"fit.toml", 8}};
  expect_error(bad, 8, "key", "");
  bad.table->key = "id";
  bad.group = {"nowhere"};
  expect_error(bad, 3, "group", "");
}

TEST(ImportErrors, ABadFileIsRejectedWithItsReasonAndEndsNoBatch) {
  const CurveFiles files("bad");
  std::filesystem::create_symlink("loop.csv", files.path("loop.csv"));
  std::filesystem::create_symlink("none.csv", files.path("dangling.csv"));
  const std::vector<std::pair<std::string, std::string>> bad{
      {files.write("quote.csv", "\""), ":1: has a quote that is not closed"},
      {files.write("quotes.csv", "\n\"a\n\"b"), ":2: has a quote that is not closed"},
      {files.write("empty.csv", ""), ": is empty"},
      {files.write("zero.csv", std::string(100, '\0')), ":1: is not text (it has a zero byte)"},
      {files.write("wide.csv", "\xFF\xFE"), ": is empty"},
      {files.path("loop.csv"), ": cannot be read: Too many levels of symbolic links"},
      {files.path("dangling.csv"), ": cannot be read: No such file or directory"}};
  std::vector<std::string> names{files.write_curve("a.csv", 1.0, 1e-6)};
  for (const auto& [file, reason] : bad) names.push_back(file);
  names.push_back(files.write_curve("z.csv", 1.0, 1e-6));
  const std::vector<Target> targets = import_targets(CurveFiles::source(names));
  ASSERT_EQ(targets.size(), bad.size() + 2);
  EXPECT_EQ(targets.front().status, TargetStatus::Ready);
  EXPECT_EQ(targets.back().status, TargetStatus::Ready);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    EXPECT_EQ(targets[i + 1].status, TargetStatus::Rejected);
    EXPECT_EQ(targets[i + 1].reason, bad[i].first + bad[i].second);
  }
}

TEST(ImportErrors, AStressWithoutAnyUnitIsOneOfTheBlock) {
  const CurveFiles files("no_unit");
  TargetSource source = CurveFiles::source({files.write_curve("one.csv", 1.0, 1e-6)});
  source.stress->unit.reset();
  expect_error(source, 6, "stress", "needs a unit");
}

TEST(ImportErrors, AUnitThatNoFileHasRightIsOneOfTheBlock) {
  const CurveFiles files("bad_unit");
  const std::string bad = files.write_curve("bad.csv", 1.0, 1e-6, "a,b [mm]");
  TargetSource source = CurveFiles::source({bad});
  source.stress->unit.reset();
  expect_error(source, 0, "unit of b", "is not a unit of stress");
  source.files.push_back(files.write_curve("good.csv", 1.0, 1e-6, "a,b [MPa]"));
  const std::vector<Target> targets = import_targets(source);
  EXPECT_EQ(targets.at(0).status, TargetStatus::Rejected);
  EXPECT_EQ(targets[0].reason,
            bad + ": unit of b = mm: is not a unit of stress (examples: Pa, MPa, ksi)");
  EXPECT_EQ(targets.at(1).status, TargetStatus::Ready);
}

TEST(ImportErrors, OfAColumnOfWordsLeaveNoHalfACurveBehind) {
  const CurveFiles files("words");
  const std::string file = files.write("one.csv", "a,b\n0,low\n1,low\n2,high\n");
  const std::vector<Target> targets = import_targets(CurveFiles::source({file}));
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_EQ(targets[0].status, TargetStatus::Rejected);
  EXPECT_NE(targets[0].reason.find("low"), std::string::npos) << targets[0].reason;
  EXPECT_TRUE(targets[0].raw.strain.empty());
  EXPECT_TRUE(targets[0].raw.stress.empty());
}

}  // namespace
}  // namespace plastica::calibrate
