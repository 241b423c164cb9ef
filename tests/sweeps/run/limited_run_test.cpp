#include "sweeps/run/limited_run.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "plastica/io/scene_file.hpp"

namespace plastica::sweeps {
namespace {

/// A cantilever under a force at its tip, on a path of twenty steps or in motion.
Setup cantilever(const std::string& solver) {
  return io::parse_scene_file(
             "material = 'S355'\n[beam]\nlength = '1 m'\nsegments = 8\n"
             "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
             "[rules]\nyield_model = 'fibre'\n[solver]\n" +
                 solver +
                 "\n[[support]]\nat = 'start'\nkind = 'clamp'\n"
                 "[[load]]\nat = 'end'\nforce = ['0 N', '-500 N', '0 N']\n"
                 "[[probe]]\nname = 'tip'\nkind = 'displacement'\nat = 'end'\ncomponent = 'y'\n",
             "cantilever.toml")
      .setup;
}

Setup at_rest() { return cantilever("steps = 20"); }

Setup in_motion() {
  return cantilever("analysis = 'dynamics'\nduration = '10 ms'\ntime_step = '0.1 ms'\nsteps = 10");
}

TEST(PlannedSteps, AreThoseOfThePathOrOfTheTimeStep) {
  EXPECT_EQ(planned_steps(at_rest()), 20.0);
  EXPECT_EQ(planned_steps(in_motion()), 100.0);
}

TEST(LimitedRun, IsStoppedAfterSoManySteps) {
  for (const plastica::Setup& setup : {at_rest(), in_motion()}) {
    const LimitedRun run = run_limited(setup, {.steps = 7.0}, nullptr);
    EXPECT_TRUE(run.stopped);
    EXPECT_EQ(run.row.response.status, Status::Interrupted);
    EXPECT_EQ(run.row.response.counters.steps, 7);
    EXPECT_EQ(run.row.reason, "takes more than 7 steps");
  }
}

TEST(LimitedRun, IsStoppedAfterSoManyIterations) {
  for (const plastica::Setup& setup : {at_rest(), in_motion()}) {
    const Response free = simulate(setup.scene, setup.solver);
    const double half = free.counters.iterations / 2.0;
    const LimitedRun run = run_limited(setup, {.iterations = half}, nullptr);
    EXPECT_TRUE(run.stopped);
    EXPECT_EQ(run.row.reason.find("takes more than "), 0u);
    const Response& response = run.row.response;
    EXPECT_EQ(response.status, Status::Interrupted);
    // The step that reaches it is taken to its end.
    EXPECT_GE(response.counters.iterations, half - 1.0);
    EXPECT_LT(response.counters.iterations, 0.75 * free.counters.iterations);
  }
}

TEST(LimitedRun, IsStoppedAfterSoLong) {
  const LimitedRun run = run_limited(at_rest(), {.seconds = 1e-12}, nullptr);
  EXPECT_TRUE(run.stopped);
  EXPECT_EQ(run.row.response.counters.steps, 1);
  EXPECT_EQ(run.row.reason, "takes more than 1e-12 s");
}

TEST(LimitedRun, WithinItsLimitIsTheRunItself) {
  for (const plastica::Setup& setup : {at_rest(), in_motion()}) {
    const Response free = simulate(setup.scene, setup.solver);
    const LimitedRun run = run_limited(
        setup, {.steps = free.counters.steps + 1.0, .iterations = free.counters.iterations + 1.0},
        nullptr);
    EXPECT_FALSE(run.stopped);
    EXPECT_EQ(run.row.reason, "");
    EXPECT_EQ(run.row.response.status, Status::Completed);
    EXPECT_EQ(run.row.response.probes, free.probes);
    EXPECT_EQ(run.row.response.counters.iterations, free.counters.iterations);
  }
}

TEST(LimitedRun, IsNotStoppedByItsLimitWhereTheFlagIsRaised) {
  const std::atomic<bool> stop = true;
  const LimitedRun run = run_limited(at_rest(), {}, &stop);
  EXPECT_EQ(run.row.response.status, Status::Interrupted);
  EXPECT_FALSE(run.stopped);
}

TEST(LimitedRun, ThrowsWhatTheChecksRefuse) {
  plastica::Setup setup = at_rest();
  setup.scene.beam.segments = 0;
  EXPECT_THROW((void)run_limited(setup, {}, nullptr), InputError);
}

}  // namespace
}  // namespace plastica::sweeps
