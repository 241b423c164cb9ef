#include <gtest/gtest.h>

#include "tests/sweeps/check/check_fixture.hpp"

namespace plastica::sweeps {
namespace {

/// A sweep in two axes that refine, against its finest.
class CheckOfTwoAxes : public CheckTest {
 protected:
  CheckOfTwoAxes() {
    write("sweep.toml", std::string("scene = '") + PLASTICA_SOURCE_DIR +
                            "/data/scenes/robot_arm.toml'\n" + segments_axis("[4, 8, 16]") +
                            "[[axis]]\nfield = 'solver.time_step'\nvalues = ['4 ms', '2 ms', "
                            "'1 ms']\n[error]\nprobe = 'gripper'\nagainst = 'finest'\n");
  }
};

TEST_F(CheckOfTwoAxes, JudgesErrorsOfBoth) {
  const ClaimVerdict step = verdict(
      "where = { beam.segments = 4, solver.time_step = '1 ms' }\n"
      "error = { at_most = '10 %' }\n");
  EXPECT_FALSE(step.holds) << "the finest step of four segments is no reference";
  EXPECT_GT(step.number.value_or(0.0), 0.4);
}

TEST_F(CheckOfTwoAxes, JudgesAnOrderAtTheFinestOfTheOtherAxis) {
  const ClaimVerdict all = verdict("order = { at_least = 1.5 }\n");
  EXPECT_TRUE(all.holds) << all.number.value_or(0.0) << all.reason;
  const ClaimVerdict coarse =
      verdict("where = { solver.time_step = '4 ms' }\norder = { at_least = 1.5 }\n");
  EXPECT_FALSE(coarse.holds);
  EXPECT_EQ(coarse.at, "at solver.time_step = 0.004 s");
  EXPECT_EQ(coarse.reason, "there is no order: its errors stop at that of solver.time_step");
}

TEST_F(CheckOfTwoAxes, JudgesTheReferenceByItsOwnError) {
  const std::string where = "where = { beam.segments = 16, solver.time_step = '1 ms' }\n";
  const ClaimVerdict found = verdict(where + "error = { at_most = '50 %' }\n");
  EXPECT_TRUE(found.holds) << found.reason;
  // Of 16 segments at 1 ms; against 256 segments at 15.6 us it is 4.2 %.
  EXPECT_GT(found.number.value_or(0.0), 0.042);
  EXPECT_TRUE(verdict(where + "value = { at_most = '0 m' }\n").holds);
}

TEST_F(CheckOfTwoAxes, HasNoNumberWhereNoCaseIsTheFinestInBoth) {
  write("sweep.toml", std::string("scene = '") + PLASTICA_SOURCE_DIR +
                          "/data/scenes/robot_arm.toml'\n"
                          "[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8]\nzip = 'a'\n"
                          "[[axis]]\nfield = 'solver.time_step'\nvalues = ['1 ms', '2 ms']\n"
                          "zip = 'a'\n[error]\nprobe = 'gripper'\nagainst = 'finest'\n");
  const ClaimVerdict found = verdict("error = { at_most = '99 %' }\n");
  EXPECT_FALSE(found.holds);
  EXPECT_EQ(found.reason, "error of beam.segments alone; that of solver.time_step is not in it");
}

}  // namespace
}  // namespace plastica::sweeps
