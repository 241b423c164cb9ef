#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/curves.hpp"
#include "tests/cli/results.hpp"
#include "tests/support/has.hpp"

namespace plastica::testing {
namespace {

/// A cantilever that swings under a sudden force until the scene cuts it in two.
std::string motion_text(const std::string& solver) {
  return R"([beam]
length = "1 m"
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
segments = 8
[solver]
analysis = "dynamics"
)" + solver +
         R"(
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = "end"
force = ["0 N", "-50 N", "0 N"]
history = "constant"
[[cut]]
at = 0.5
time = "0.4 s"
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
[[probe]]
name = "speed"
kind = "velocity"
at = "end"
)";
}

const std::string kHalfASecond = "time_step = '1 ms'\nduration = '0.5 s'\nsteps = 250\nframes = 10";

class MotionResult : public ::testing::Test {
 protected:
  CommandResult simulate(const std::string& solver) const {
    place_.write("beam.toml", motion_text(solver));
    return place_.run({"simulate", "beam.toml", "-o", "beam.h5", "--json", "beam.json"});
  }

  Workplace place_;
};

TEST_F(MotionResult, IsShownAsItWasPrintedAndHasNoProgressInALog) {
  const CommandResult result = simulate(kHalfASecond);
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "wrote beam.h5\n");
  EXPECT_TRUE(result.out.starts_with("beam: broken: 1 joint cut by the scene; 2 fragments\n"))
      << result.out;
  EXPECT_TRUE(has(result.out, "  samples         251, with the shape of 11 frames\n"));
  EXPECT_TRUE(has(result.out, "\nFrequencies\n  probe"));
  EXPECT_EQ(place_.run({"show", "beam.h5"}).out, result.out);
  const auto json = nlohmann::json::parse(place_.read("beam.json"));
  EXPECT_EQ(nlohmann::json::parse(place_.run({"export", "beam.h5", "--to", "json"}).out), json);
  EXPECT_EQ(json.at("events").at(0).at("fragments").size(), 2U);
  EXPECT_EQ(json.at("energies").at("balanced"), true);
}

TEST_F(MotionResult, OfTwoRunsDiffersInMetaAlone) {
  ASSERT_EQ(simulate(kHalfASecond).code, 0);
  EXPECT_EQ(place_.run({"simulate", "beam.toml", "-o", "again.h5", "--quiet"}).code, 0);
  expect_same_bits(place_, {"beam.h5", "again.h5"});
}

TEST_F(MotionResult, IsDrawnAsEachPictureThatItHas) {
  ASSERT_EQ(simulate(kHalfASecond).code, 0);
  for (const std::string what : {"film", "shape", "moment", "history", "energy", "spectrum"}) {
    const CommandResult drawn =
        place_.run({"plot", "beam.h5", "--what", what, "-o", what + ".svg"});
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_TRUE(has(place_.read(what + ".svg"), "</svg>")) << what;
    EXPECT_GT(lines_of(place_.run({"plot", "beam.h5", "--what", what}).out), 12U) << what;
  }
  EXPECT_EQ(place_.run({"plot", "beam.h5", "-o", "again.svg"}).code, 0);
  EXPECT_EQ(place_.read("again.svg"), place_.read("film.svg"));
  EXPECT_TRUE(has(place_.read("film.svg"), "500 ms, 2 fragments"));
  EXPECT_EQ(place_
                .run({"plot", "beam.h5", "--what", "film", "--frames", "3", "--from", "400 ms",
                      "--to", "0.5 s", "-o", "end.svg"})
                .code,
            0);
  EXPECT_TRUE(has(place_.read("end.svg"), "450 ms, 2 fragments"));
  EXPECT_FALSE(has(place_.read("end.svg"), "350 ms"));
  EXPECT_EQ(
      place_.run({"plot", "beam.h5", "--what", "shape", "--time", "199 ms", "-o", "early.svg"})
          .code,
      0);
  EXPECT_TRUE(has(place_.read("early.svg"), "at 200 ms; largest displacement"));
}

