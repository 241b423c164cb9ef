#include "calibrate/report/scene_fit_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

#include "calibrate/report/format.hpp"
#include "tests/calibrate/report/scene_records.hpp"
#include "tests/support/has.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::has;

using testing::failed_scene_record;
using testing::lone_scene_record;
using testing::scene_record;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

::testing::AssertionResult has_line(const std::string& text, const std::string& wanted) {
  const std::vector<std::string> lines = lines_of(text);
  if (std::find(lines.begin(), lines.end(), wanted) != lines.end()) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << "no line '" << wanted << "' in\n" << text;
}

std::vector<SceneFitRecord> specimens() {
  return {lone_scene_record("a", 200e9, 380e6), lone_scene_record("b", 210e9, 390e6),
          lone_scene_record("c", 205e9, 370e6)};
}

TEST(SceneFitText, ShowsEachParameterWithErrorIntervalAndVerdict) {
  const std::string text = scene_fit_report(scene_record());
  EXPECT_TRUE(text.starts_with("both: fitted\n"));
  EXPECT_TRUE(has_line(
      text, "  youngs_modulus  205.0 ± 1.2    GPa  202.6 … 207.4  identified, error 0.59 %"));
  EXPECT_TRUE(has_line(
      text, "  break_strain    2.100 ± 0.040  %    2.020 … 2.180  limited by sampling, ± 1.8 %"));
  EXPECT_TRUE(
      has_line(text, "  errors      noise estimated from residuals, 28.8 degrees of freedom"));
}

TEST(SceneFitText, SaysWhatWasMendedAsOfACoupon) {
  SceneFitRecord lone = lone_scene_record("a", 200e9, 380e6);
  EXPECT_FALSE(has(scene_fit_report(lone), "Repair"));
  lone.targets[0].repairs = {{"nan-rows", 3, "3 rows dropped"}};
  EXPECT_TRUE(
      has(scene_fit_report(lone), "\nRepairs\n  nan-rows          3 samples     rows dropped\n"));
  SceneFitRecord both = scene_record();
  both.targets[1].repairs = lone.targets[0].repairs;
  const std::string of_twisted = "\nRepaired\n  nan-rows: rows dropped\n    3 samples in twisted\n";
  EXPECT_TRUE(has(scene_fit_report(both), of_twisted)) << scene_fit_report(both);
  EXPECT_TRUE(has(scene_fits_report(std::vector{both, scene_record("other")}), of_twisted));
}

TEST(SceneFitText, SetsAllSourcesOfErrorsSideBySide) {
  const std::string text = scene_fit_report(scene_record());
  EXPECT_TRUE(has(text, "\nStandard errors\n"));
  EXPECT_TRUE(has_line(text, "                  noise  sampling  segments  misfit"));
  // 1.25 x 1 % of 205 GPa, and 3 x 4 % of 380 MPa, over the root of 3.
  EXPECT_TRUE(has_line(text, "  youngs_modulus    1.2         -       1.5       -  GPa"));
  EXPECT_TRUE(has_line(text, "  yield_stress      2.1         -        26       -  MPa"));
  EXPECT_TRUE(has_line(text, "  break_strain    0.010     0.039         -   0.020  %"));
}

TEST(SceneFitText, ShowsTheValuesOfOtherSegmentsAndWhereTheyLead) {
  SceneFitRecord record = scene_record();
  record.result.segments->note = "no fit with half the segments";
  const std::string text = scene_fit_report(record);
  EXPECT_TRUE(has(text, "\nSegments\n"));
  EXPECT_TRUE(
      has_line(text, "                     N/2  N = 32      2N  order        extrapolated"));
  EXPECT_TRUE(
      has_line(text, "  youngs_modulus  211.15  205.00  203.46  2.00        202.95 ± 0.64  GPa"));
  EXPECT_TRUE(
      has_line(text, "  yield_stress       395     380     384  oscillates     384 ± 46    MPa"));
  EXPECT_TRUE(
      has_line(text, "  break_strain         -       -       -  unknown          -         %"));
  EXPECT_TRUE(has_line(text, "  no fit with half the segments"));
  record.result.segments.reset();
  EXPECT_FALSE(has(scene_fit_report(record), "\nSegments\n"));
  EXPECT_FALSE(has(scene_fit_report(record), "sampling  segments"));
}

TEST(SceneFitText, NamesTheBoundThatAParameterIsAt) {
  SceneFitRecord record = scene_record();
  FittedParameter& yield = record.result.parameters[1];
  yield.at_upper = true;
  yield.upper = yield.value;
  yield.judgement = {Verdict::AtBound, yield.upper};
  yield.standard_error = yield.interval_low = yield.interval_high =
      std::numeric_limits<double>::quiet_NaN();
  const std::string text = scene_fit_report(record);
  EXPECT_TRUE(has(text, "  yield_stress    380.00 ")) << text;
  EXPECT_TRUE(has(text, " at bound, upper 380 MPa\n")) << text;
  yield.judgement = {Verdict::AtBound, yield.lower};
  EXPECT_TRUE(has(scene_fit_report(record), " at bound, lower 38 MPa\n"));
}

