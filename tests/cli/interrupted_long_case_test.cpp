#include <gtest/gtest.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "tests/cli/curves.hpp"
#include "tests/cli/results.hpp"

/// Commands that one case keeps busy for minutes: the first Ctrl-C ends them all the same.
namespace plastica::testing {
namespace {

using std::chrono::milliseconds;

/// A cantilever that yields under a force at its end.
std::string beam(int segments, const std::string& solver) {
  return fmt::format(R"([beam]
length = "1 m"
segments = {}
section = {{ shape = "rectangle", width = "20 mm", height = "20 mm" }}
[material]
name = "S355"
hardening = {{ law = "linear", tangent_modulus = "10 GPa" }}
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = "end"
force = ["0 N", "-600 N", "0 N"]
history = "ramp"
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
component = "y"
[solver]
{}
)",
                     segments, solver);
}

/// Minutes at rest.
std::string long_path() { return beam(20000, "steps = 100000\nframes = 1"); }
std::string long_motion(const std::string& more = "") {
  return beam(5000,
              "analysis = 'dynamics'\ntime_step = '1 us'\nduration = '10 s'\nsteps = 10\n" + more);
}

std::string sweep_of(const std::string& scene) {
  return "scene = '" + scene +
         "'\n[[axis]]\nfield = 'scale.loads'\nvalues = [0.5, 1]\n"
         "[error]\nprobe = 'tip'\nagainst = 'theory:elastica'\n";
}

class InterruptedLongCase : public ::testing::Test {
 protected:
  /// Sends a signal 0.3 s after the command has begun to listen.
  CommandResult interrupt(const std::vector<std::string>& arguments, int signal = SIGINT) const {
    RunningCommand running = place_.start(arguments);
    while (running.runs() && !running.catches(signal)) {
      std::this_thread::sleep_for(milliseconds(5));
    }
    std::this_thread::sleep_for(milliseconds(300));
    EXPECT_TRUE(running.runs()) << "it ended before it could be interrupted";
    running.send(signal);
    // Left alone it would go on for minutes, and end with another code.
    CommandResult result = running.wait();
    EXPECT_EQ(result.code, 130) << result.err;
    return result;
  }