TEST_F(MotionResult, IsExportedAsEachTableThatItHas) {
  ASSERT_EQ(simulate(kHalfASecond).code, 0);
  const auto exported = [&](const std::string& what) {
    const CommandResult table = place_.run({"export", "beam.h5", "--what", what});
    EXPECT_EQ(table.code, 0) << table.err;
    return table.out;
  };
  EXPECT_EQ(lines_of(exported("probes")), 252U);
  EXPECT_EQ(lines_of(exported("energies")), 252U);
  EXPECT_EQ(lines_of(exported("joints")), 10U);
  EXPECT_EQ(lines_of(exported("events")), 2U);
  EXPECT_EQ(lines_of(exported("fragments")), 3U);
  const CommandResult old = place_.run({"export", "beam.h5", "--what=pieces"});
  EXPECT_EQ(old.out, exported("fragments"));
  EXPECT_EQ(old.err, "plastica: --what pieces is now fragments\n");
  EXPECT_TRUE(exported("spectrum").starts_with("frequency [Hz],tip [m],speed [m/s]\n"));
  const CommandResult early =
      place_.run({"export", "beam.h5", "--what", "joints", "--time", "100 ms"});
  EXPECT_EQ(early.code, 0) << early.err;
  EXPECT_NE(early.out, exported("joints"));
}

