#include "sweeps/report/csv.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/message.hpp"
#include "tests/sweeps/run_record.hpp"

namespace plastica::sweeps {
namespace {

std::string cases_of(const SweepRecord& record) {
  std::ostringstream out;
  write_cases_csv(out, record);
  return out.str();
}

std::string line_of(const std::string& text, std::size_t number) {
  std::istringstream in(text);
  std::string line;
  for (std::size_t i = 0; i <= number; ++i) std::getline(in, line);
  return line;
}

TEST(CasesCsv, HasARowForEachCaseWithUnits) {
  const SweepRecord record = two_groups();
  const std::string text = cases_of(record);
  EXPECT_EQ(line_of(text, 0),
            "case,beam.segments,rules.end_rule,status,reason,level,value [m],reference [m],"
            "error [1],error_reason,error_lacks,standard_error "
            "[m],segments,iterations,segment_iterations,"
            "cutbacks,energy_balance_error [1],last_time [s],last_value [m],seconds [s]");
  EXPECT_TRUE(line_of(text, 2).starts_with(record.ids[1] + ",4,equal,completed,,planar,-0."))
      << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
}

TEST(CasesCsv, GivesEveryDigitAndQuotesTexts) {
  SweepRecord record = two_groups();
  CaseResult& result = record.results[0];
  result = CaseResult{};
  result.status = Status::Rejected;
  result.reason = "a, \"b\"";
  result.value = 0.1 + 0.2;
  record.comparison.reference[0].reset();
  record.comparison.error[0].reset();
  EXPECT_EQ(
      line_of(cases_of(record), 1),
      record.ids[0] +
          ",4,half_joint,rejected,\"a, \"\"b\"\"\",auto,0.30000000000000004,,,,,,0,0,0,0,0,0,,0");
}

TEST(CurvesCsv, HasARowForEachSample) {
  const SweepRecord record = record_of("[set]\nsolver.steps = 2\n" + segments_axis("[2, 3]") +
                                       "[error]\nprobe = 'tip'\ntake = 'curve'\n");
  std::ostringstream out;
  write_sweep_curves_csv(out, record);
  EXPECT_EQ(line_of(out.str(), 0), "case,time [s],value [m]");
  EXPECT_EQ(line_of(out.str(), 1), record.ids[0] + ",0,0");
  EXPECT_TRUE(line_of(out.str(), 5).starts_with(record.ids[1] + ",0.5,-0."));
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
}

TEST(CurvesCsv, RefusesASweepWithoutCurves) {
  std::ostringstream out;
  EXPECT_EQ(plastica::testing::message_of([&] { write_sweep_curves_csv(out, two_groups()); }),
            "--what = curves: needs a sweep with error.take = \"curve\"");
}

}  // namespace
}  // namespace plastica::sweeps