TEST(SceneFitText, ShowsEachTargetWithNoiseMisfitAndBreak) {
  const std::string text = scene_fit_report(scene_record());
  EXPECT_TRUE(has_line(text, "           broke at support 2 0.06050 ± 0.00050 m"));
  EXPECT_TRUE(has(text, "  bent     planar       30   5.00  N "));
  EXPECT_TRUE(has(text, "  twisted  twist        20   3.00  N m (stated) "));
  EXPECT_FALSE(has(text, "weight"));
  SceneFitRecord record = scene_record();
  record.weights[1] = 0.25;
  EXPECT_TRUE(has(scene_fit_report(record), "weight"));
}

TEST(SceneFitText, ShowsTheWaterfallOfTheStartsInOneLine) {
  EXPECT_TRUE(has_line(scene_fit_report(scene_record()),
                       "  search      best cost 49.10 from 2 of 4 starts, then 733.0; 1 without a "
                       "curve (step-reached)"));
  EXPECT_TRUE(has_line(scene_fit_report(lone_scene_record("a", 2e11, 3e8)),
                       "  search      cost 49.10 (step-reached)"));
}

TEST(SceneFitText, NamesStrongCorrelationsAlone) {
  SceneFitRecord record = scene_record();
  EXPECT_FALSE(has(scene_fit_report(record), "Correlations"));
  record.result.correlation[1] = record.result.correlation[3] = -0.971;
  const std::string text = scene_fit_report(record);
  EXPECT_TRUE(has_line(text, "Correlations above 0.95"));
  EXPECT_TRUE(has_line(text, "  youngs_modulus, yield_stress  -0.971"));
}

TEST(SceneFitText, IsAtMostAHundredColumnsWideAndPrintable) {
  SceneFitRecord record = scene_record(std::string(150, 'x') + "\x1b[31m\xff");
  record.targets[0].name = record.result.targets[0].name = std::string(120, 'y');
  record.result.warnings = {std::string(130, 'z')};
  for (const std::string& text :
       {scene_fit_report(record), scene_fits_report(std::vector{record, record})}) {
    for (const std::string& line : lines_of(text)) EXPECT_LE(report::width_of(line), 100U) << line;
    EXPECT_FALSE(has(text, "\x1b"));
    EXPECT_FALSE(has(text, "\xff"));
  }
}

TEST(SceneFitText, SaysWhyAFitFailed) {
  const std::string text = scene_fit_report(failed_scene_record("a", "no curve at the start"));
  EXPECT_TRUE(has_line(text, "a: failed"));
  EXPECT_TRUE(has_line(text, "  reason      no curve at the start"));
}

// Two equal breaks between the same samples: what each may be off, the mean may be, too.
TEST(SceneFitsText, SaysWhatBreaksShareInTheErrorOfTheirMean) {
  std::vector records{lone_scene_record("a", 2e11, 3e8), lone_scene_record("b", 2e11, 3e8)};
  EXPECT_FALSE(has(scene_fits_report(records), "their place between these"));
  for (SceneFitRecord& record : records) record.result.parameters[1].sampling_error = 3e6;
  std::string text = scene_fits_report(records);
  text.erase(0, text.find("\nPopulation\n"));
  EXPECT_TRUE(has(text, "300.0 ± 3.0")) << text;
  std::ranges::replace(text, '\n', ' ');
  EXPECT_TRUE(has(text, "of breaks between the same two samples")) << text;
}

TEST(SceneFitsText, ShowsFitsPopulationAndFailures) {
  std::vector<SceneFitRecord> records = specimens();
  records[1].result.parameters[1].judgement->verdict = Verdict::Weak;
  records.push_back(failed_scene_record("d", "no curve at the start"));
  const std::string text = scene_fits_report(records);
  EXPECT_TRUE(has_line(text, "  b               210.0 ± 1.2           390.0 ± 2.1    0.83  k"));
  EXPECT_TRUE(has(text, "; k a parameter weak"));
  // Mean 205, scatter 5, noise 1.2: sqrt(25 - 1.44) = 4.854.
  EXPECT_TRUE(
      has_line(text, "  youngs_modulus  3   205.0 ± 2.9       5.00     1.20          4.85  GPa"));
  EXPECT_TRUE(has_line(text, "  d: no curve at the start"));
  EXPECT_TRUE(text.ends_with("\nfitted 3, failed 1\n"));
}

TEST(SceneFitsText, LeavesOutTheMiddleOfManyFits) {
  std::vector<SceneFitRecord> records;
  for (int i = 0; i < 100; ++i) {
    records.push_back(lone_scene_record("s" + std::to_string(i), 2e11, 3e8));
  }
  const std::string text = scene_fits_report(records);
  EXPECT_TRUE(has_line(text, "  … 40 fits left out …"));
  EXPECT_TRUE(has(text, "  s29 "));
  EXPECT_FALSE(has(text, "  s30 "));
  EXPECT_FALSE(has(text, "  s69 "));
  EXPECT_TRUE(has(text, "  s70 "));
  EXPECT_TRUE(has(scene_fits_report(records, {.specimens_shown = 0}), "  s50 "));
}

TEST(SceneFitsText, OfASingleFitIsItsWholeReport) {
  const std::vector<SceneFitRecord> one{scene_record()};
  EXPECT_EQ(scene_fits_report(one), scene_fit_report(one.front()) + "\nfitted 1, failed 0\n");
  EXPECT_EQ(scene_fits_report({}), "fitted 0, failed 0\n");
}

}  // namespace
}  // namespace plastica::calibrate