  Workplace place_;
};

TEST_F(InterruptedLongCase, OfSimulateAtRestWritesNothing) {
  place_.write("beam.toml", long_path());
  for (const int signal : {SIGINT, SIGTERM}) {
    const CommandResult result = interrupt({"simulate", "beam.toml", "-o", "beam.h5"}, signal);
    EXPECT_EQ(result.err, "plastica: interrupted; nothing is written of a path\n");
    EXPECT_EQ(result.out, "");
    EXPECT_FALSE(place_.has("beam.h5"));
  }
}

TEST_F(InterruptedLongCase, OfSimulateInMotionWritesWhatThereIs) {
  place_.write("beam.toml", long_motion());
  place_.write("articulated.toml",
               long_motion("scheme = 'articulated_midpoint'\n[rules]\nyield_model = 'elastic'\n"));
  for (const std::string name : {"beam", "articulated"}) {
    const CommandResult result = interrupt({"simulate", name + ".toml", "-o", name + ".h5"});
    EXPECT_NE(result.err.find("plastica: interrupted at "), std::string::npos) << result.err;
    EXPECT_TRUE(place_.has(name + ".h5"));
  }
}

TEST_F(InterruptedLongCase, EndsAtOnceByASecondSignal) {
  place_.write("beam.toml", long_path());
  RunningCommand running = place_.start({"simulate", "beam.toml", "-o", "beam.h5"});
  while (running.runs() && !running.catches(SIGINT)) std::this_thread::sleep_for(milliseconds(5));
  running.send(SIGINT);
  while (running.runs() && running.catches(SIGINT)) std::this_thread::sleep_for(milliseconds(1));
  if (running.runs()) running.send(SIGINT);
  EXPECT_EQ(running.wait().code, 130);
  EXPECT_FALSE(place_.has("beam.h5"));
}

TEST_F(InterruptedLongCase, OfASweepIsNotBegun) {
  place_.write("beam.toml", long_path());
  place_.write("sweep.toml", sweep_of("beam.toml"));
  const CommandResult result = interrupt({"sweep", "sweep.toml", "--threads", "2", "-o", "out.h5"});
  EXPECT_EQ(result.err, "plastica: interrupted; what is finished is kept: --resume goes on\n");
  EXPECT_FALSE(place_.has("out.h5"));
}

TEST_F(InterruptedLongCase, OfASweepIsRunByResume) {
  place_.write("beam.toml", beam(200, "steps = 10000\nframes = 1"));
  place_.write("sweep.toml", sweep_of("beam.toml"));
  interrupt({"sweep", "sweep.toml", "--threads", "1", "-o", "out.h5"});
  const CommandResult resumed = place_.run({"sweep", "sweep.toml", "--resume", "-o", "out.h5"});
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(resumed.out.find("interrupted"), std::string::npos) << resumed.out;
  ASSERT_EQ(place_.run({"sweep", "sweep.toml", "--quiet", "-o", "whole.h5"}).code, 0);
  expect_same_bits(place_, {"whole.h5", "out.h5"});
}

TEST_F(InterruptedLongCase, OfAFitThroughAScene) {
  place_.write("bar.toml", beam(300, "steps = 1000\n[rules]\nyield_model = 'fibre'"));
  std::string curve = "Displacement (mm),Force (N)\n";
  for (int i = 1; i <= 400; ++i) {
    curve += fmt::format("{},{}\n", 0.25 * i, 600.0 * std::tanh(i / 200.0));
  }
  place_.write("curve.csv", curve);
  // A run of some seconds, of which a fit takes dozens.
  std::string scene = place_.read("bar.toml");
  scene.replace(scene.find("[[load]]"), scene.find("[[probe]]") - scene.find("[[load]]"),
                "[[support]]\nat = \"end\"\nkind = \"roller\"\nhold = [\"y\"]\n"
                "translation = [\"0 mm\", \"-100 mm\", \"0 mm\"]\n");
  scene += "[[probe]]\nname = \"force\"\nkind = \"reaction\"\nat = \"end\"\ncomponent = \"y\"\n";
  place_.write("bar.toml", scene);
  place_.write("fit.toml", R"([fit.parameters]
youngs_modulus = { bounds = ["20 GPa", "2000 GPa"] }
yield_stress = { bounds = ["20 MPa", "20 GPa"] }
[[target]]
files = "curve.csv"
scene = "bar.toml"
abscissa = { drive = "support[2]", column = "Displacement" }
ordinate = { probe = "force", column = "Force", factor = -1 }
)");
  const CommandResult result =
      interrupt({"calibrate", "fit.toml", "--threads", "2", "-o", "out.h5"}, SIGTERM);
  EXPECT_TRUE(result.err.ends_with("what is finished is kept: --resume goes on\n")) << result.err;
  EXPECT_FALSE(place_.has("out.h5"));
}

TEST_F(InterruptedLongCase, OfAFitOfACurve) {
  place_.write("curve.csv", broken_curve(350.0, 0, 0.0005));
  place_.write("fit.toml", fit_file("'curve.csv'",
                                    "algorithm = 'isres'\nstop = { global_evaluations = 100000000, "
                                    "parameter_tolerance = 0, cost_tolerance = 0 }"));
  const CommandResult result = interrupt({"calibrate", "fit.toml", "-o", "out.h5"});
  EXPECT_EQ(result.err, "plastica: interrupted; what is finished is kept: --resume goes on\n");
  EXPECT_FALSE(place_.has("out.h5"));
}

TEST_F(InterruptedLongCase, OfACheckJudgesNothing) {
  place_.write("beam.toml", long_path());
  place_.write("sweep.toml", sweep_of("beam.toml"));
  place_.write("check.toml",
               "[[claim]]\nname = 'near the elastica'\nsweep = 'sweep.toml'\n"
               "error = { at_most = '5 %' }\n");
  const CommandResult result = interrupt({"check", "check.toml"});
  EXPECT_EQ(result.err, "plastica: interrupted\n");
  EXPECT_EQ(result.out, "");
}

TEST_F(InterruptedLongCase, OfTheScanOfASceneIsNoPoint) {
  place_.write("beam.toml", long_path());
  const CommandResult result =
      interrupt({"stability", "beam.toml", "--vary", "beam.length", "--quiet"});
  EXPECT_EQ(result.err, "plastica: interrupted after 0 points\n");
}

TEST_F(InterruptedLongCase, OfAdviceWritesNothing) {
  place_.write("beam.toml", long_motion());
  const CommandResult result = interrupt({"advise", "beam.toml", "--within", "0.001 %",
                                          "--max-work", "1e15", "--quiet", "-o", "advised.toml"});
  EXPECT_NE(result.out.find("interrupted"), std::string::npos) << result.out << result.err;
  EXPECT_FALSE(place_.has("advised.toml"));
}

}  // namespace
}  // namespace plastica::testing
