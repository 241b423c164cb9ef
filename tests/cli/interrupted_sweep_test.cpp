#include <gtest/gtest.h>

#include <csignal>
#include <random>
#include <regex>

#include "tests/cli/results.hpp"

namespace plastica::testing {
namespace {

constexpr int kCases = 2000;
constexpr int kKills = 20;

/// A sweep of 2 000 planar beams, which takes about a second on one core.
class InterruptedSweep : public ::testing::Test {
 protected:
  InterruptedSweep() {
    place_.write("sweep.toml", "scene = '" + std::string(PLASTICA_SOURCE_DIR) +
                                   "/data/scenes/cantilever.toml'\n"
                                   "[sample]\nmethod = 'sobol'\ncount = 2000\nseed = 7\n"
                                   "[[axis]]\nfield = 'scale.loads'\nsampled = [0.1, 2]\n"
                                   "[[axis]]\nfield = 'material.youngs_modulus'\n"
                                   "sampled = ['60 GPa', '220 GPa']\n"
                                   "[error]\nprobe = 'tip'\n");
  }

  /// Begins or goes on, and ends it by a signal once the journal has grown by so much.
  CommandResult interrupt(int signal, std::uintmax_t growth) const {
    return place_.interrupt({"sweep", "sweep.toml", "--resume", "--threads", "2", "-o", "out.h5"},
                            "out.h5.journal", signal, growth);
  }

  /// How many cases a run says that it took from an earlier one.
  static int resumed_cases(const std::string& err) {
    std::smatch found;
    const std::regex words("(\\d+) cases? resumed from an earlier run");
    return std::regex_search(err, found, words) ? std::stoi(found[1]) : 0;
  }

  Workplace place_;
};

TEST_F(InterruptedSweep, ThatWasKilledTwentyTimesGoesOnToTheSameFile) {
  std::mt19937 draw(5);  // the same moments every time, as far as the machine allows
  int before = 0;
  for (int k = 0; k < kKills; ++k) {
    const CommandResult killed = interrupt(SIGKILL, 1000 + draw() % 12000);
    if (killed.code != 128 + SIGKILL) break;  // it was done before it could be killed
    EXPECT_FALSE(place_.has("out.h5"));
    EXPECT_GE(resumed_cases(killed.err), before) << "a finished case was lost";
    before = resumed_cases(killed.err);
  }
  const CommandResult last = place_.run({"sweep", "sweep.toml", "--resume", "-o", "out.h5"});
  ASSERT_EQ(last.code, 0) << last.err;
  EXPECT_GT(resumed_cases(last.err), before);
  EXPECT_LE(resumed_cases(last.err), kCases);
  EXPECT_FALSE(place_.has("out.h5.journal"));

  ASSERT_EQ(place_.run({"sweep", "sweep.toml", "--quiet", "-o", "whole.h5"}).code, 0);
  expect_same_bits(place_, {"whole.h5", "out.h5"});
}

TEST_F(InterruptedSweep, ByCtrlCKeepsWhatIsFinished) {
  const CommandResult stopped = interrupt(SIGINT, 20000);
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("what is finished is kept: --resume goes on"), std::string::npos);
  const CommandResult refused = place_.run({"sweep", "sweep.toml", "-o", "out.h5"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("finished cases: use --resume to go on or --force to start afresh"),
            std::string::npos)
      << refused.err;
  const CommandResult resumed = place_.run({"sweep", "sweep.toml", "--resume", "-o", "out.h5"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_GT(resumed_cases(resumed.err), 0);
}

TEST_F(InterruptedSweep, RunsOnlyWhatHasChangedInItsOutput) {
  ASSERT_EQ(place_.run({"sweep", "sweep.toml", "--quiet", "-o", "out.h5"}).code, 0);
  const CommandResult again =
      place_.run({"sweep", "sweep.toml", "--resume", "--rerun-failed", "-o", "out.h5"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(resumed_cases(again.err), kCases);
  EXPECT_EQ(place_.run({"sweep", "sweep.toml", "-o", "out.h5"}).code, 2);
}

}  // namespace
}  // namespace plastica::testing
