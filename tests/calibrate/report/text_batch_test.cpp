#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/report/text.hpp"
#include "tests/calibrate/report/records.hpp"
#include "tests/support/has.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::has;

using testing::failed_record;
using testing::fitted_record;
using testing::parameter_of;
using testing::rejected_record;

std::vector<std::string> batch_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

::testing::AssertionResult batch_has_line(const std::string& text, const std::string& wanted) {
  const std::vector<std::string> lines = batch_lines(text);
  if (std::find(lines.begin(), lines.end(), wanted) != lines.end()) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << "no line '" << wanted << "' in\n" << text;
}

std::vector<FitRecord> some_records() {
  return {fitted_record("bar-01", 280e6), fitted_record("bar-02", 290e6, "150"),
          rejected_record("bar-03", "the file is empty"), failed_record("bar-04", "no number")};
}

TEST(BatchReport, CallsTheSlopeOfATorsionTestG) {
  std::vector<FitRecord> records{fitted_record("bar-01", 280e6), fitted_record("bar-02", 290e6)};
  const auto begins = [&](std::string_view words) {
    const std::vector<std::string> lines = batch_lines(batch_report(records));
    return std::ranges::any_of(lines, [&](const auto& line) { return line.starts_with(words); });
  };
  EXPECT_TRUE(begins("  E ") && !begins("  G "));
  records[1].target.test = calibrate::Test::Torsion;  // a group of its own
  EXPECT_TRUE(begins("  E ") && begins("  G "));
  EXPECT_TRUE(has(batch_report(records), "E, G"));
  records[0].target.test = calibrate::Test::Torsion;
  EXPECT_TRUE(begins("  G ") && !begins("  E "));
}

TEST(BatchReport, HasARowPerSpecimen) {
  const std::string text = batch_report(some_records());
  EXPECT_TRUE(
      batch_has_line(text,
                     "  specimen      E  Rp0.2     Rm    σ_y ± error  ε_break ± error  total   "
                     "misfit  flags"));
  EXPECT_TRUE(
      batch_has_line(text,
                     "  bar-01    70.00  280.0  281.4  280.00 ± 0.41   10.025 ± 0.025  10.42     "
                     "0.39  r"));
  EXPECT_TRUE(batch_has_line(
      text,
      "  bar-03        -      -      -       -               -              -        -"
      "  rejected"));
  EXPECT_TRUE(
      batch_has_line(text,
                     "  σ_y: engineering stress; ε_break: permanent strain at break; total: strain "
                     "at the fitted break"));
  EXPECT_TRUE(batch_has_line(text, "  r curve repaired"));
}

TEST(BatchReport, FlagsWhatToLookAt) {
  std::vector<FitRecord> records = {fitted_record("plain"), fitted_record("odd")};
  records[0].target.repairs.clear();
  parameter_of(records[1], "youngs_modulus").at_lower = true;
  parameter_of(records[1], "break_strain").identified = false;
  records[1].result.misfit_word = "poor";
  records[1].result.warnings = {"look here"};
  const std::vector<std::string> lines = batch_lines(batch_report(records));
  EXPECT_TRUE(lines[3].starts_with("  plain ") && lines[3].ends_with("0.39")) << lines[3];
  EXPECT_TRUE(lines[4].starts_with("  odd ") && lines[4].ends_with("0.39  bnprw")) << lines[4];
  EXPECT_FALSE(has(lines[4], "10.025")) << "a value that the curve does not determine";
}

TEST(BatchReport, NamesTheMeasureOfTheYieldStress) {
  std::vector<FitRecord> records = some_records();
  records[1].target.measure = Measure::True;
  EXPECT_TRUE(has(batch_report(records), "σ_y: engineering or true stress"));
  records[0].target.measure = Measure::True;
  EXPECT_TRUE(has(batch_report(records), "σ_y: true stress"));
}

TEST(BatchReport, ShowsOtherParametersWhereYieldAndBreakAreNotFitted) {
  FitRecord record = fitted_record("bar-01");
  parameter_of(record, "yield_stress").role = ParameterRole::Fixed;
  parameter_of(record, "break_strain").role = ParameterRole::Fixed;
  EXPECT_TRUE(has(batch_report(std::vector{record}), "youngs_modulus ± error"));
  EXPECT_FALSE(has(batch_report(std::vector{record}), "σ_y"));
}

