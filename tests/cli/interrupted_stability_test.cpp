#include <gtest/gtest.h>

#include <csignal>
#include <random>
#include <sstream>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"
#include "tests/support/has.hpp"

namespace plastica::testing {
namespace {

constexpr int kScanKills = 8;
const std::vector<std::string> kScan{
    "stability", "cantilever.toml", "--vary", "beam.segments,scale.loads", "--max-work", "8"};

/// A scan of some ninety points, of which the slowest take tenths of a second.
class InterruptedStability : public ::testing::Test {
 protected:
  InterruptedStability() { place_.run({"init", "sweep"}); }

  static std::vector<std::string> scan(std::initializer_list<std::string> more) {
    std::vector<std::string> words = kScan;
    words.insert(words.end(), more);
    return words;
  }

  /// Begins or goes on, and ends it by a signal once the journal has grown by so much.
  CommandResult interrupt(int signal, std::uintmax_t growth) const {
    return place_.interrupt(
        scan({"--map", "out.gp", "--resume", "--threads", "2", "-o", "out.csv"}), "out.csv.journal",
        signal, growth);
  }

  /// The points of a file, without what each took.
  std::string points(const std::string& name) const {
    std::istringstream lines(place_.read(name));
    std::string all;
    for (std::string line; std::getline(lines, line);) {
      all += line.substr(0, line.rfind(',')) + '\n';
    }
    return all;
  }

  Workplace place_;
};

TEST_F(InterruptedStability, ThatWasKilledGoesOnToTheSamePoints) {
  std::mt19937 draw(5);
  int killed = 0;
  for (int k = 0; k < kScanKills && interrupt(SIGKILL, 200 + draw() % 1500).code == 128 + SIGKILL;
       ++k) {
    ++killed;
    EXPECT_FALSE(place_.has("out.csv"));
  }
  EXPECT_GT(killed, 1);
  const CommandResult last =
      place_.run(scan({"--map", "out.gp", "--resume", "-o", "out.csv", "--force"}));
  ASSERT_EQ(last.code, 0) << last.err;
  EXPECT_FALSE(place_.has("out.csv.journal"));

  const CommandResult whole = place_.run(scan({"--map", "whole.gp", "-o", "whole.csv"}));
  ASSERT_EQ(whole.code, 0) << whole.err;
  EXPECT_EQ(points("out.csv"), points("whole.csv"));
  EXPECT_EQ(place_.read("out.gp"), place_.read("whole.gp"));
  EXPECT_EQ(last.out, whole.out);
}

TEST_F(InterruptedStability, ByCtrlCKeepsWhatIsFinished) {
  const CommandResult stopped = interrupt(SIGINT, 1500);
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_EQ(stopped.err, "plastica: interrupted; what is finished is kept: --resume goes on\n");
  EXPECT_FALSE(place_.has("out.csv"));
  const CommandResult refused = place_.run(scan({"-o", "out.csv"}));
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(
      has(refused.err, " finished points: use --resume to go on or --force to start afresh"))
      << refused.err;
  const CommandResult other = place_.run(scan({"-o", "out.csv", "--resume", "--within", "2 %"}));
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(has(other.err, "has no point of this scene and deviation: name another output"))
      << other.err;
  place_.write("cantilever.toml",
               changed(place_.read("cantilever.toml"), "segments = 32", "segments = 33"));
  EXPECT_EQ(place_.run(scan({"-o", "out.csv", "--resume"})).code, 2);
  place_.write("cantilever.toml",
               changed(place_.read("cantilever.toml"), "segments = 33", "segments = 32"));
  // Points that nobody asks for stay for who does.
  const CommandResult another = place_.run({"stability", "cantilever.toml", "--vary", "beam.length",
                                            "--reach", "2", "-o", "out.csv", "--resume"});
  EXPECT_EQ(another.code, 0);
  EXPECT_TRUE(has(another.err, " of another scan, and is kept\n")) << another.err;
  ASSERT_TRUE(place_.has("out.csv.journal"));
  std::filesystem::remove(place_.path("out.csv"));
  const CommandResult resumed = place_.run(scan({"-o", "out.csv", "--resume"}));
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_TRUE(has(resumed.err, " points resumed from an earlier run\n")) << resumed.err;
}

TEST_F(InterruptedStability, NeedsAnOutputToGoOn) {
  const CommandResult result = place_.run(scan({"--resume"}));
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err,
            "plastica: --resume: goes on from what stands beside the output: give -o FILE\n");
}

}  // namespace
}  // namespace plastica::testing
