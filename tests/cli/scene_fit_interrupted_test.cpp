#include <gtest/gtest.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <regex>
#include <thread>

#include "tests/cli/command.hpp"
#include "tests/cli/results.hpp"

/// A lone fit through a scene that is stopped on its way.
namespace plastica::testing {
namespace {

constexpr const char* kInterruptedScene = R"([beam]
length = "400 mm"
segments = 20
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
[material]
name = "S355"
hardening = { law = "linear", tangent_modulus = "10 GPa" }
[rules]
yield_model = "fibre"
[[support]]
at = "start"
kind = "clamp"
[[support]]
at = "end"
kind = "roller"
hold = ["y"]
translation = ["0 mm", "-80 mm", "0 mm"]
[[probe]]
name = "force"
kind = "reaction"
at = "end"
component = "y"
)";

constexpr const char* kInterruptedFit = R"([fit.parameters]
youngs_modulus = { bounds = ["20 GPa", "2000 GPa"] }
yield_stress = { bounds = ["20 MPa", "20 GPa"] }
tangent_modulus = { bounds = ["0.1 GPa", "19 GPa"] }
[[target]]
files = "curve.csv"
scene = "bar.toml"
abscissa = { drive = "support[2]", column = "Displacement" }
ordinate = { probe = "force", column = "Force", factor = -1 }
)";

class InterruptedSceneFit : public ::testing::Test {
 protected:
  void SetUp() override {
    place_.write("bar.toml", kInterruptedScene);
    place_.write("fit.toml", kInterruptedFit);
    std::string curve = "Displacement (mm),Force (N)\n";
    for (int i = 1; i <= 60; ++i) {
      const double displacement = i;
      curve += fmt::format("{},{}\n", displacement,
                           2300.0 * std::tanh(displacement / 18.0) + 3.0 * displacement);
    }
    place_.write("curve.csv", curve);
  }

  std::uintmax_t journal_size() const {
    std::error_code absent;
    const auto size = std::filesystem::file_size(place_.path("out.h5.journal"), absent);
    return absent ? 0 : size;
  }

  /// Ends the fit by a signal once its journal has grown beyond a size [bytes].
  CommandResult interrupt(int signal, std::uintmax_t beyond, bool resume) const {
    std::vector<std::string> arguments{"calibrate", "fit.toml", "--threads", "1", "-o", "out.h5"};
    if (resume) arguments.emplace_back("--resume");
    RunningCommand running = place_.start(arguments);
    while (running.runs() && journal_size() <= beyond) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    if (running.runs()) running.send(signal);
    return running.wait();
  }

  Workplace place_;
};

TEST_F(InterruptedSceneFit, GoesOnFromItsFinishedSearchesToTheSameBits) {
  constexpr std::uintmax_t kBegun = 100;  // header and the name of the instruction set
  const CommandResult killed = interrupt(SIGKILL, kBegun, false);
  ASSERT_EQ(killed.code, 128 + SIGKILL) << "it ended before it could be killed";
  const CommandResult again = place_.run({"calibrate", "fit.toml", "-o", "out.h5"});
  EXPECT_EQ(again.code, 2);
  EXPECT_TRUE(std::regex_match(
      again.err, std::regex("plastica: out\\.h5\\.journal: is the journal of an interrupted run, "
                            "with \\d+ finished fits and stages of fits: use --resume to go on or "
                            "--force to start afresh\n")))
      << again.err;

  const CommandResult stopped = interrupt(SIGTERM, journal_size() + 200, true);
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_TRUE(
      stopped.err.ends_with("plastica: interrupted; what is finished is kept: --resume goes on\n"))
      << stopped.err;
  EXPECT_FALSE(place_.has("out.h5"));

  const CommandResult resumed =
      place_.run({"calibrate", "fit.toml", "--resume", "--threads", "2", "-o", "out.h5"});
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  std::smatch found;
  ASSERT_TRUE(std::regex_search(
      resumed.err, found, std::regex("(\\d+) finished stages of fits resumed from the journal\n")))
      << resumed.err;
  EXPECT_GT(std::stoi(found[1]), 1);
  EXPECT_FALSE(place_.has("out.h5.journal"));

  ASSERT_EQ(place_.run({"calibrate", "fit.toml", "--quiet", "-o", "whole.h5"}).code, 0);
  expect_same_bits(place_, {"whole.h5", "out.h5"});
}

}  // namespace
}  // namespace plastica::testing
