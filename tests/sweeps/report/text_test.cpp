#include "sweeps/report/text.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/has.hpp"
#include "tests/sweeps/run_record.hpp"

namespace plastica::sweeps {
namespace {

using plastica::testing::has;

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(SweepReport, HasATableWithItsOrderForEachGroup) {
  const std::string text = sweep_report(two_groups());
  EXPECT_TRUE(text.starts_with(
      "test: 6 cases, 6 completed\n  scene     cantilever\n"
      "  compared  tip, end against theory:elastica\n\nrules.end_rule = half_joint\n"))
      << text;
  EXPECT_TRUE(has(text, "\nrules.end_rule = equal\n"));
  EXPECT_TRUE(has(text, "  order 0.9")) << text;
  EXPECT_TRUE(has(text, "(safety factor 1.25)"));
}

TEST(SweepReport, SaysWhyACaseFailed) {
  SweepRecord record = two_groups();
  record.results[0] = CaseResult{};
  record.results[0].status = Status::NotConverged;
  record.results[0].last_time = 0.25;
  record.results[0].reason = "try more steps";
  record.comparison.error[0].reset();
  const std::string text = sweep_report(record);
  EXPECT_TRUE(has(text, "test: 6 cases, 5 completed, 1 not-converged")) << text;
  EXPECT_TRUE(has(text, "not-converged at 0.25 s: try more steps"));
}

TEST(SweepReport, SaysWhereEnergyIsNotBalanced) {
  SweepRecord record = two_groups();
  record.results[0].energy_balance_error = 0.02;
  EXPECT_TRUE(has(sweep_report(record), "energy balance off by 2 %"));
}

TEST(SweepReport, SaysWhichCasesAreTheSameRun) {
  const SweepRecord record = record_of(
      "[[axis]]\nfield = 'solver.time_step'\nvalues = ['50 ms', '20 ms', '1 ms']\n"
      "[set]\nsolver.analysis = 'dynamics'\nsolver.duration = '20 ms'\nsolver.steps = 10\n"
      "[error]\nprobe = 'tip'\n");
  EXPECT_EQ(record.ids[0], record.ids[1]);  // both take steps of 2 ms
  EXPECT_NE(record.ids[0], record.ids[2]);
  EXPECT_EQ(record.results[0].value, record.results[1].value);
  const std::string text = sweep_report(record);
  EXPECT_TRUE(has(text, "the same run as case 1 (steps are cut to the samples)")) << text;
  EXPECT_FALSE(has(text, "the same run as case 2")) << text;
}

// A multiple of four, and of a tube's two parts, flange and web, one of eight at least.
TEST(SweepReport, SaysWhichFibresAreTheSame) {
  const std::string fibres =
      "[set]\nrules.yield_model = 'fibre'\n[[axis]]\nfield = 'solver.fibres'\n"
      "values = [2, 4, 8, 9, 12]\n[error]\nprobe = 'tip'\nagainst = 'finest'\n";
  const SweepRecord bar = record_of(fibres);
  EXPECT_EQ(bar.ids[0], bar.ids[1]);
  EXPECT_NE(bar.ids[1], bar.ids[2]);
  EXPECT_EQ(bar.ids[3], bar.ids[4]);
  EXPECT_EQ(bar.results[3].value, bar.results[4].value);
  EXPECT_TRUE(has(sweep_report(bar), "the same run as case 1 (the section is laid out alike)"));
}

TEST(SweepReport, OfManyCasesThatNothingRefinesIsTheirSpread) {
  std::string values;
  for (int i = 0; i < 40; ++i) values += (i == 0 ? "'" : ", '") + std::to_string(200 + i) + " GPa'";
  const SweepRecord record = record_of("[[axis]]\nfield = 'material.youngs_modulus'\nvalues = [" +
                                       values + "]\n[error]\nprobe = 'tip'\n");
  EXPECT_EQ(lines_of(sweep_report(record, 40)), 4U + 2U + 40U);
  const std::string spread = sweep_report(record, 39);
  EXPECT_LT(lines_of(spread), 12U) << spread;
  EXPECT_TRUE(has(spread, "median")) << spread;
  EXPECT_TRUE(has(spread, "1.000")) << "the stiffer, the higher lies the tip: " << spread;
}

TEST(SweepReport, OfManyGroupsEndsInTheSpreadOfTheRest) {
  const std::string text = sweep_report(two_groups(), 4);
  EXPECT_TRUE(has(text, "2 more cases; export has them all. Of all cases:")) << text;
  EXPECT_TRUE(has(text, "order of a group")) << text;
}

TEST(CaseReport, SaysAllOfACase) {
  SweepRecord record = two_groups();
  record.results[1].reason = "made up";
  const std::string text = case_report(record, 1);
  for (const char* line : {"  beam.segments         4\n", "  rules.end_rule        equal\n",
                           "  status                compl", "  reason                made up\n",
                           "  level                 planar\n", "  segments              4\n"}) {
    EXPECT_TRUE(has(text, line)) << line << text;
  }
  EXPECT_TRUE(text.starts_with("case " + record.ids[1] + " of test\n")) << text;
}

}  // namespace
}  // namespace plastica::sweeps