TEST_F(MotionResult, ForetellsItsStepsWithoutARun) {
  place_.write("beam.toml", motion_text(kHalfASecond));
  const CommandResult result = place_.run({"simulate", "beam.toml", "--dry-run"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(has(result.out, "251 samples, 11 frames, 2 probes, ")) << result.out;
  EXPECT_TRUE(has(result.out, "generalized_alpha, 0.5 s in 500 steps of 0.001 s\n")) << result.out;
  // Steel of 210 GPa and 20 mm: 16.71 Hz, less 0.7 % for eight segments.
  EXPECT_TRUE(has(result.out, "\nunloaded, it swings at 16.6, ")) << result.out;
  EXPECT_TRUE(has(result.out, " Hz: 60.3, ")) << result.out;
}

TEST_F(MotionResult, ForetellsWaysToMoveThatNothingResists) {
  std::string text = motion_text(kHalfASecond + "\nstep_error = 1e-6");
  text.replace(text.find("\"clamp\""), 7, "\"pin\"");
  place_.write("beam.toml", text);
  const CommandResult result = place_.run({"simulate", "beam.toml", "--dry-run"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(has(result.out, " Hz: at least ")) << result.out;
  EXPECT_TRUE(has(result.out, " steps a period; nothing resists 1 mode of motion\n")) << result.out;
}

TEST_F(MotionResult, ForetellsTheFrequenciesOfLongChains) {
  std::string text = motion_text(kHalfASecond);
  text.replace(text.find("segments = 8"), 12, "segments = 2000");
  place_.write("beam.toml", text);
  const CommandResult result = place_.run({"simulate", "beam.toml", "--dry-run"});
  EXPECT_EQ(result.code, 0) << result.err;
  // 3.516, 22.03 and 61.70 times sqrt(EI/(rho A))/(2 pi L^2) = 4.753 Hz.
  EXPECT_TRUE(has(result.out, "unloaded, it swings at 16.7, 105 and 293 Hz")) << result.out;
}

TEST_F(MotionResult, IsWrittenEvenWhereAStepCannotBeSolved) {
  const CommandResult result = simulate(
      "time_step = '50 ms'\nduration = '1 s'\nsteps = 20\nmax_iterations = 1\n"
      "smallest_step = 0.9\nscheme = 'energy_momentum'");
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_TRUE(result.out.starts_with("beam: not-converged after ")) << result.out;
  EXPECT_TRUE(has(result.err, "wrote beam.h5\nplastica: not-converged: take smaller steps; "))
      << result.err;
  EXPECT_TRUE(has(result.out, "\n  advice          take smaller steps; ")) << result.out;
  EXPECT_EQ(place_.run({"show", "beam.h5"}).out, result.out);
}

TEST_F(MotionResult, OfAnInterruptedRunIsWhatWasComputed) {
  // Ten seconds in microseconds: minutes of work. A signal before the run has begun just ends it.
  place_.write("beam.toml", motion_text("time_step = '1 us'\nduration = '10 s'\nsteps = 100000\n"
                                        "frames = 10"));
  CommandResult stopped;
  for (int wait = 100; wait < 20000; wait *= 2) {
    RunningCommand running = place_.start({"simulate", "beam.toml", "-o", "beam.h5"});
    std::this_thread::sleep_for(std::chrono::milliseconds(wait));
    running.send(SIGINT);
    stopped = running.wait();
    if (place_.has("beam.h5")) break;
  }
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  ASSERT_TRUE(place_.has("beam.h5"));
  EXPECT_TRUE(stopped.out.starts_with("beam: interrupted after ")) << stopped.out;
  EXPECT_TRUE(has(stopped.err, "wrote beam.h5\nplastica: interrupted at ")) << stopped.err;
  EXPECT_TRUE(has(stopped.err, ": beam.h5 holds what was computed up to there\n")) << stopped.err;
  EXPECT_EQ(place_.run({"show", "beam.h5"}).out, stopped.out);
  const auto json = nlohmann::json::parse(place_.run({"export", "beam.h5", "--to", "json"}).out);
  EXPECT_EQ(json.at("status"), "interrupted");
  EXPECT_GE(json.at("samples"), 1);
  EXPECT_LT(json.at("samples"), 100001);
  EXPECT_EQ(place_.run({"plot", "beam.h5", "--what", "history"}).code, 0);
}

TEST_F(MotionResult, OfAMotionThatDoesNotBalanceIsKeptAndNoSuccess) {
  place_.write("spin.toml", R"([beam]
length = "1 m"
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
segments = 8
[rules]
yield_model = "elastic"
[solver]
analysis = "dynamics"
scheme = "linearly_implicit_euler"
duration = "50 ms"
steps = 10
time_step = "0.1 ms"
[[initial_motion]]
about = 0.5
spin = ["180 rad/s", "0 rad/s", "0 rad/s"]
[[probe]]
name = "momentum"
kind = "angular_momentum"
component = "x"
)");
  const CommandResult result =
      place_.run({"simulate", "spin.toml", "-o", "spin.h5", "--json", "spin.json"});
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_TRUE(has(result.out, "spin: not-balanced")) << result.out;
  const auto json = nlohmann::json::parse(place_.read("spin.json"));
  EXPECT_EQ(json.at("status"), "not-balanced");
  EXPECT_EQ(json.at("samples"), 11);
  EXPECT_GT(json.at("energies").at("momentum_error"), 0.01);
  const CommandResult shown = place_.run({"show", "spin.h5"});
  EXPECT_TRUE(has(shown.out, "not-balanced")) << shown.out << shown.err;
}

TEST_F(MotionResult, SaysWhichStepsRanAndWillRun) {
  place_.write("beam.toml",
               motion_text("time_step = '50 ms'\nduration = '0.5 s'\nsteps = 250\nframes = 10"));
  const CommandResult dry = place_.run({"simulate", "beam.toml", "--dry-run"});
  EXPECT_TRUE(has(dry.out, "250 steps of 0.002 s (0.05 s cut to samples that are 0.002 s apart)"))
      << dry.out;
  const CommandResult run = place_.run({"simulate", "beam.toml", "-o", "beam.h5"});
  EXPECT_TRUE(has(run.out, "2 ms, fixed: 50 ms are cut to the samples, 2 ms apart")) << run.out;
}

}  // namespace
}  // namespace plastica::testing