TEST(BatchReport, AveragesOverEachGroup) {
  std::vector<FitRecord> records = some_records();
  records.push_back(fitted_record("bar-05", 284e6, "150"));
  const std::string text = batch_report(records);
  EXPECT_TRUE(batch_has_line(text, "Group temperature 20: 3 specimens"));
  EXPECT_TRUE(batch_has_line(text, "Group temperature 150: 2 specimens"));
  // 290 and 284 MPa: mean 287, deviation 3 sqrt 2.
  EXPECT_TRUE(
      batch_has_line(text, "  yield_stress      2    287.00       4.24      249 … 325     MPa"));
  EXPECT_TRUE(
      batch_has_line(text, "  yield_stress      1   280.00          -                    MPa"));
}

TEST(BatchReport, NamesEveryRejectedFailedAndRepairedSpecimenWithTheReason) {
  const std::string text = batch_report(some_records());
  EXPECT_TRUE(has(text, "\nRejected\n  bar-03  the file is empty\n"));
  EXPECT_TRUE(has(text, "\nFailed\n  bar-04  no number\n"));
  EXPECT_TRUE(has(text,
                  "\nRepaired\n"
                  "  nan-rows: rows without a number were left out\n"
                  "    3 samples in bar-01, 3 in bar-02\n"));
}

TEST(BatchReport, NamesEachKindOfRepairOnceWithItsCountTakenOffTheSentence) {
  std::vector<FitRecord> records = some_records();
  records[0].target.repairs = {{"foot-reversals", 1, "1 samples at the foot dropped"}};
  records[1].target.repairs = {{"foot-reversals", 2, "2 samples at the foot dropped"},
                               {"nan-rows", 2, "rows dropped"}};
  EXPECT_TRUE(has(batch_report(records),
                  "\nRepaired\n"
                  "  foot-reversals: samples at the foot dropped\n"
                  "    1 sample in bar-01, 2 in bar-02\n"
                  "  nan-rows: rows dropped\n"
                  "    2 samples in bar-02\n"));
}

TEST(BatchReport, CountsTheRepairedSpecimensThatItDoesNotName) {
  const std::vector<FitRecord> records(12, fitted_record());
  EXPECT_TRUE(has(batch_report(records, {.specimens_shown = 10}), "and 2 specimens more"));
  EXPECT_FALSE(has(batch_report(records, {.specimens_shown = 0}), " more"));
}

TEST(BatchReport, HasNoColumnForABreakThatNoSpecimenHas) {
  std::vector<FitRecord> records = some_records();
  for (FitRecord& record : records) record.result.break_strain_total.reset();
  EXPECT_FALSE(has(batch_report(records), "error  total"));
  EXPECT_FALSE(has(batch_report(records), "strain at the fitted break"));
}

TEST(BatchReport, EndsWithTheCounts) {
  EXPECT_EQ(batch_lines(batch_report(some_records())).back(), "fitted 2, rejected 1, failed 1");
  EXPECT_EQ(batch_report({}), "fitted 0, rejected 0, failed 0\n");
}

TEST(BatchReport, LeavesOutTheMiddleOfALongTable) {
  std::vector<FitRecord> records(1000, rejected_record("x", "why"));
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i] = fitted_record("bar-" + std::to_string(i));
    records[i].target.repairs.clear();
  }
  const std::string text = batch_report(records, {.specimens_shown = 10});
  EXPECT_TRUE(batch_has_line(text, "  … 990 specimens left out …"));
  EXPECT_TRUE(has(text, "  bar-4  ") && has(text, "  bar-995  "));
  EXPECT_FALSE(has(text, "bar-5 ") || has(text, "bar-994"));
  EXPECT_TRUE(has(batch_report(records, {.specimens_shown = 0}), "bar-500"));
}

TEST(BatchReport, LeavesOutGroupsBeyondTheLimit) {
  std::vector<FitRecord> records;
  for (int i = 0; i < 5; ++i) records.push_back(fitted_record("b", 280e6, std::to_string(i)));
  const std::string text = batch_report(records, {.groups_shown = 2});
  EXPECT_TRUE(batch_has_line(text, "… 3 groups left out …"));
  EXPECT_FALSE(has(text, "Group temperature 2:"));
}

TEST(BatchReport, IsNowhereWiderThanAHundredColumns) {
  std::vector<FitRecord> records = some_records();
  records[0].target.name = std::string(120, 'n');
  records[2].target.reason = "because " + std::string(130, 'r') + " of it";
  records[1].target.group = {{std::string(80, 'k'), std::string(80, 'v')}};
  for (const std::string& line : batch_lines(batch_report(records))) {
    EXPECT_LE(report::width_of(line), 100U) << line;
  }
}

}  // namespace
}  // namespace plastica::calibrate
