#include <gtest/gtest.h>

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <regex>
#include <thread>

#include "tests/cli/curves.hpp"
#include "tests/cli/results.hpp"

namespace plastica::testing {
namespace {

constexpr int kCurves = 140;

/// A batch that takes seconds on one core: fine curves and a search that stops late.
class InterruptedRun : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int i = 0; i < kCurves; ++i) {
      place_.write(fmt::format("curve-{}.csv", i), broken_curve(200.0 + i, i, 0.005));
    }
    place_.write("fit.toml", fit_file("'curve-*.csv'",
                                      "algorithm = 'crs'\nstop = { global_evaluations = 2000, "
                                      "parameter_tolerance = 0, cost_tolerance = 0 }"));
  }

  /// Begins the batch and ends it by a signal once its journal holds some fits, but not all.
  CommandResult interrupt(int signal) const {
    constexpr std::uintmax_t kSomeFits = 20'000;  // bytes; a fit takes some 1 000
    RunningCommand running =
        place_.start({"calibrate", "fit.toml", "--threads", "1", "-o", "out.h5"});
    while (running.runs() && journal_size() < kSomeFits) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    if (running.runs()) running.send(signal);
    return running.wait();
  }

  std::uintmax_t journal_size() const {
    std::error_code absent;
    const auto size = std::filesystem::file_size(place_.path("out.h5.journal"), absent);
    return absent ? 0 : size;
  }

  /// Resumes, expects that some fits came from the journal, and the bits of a run of its own.
  void expect_resumed() const {
    const CommandResult resumed =
        place_.run({"calibrate", "fit.toml", "--resume", "--threads", "2", "-o", "out.h5"});
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    std::smatch found;
    const std::regex words("(\\d+) fits resumed from the journal\n");
    ASSERT_TRUE(std::regex_search(resumed.err, found, words)) << resumed.err;
    EXPECT_GT(std::stoi(found[1]), 0);
    EXPECT_LT(std::stoi(found[1]), kCurves);
    EXPECT_FALSE(place_.has("out.h5.journal"));
    EXPECT_FALSE(place_.has("out.h5.part"));

    ASSERT_EQ(place_.run({"calibrate", "fit.toml", "--quiet", "-o", "whole.h5"}).code, 0);
    expect_same_bits(place_, {"whole.h5", "out.h5"});
  }

  Workplace place_;
};

TEST_F(InterruptedRun, ThatWasKilledGoesOnToTheSameBits) {
  const CommandResult killed = interrupt(SIGKILL);
  ASSERT_EQ(killed.code, 128 + SIGKILL) << "it ended before it could be killed";
  EXPECT_FALSE(place_.has("out.h5"));
  const std::string journal = place_.read("out.h5.journal");

  const CommandResult again = place_.run({"calibrate", "fit.toml", "-o", "out.h5"});
  EXPECT_EQ(again.code, 2);
  EXPECT_TRUE(std::regex_match(
      again.err, std::regex("plastica: out\\.h5\\.journal: is the journal of an interrupted run, "
                            "with \\d+ finished fits: use --resume to go on or --force to start "
                            "afresh\n")))
      << again.err;
  EXPECT_EQ(place_.read("out.h5.journal"), journal);

  expect_resumed();
}

TEST_F(InterruptedRun, ByCtrlCKeepsWhatIsDoneAndGoesOnToTheSameBits) {
  const CommandResult stopped = interrupt(SIGINT);
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_EQ(stopped.out, "");
  EXPECT_EQ(stopped.err, "plastica: interrupted; what is finished is kept: --resume goes on\n");
  EXPECT_FALSE(place_.has("out.h5"));
  EXPECT_TRUE(place_.has("out.h5.journal"));
  expect_resumed();
}

}  // namespace
}  // namespace plastica::testing
