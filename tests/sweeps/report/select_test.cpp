#include "sweeps/report/select.hpp"

#include <gtest/gtest.h>

#include "tests/support/message.hpp"
#include "tests/sweeps/run_record.hpp"

namespace plastica::sweeps {
namespace {

using Cases = std::vector<std::size_t>;

class SelectCases : public ::testing::Test {
 protected:
  std::string refusal(const std::string& text) const {
    return plastica::testing::message_of([&] { select_cases(record_, text); });
  }
  SweepRecord record_ = two_groups();
};

TEST_F(SelectCases, TakesAnIdOrItsBeginning) {
  EXPECT_EQ(select_cases(record_, record_.ids[2]), Cases{2});
  EXPECT_EQ(select_cases(record_, record_.ids[2].substr(0, 12)), Cases{2});
}

TEST_F(SelectCases, TakesValuesOfAxes) {
  EXPECT_EQ(select_cases(record_, "rules.end_rule = equal"), (Cases{1, 3, 5}));
  EXPECT_EQ(select_cases(record_, "end_rule=equal,segments=8"), Cases{3});
}

TEST_F(SelectCases, TakesQuantitiesInAnyUnit) {
  const SweepRecord record = record_of(
      "[[axis]]\nfield = 'rules.hinge_length'\nvalues = ['unset', '20 mm', '0.3 m']\n"
      "[error]\nprobe = 'tip'\n");
  EXPECT_EQ(select_cases(record, "hinge_length = 2 cm"), Cases{1});
  EXPECT_EQ(select_cases(record, "hinge_length = 0.3 m"), Cases{2});
  EXPECT_EQ(select_cases(record, "hinge_length = unset"), Cases{0});
}

TEST_F(SelectCases, RefusesWhatPicksNone) {
  EXPECT_EQ(refusal("xyz"),
            "--case = xyz: must be the id of a case of this sweep, as export has it, or AXIS = "
            "VALUE, …");
  EXPECT_EQ(refusal("rule = equal"),
            "--case = rule = equal: rule is no axis of this sweep; it has beam.segments, "
            "rules.end_rule");
  EXPECT_EQ(refusal("segments = 5"), "--case = segments = 5: beam.segments has no value 5");
  EXPECT_EQ(refusal("segments = 4, equal"),
            "--case = segments = 4, equal: must be AXIS = VALUE, AXIS = VALUE, …");
  EXPECT_EQ(refusal("segments = 4, segments = 8"),
            "--case = segments = 4, segments = 8: no case has these values together");
}

TEST_F(SelectCases, RefusesABeginningOfSeveralIds) {
  record_.ids[0] = "abcd000000000000";
  record_.ids[1] = "abce000000000000";
  EXPECT_EQ(refusal("abc"),
            "--case = abc: begins the ids abcd000000000000 and abce000000000000; say more of it");
  record_.ids[1] = record_.ids[0];
  EXPECT_EQ(select_cases(record_, "abc"), Cases{0});
}

}  // namespace
}  // namespace plastica::sweeps
