#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "sweeps/run/sweep_run.hpp"
#include "sweeps/trade/setting.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/sweeps/robot_arm.hpp"
#include "tests/sweeps/sweep_text.hpp"

/// Promises about real motions, against runs finer in both axes and against a closed form.
namespace plastica::sweeps {
namespace {

SweepRecord arm_record(const std::string& segments, const std::string& steps,
                       const std::string& against) {
  const Sweep sweep = parse_sweep("scene = '../scenes/robot_arm.toml'\n" + segments_axis(segments) +
                                      "[[axis]]\nfield = 'solver.time_step'\nvalues = " + steps +
                                      "\n[error]\nprobe = 'gripper'\nagainst = '" + against + "'\n",
                                  std::string(PLASTICA_SOURCE_DIR) + "/data/sweeps/test.toml");
  SweepRun run(sweep, {});
  auto results = run.run();
  return make_record(sweep, run.cases(), run.ids(), std::move(results));
}

class RobotArm : public ::testing::TestWithParam<const char*> {};

TEST_P(RobotArm, IsPromisedNoLessThanItsErrorAgainstARunFinerInBoth) {
  const double truth = gripper_end(64, 0.125e-3);
  ASSERT_LT(truth, 0.0);
  const SweepRecord record =
      arm_record("[4, 8, 16, 32]", "['4 ms', '2 ms', '1 ms', '0.5 ms']", GetParam());
  ASSERT_EQ(record.cases(), 16U);
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const double error = std::abs((record.results[i].value.value_or(0.0) - truth) / truth);
    const auto promised = promised_error(record, i);
    ASSERT_TRUE(promised.has_value()) << i;
    EXPECT_GE(*promised, error) << setting_text(record, i);
  }
  const auto points = promised_points(record, CostKind::Work);
  for (const double wanted : {0.2, 0.1, 0.05, 0.02}) {
    const Recommendation choice = recommend_for_error(points, wanted);
    ASSERT_TRUE(choice.chosen.has_value()) << wanted;
    const double value = record.results[*choice.chosen].value.value_or(0.0);
    EXPECT_LE(std::abs((value - truth) / truth), wanted);
  }
}

INSTANTIATE_TEST_SUITE_P(References, RobotArm, ::testing::Values("finest", "richardson"),
                         [](const auto& what) { return std::string(what.param); });

/// A cantilever that is let go straight under its weight: rms of the tip over the static sag.
SweepRecord falling_record(const std::string& segments, const std::string& steps,
                           const std::string& against) {
  const Sweep sweep = parse_sweep(
      "scene = '../scenes/falling_cantilever.toml'\n"
      "[set]\nsolver.rotary_inertia = 'off'\nsolver.duration = '240 ms'\nsolver.steps = 30\n"
      "material.youngs_modulus = '20 GPa'\n" +
          segments_axis(segments) + "[[axis]]\nfield = 'solver.time_step'\nvalues = " + steps +
          "\n[error]\nprobe = 'tip'\ntake = 'curve'\nscale = '2.207 mm'\nagainst = '" + against +
          "'\n",
      std::string(PLASTICA_SOURCE_DIR) + "/data/sweeps/test.toml");
  SweepRun run(sweep, {});
  auto results = run.run();
  return make_record(sweep, run.cases(), run.ids(), std::move(results));
}

TEST(FallingCantilever, IsPromisedNoLessThanItsErrorAgainstTheClosedForm) {
  const std::string segments = "[4, 8, 16, 32]";
  const std::string steps = "['8 ms', '4 ms', '2 ms', '1 ms', '0.5 ms']";
  const SweepRecord finest = falling_record(segments, steps, "finest");
  const SweepRecord theory = falling_record(segments, steps, "theory:released_cantilever");
  ASSERT_EQ(finest.cases(), 20U);
  for (std::size_t i = 0; i < finest.cases(); ++i) {
    const auto promised = promised_error(finest, i);
    ASSERT_TRUE(promised.has_value() && theory.comparison.error[i].has_value()) << i;
    // The closed form is of small displacements: (sag/length)^2 is 5e-6.
    EXPECT_GE(*promised + 1e-4, std::abs(*theory.comparison.error[i])) << setting_text(finest, i);
  }
}

/// A strip whose root is jerked aside: whether it breaks, and where, hangs on the segments.
const std::string kJerked = R"(
[material]
youngs_modulus = "70 GPa"
density = "2700 kg/m^3"
yield_stress = "250 MPa"
break_strain = "3 %"
[beam]
length = "1 m"
section = { shape = "rectangle", width = "40 mm", height = "4 mm" }
segments = 16
[solver]
analysis = "dynamics"
scheme = "energy_momentum"
duration = "60 ms"
steps = 60
time_step = "50 us"
frames = 1
[[support]]
at = "start"
kind = "clamp"
translation = ["0 m", "0.1 m", "0 m"]
history = { time = ["0 s", "10 ms", "60 ms"], factor = [0, 1, 1] }
[[probe]]
name = "tip"
kind = "displacement"
component = "y"
)";

TEST(JerkedStrip, HasNoErrorsWhereItBreaksWithSomeSegmentsOnly) {
  const io::ScratchFolder folder;
  std::ofstream(folder.file("strip.toml")) << kJerked;
  const Sweep sweep = parse_sweep("scene = 'strip.toml'\n" + segments_axis("[8, 16, 32]") +
                                      "[error]\nprobe = 'tip'\nagainst = 'finest'\n",
                                  folder.file("sweep.toml"));
  SweepRun run(sweep, {});
  auto results = run.run();
  const SweepRecord record = make_record(sweep, run.cases(), run.ids(), std::move(results));
  ASSERT_EQ(record.results[1].status, Status::Completed);
  ASSERT_EQ(record.results[2].status, Status::Broken);
  EXPECT_FALSE(record.has_errors());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(record.comparison.reason[i].starts_with("not converged: breaks at joint "))
        << record.comparison.reason[i];
    EXPECT_FALSE(promised_error(record, i).has_value());
  }
}

TEST(ArmOfOneStep, HasTheErrorOfTheStepNotInThatOfTheSegmentsWhereOneStepIsThere) {
  const SweepRecord record = arm_record("[4, 8]", "['4 ms']", "finest");
  ASSERT_FALSE(record.comparison.notes.empty());
  EXPECT_EQ(record.comparison.notes.back(),
            "the error of solver.time_step is not in it: it is not refined (0.004 s)");
}

TEST(ArmOfOneStep, OfStepsThatAreCutToTheSamplesHasOneRun) {
  const SweepRecord record = arm_record("[4, 8]", "['16 ms', '8 ms']", "finest");
  EXPECT_EQ(record.ids[0], record.ids[1]);  // samples are every 4 ms
  EXPECT_EQ(record.comparison.lacks[0], "solver.time_step");
  EXPECT_FALSE(promised_error(record, 0).has_value());
}

}  // namespace
}  // namespace plastica::sweeps
