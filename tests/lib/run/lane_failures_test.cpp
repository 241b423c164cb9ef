#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/sanitized.hpp"

/// Articulated schemes where steps fail, callers interrupt and samples are few.
namespace plastica {
namespace {

using testing::add_probe;

Scene struck(int segments, double speed, YieldModel model = YieldModel::Elastic) {
  Scene scene = testing::struck_scene(segments, speed, model);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

SolverOptions options_of(double step, double duration, int samples) {
  SolverOptions options = testing::motion_options(Scheme::ArticulatedMidpoint, step, samples);
  options.duration = duration;
  return options;
}

TEST(LaneFailures, EndAHopelessCaseInBoundedWork) {
  const Response response = simulate(struck(4, 1e12), options_of(1e-3, 0.1, 1));
  EXPECT_EQ(response.status, Status::NotConverged);
  EXPECT_EQ(response.samples, 1U);
  EXPECT_EQ(response.counters.steps, 0);
  EXPECT_GT(response.counters.iterations, 100);  // in vain
  EXPECT_LT(response.counters.iterations, 10000);
}

TEST(LaneFailures, CountTheStepsOfRetries) {
  SolverOptions options = options_of(1e-4, 2e-3, 1);
  const Response response = simulate(struck(4, 800.0), options);
  EXPECT_EQ(response.status, Status::Completed);
  EXPECT_GT(response.counters.cutbacks, 0);
  EXPECT_GT(response.counters.steps, 20);
  EXPECT_GT(response.counters.iterations, response.counters.steps);
}

TEST(LaneFailures, DoNotBelieveStepsWhoseEnergiesDoNotBalance) {
  // A string under tension in coarse steps: explicit geometry makes energy until steps are short.
  Scene scene = testing::cantilever_scene(32);
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  Load pull;
  pull.at = Place::end();
  pull.force = {0.0, 0.1, 1000.0};
  pull.history = History::constant();
  scene.loads.push_back(pull);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const Response coarse = simulate(scene, options_of(1e-3, 0.2, 10));
  const Response fine = simulate(scene, options_of(testing::kSanitized ? 2e-4 : 2e-5, 0.2, 10));
  ASSERT_EQ(fine.status, Status::Completed);
  if (coarse.status == Status::Completed) {
    EXPECT_LT(coarse.energy_balance_error, 0.05);
    double largest = 0.0, off = 0.0;
    for (std::size_t i = 0; i < fine.samples; ++i) {
      largest = std::max(largest, std::fabs(fine.probes[0][i]));
      off = std::max(off, std::fabs(coarse.probes[0][i] - fine.probes[0][i]));
    }
    EXPECT_LT(off, 0.1 * largest);
  } else {
    EXPECT_EQ(coarse.status, Status::NotConverged);
  }
}

TEST(LaneFailures, SumPermanentTurnsWhateverIsSampled) {
  Scene scene = testing::cantilever_scene(4);
  scene.yield_model = YieldModel::PerAxis;
  scene.material.density = 7850.0;
  Load shake;
  shake.at = Place::end();
  shake.force = {0.0, 600.0, 0.0};
  shake.history = {{0.0, 0.01, 0.03, 0.05, 0.06}, {0.0, 1.0, -1.0, 1.0, 0.0}};
  scene.loads.push_back(shake);
  add_probe(scene, ProbeQuantity::AccumulatedStrain, Place::start(), Component::X);
  const Response few = simulate(scene, options_of(2e-5, 0.06, 1));
  const Response many = simulate(scene, options_of(2e-5, 0.06, 60));
  const double sum = testing::last_of(many, 0);
  EXPECT_GT(sum, 1e-3);
  EXPECT_NEAR(testing::last_of(few, 0) / sum, 1.0, 1e-9);
}

TEST(LaneFailures, TellWithinALongInterval) {
  const Model model = prepare(struck(4, 1.0), options_of(1e-5, 1.0, 1));
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  int reported = 0;
  workspace.on_progress = [&](double time) {
    ++reported;
    EXPECT_GT(time, 0.0);
    return reported < 3;
  };
  run(model, {}, workspace, response);
  EXPECT_EQ(reported, 3);
  EXPECT_EQ(response.status, Status::Interrupted);
  EXPECT_EQ(response.samples, 1U);
}

TEST(LaneFailures, StopABatchWhoseCasesWait) {
  std::vector<BatchCase> cases;
  for (int i = 0; i < 40; ++i) cases.push_back({std::to_string(i), struck(4 + i, 1.0), {}});
  for (BatchCase& one : cases) one.options = options_of(1e-4, 1e-3, 1);
  std::atomic<bool> stop{false};
  BatchOptions options;
  options.threads = 1;
  options.stop = &stop;
  options.progress = [&](std::size_t finished) { stop = finished >= 3; };
  const std::vector<BatchRow> rows = run_batch(cases, options);
  int run = 0;
  for (const BatchRow& row : rows) run += row.response.status == Status::NotRun ? 0 : 1;
  EXPECT_EQ(run, 3);
}

TEST(LaneFailures, LetErrorsOfTheCallerThrough) {
  const BatchCase one{"one", struck(4, 1.0), options_of(1e-4, 1e-3, 1)};
  EXPECT_THROW(run_batch(
                   9, [&](std::size_t) { return BatchCase(one); },
                   [](std::size_t, BatchRow&&) { throw InputError({}, "take", "", "is full"); }),
               InputError);
}

TEST(LaneFailures, RefuseAStartThatIsHeldInPart) {
  for (std::size_t held = 0; held < 6; ++held) {
    Scene scene = struck(4, 1.0);
    scene.supports[0].hold = HeldFreedoms{};
    (*scene.supports[0].hold)[held] = true;
    EXPECT_THROW(prepare(scene, options_of(1e-4, 1e-3, 1)), InputError) << held;
  }
}

TEST(LaneFailures, RunABeamOfOneSegmentAndAWorkspaceTwice) {
  const Model model = prepare(struck(1, 1.0), options_of(1e-4, 1e-2, 3));
  Workspace workspace = make_workspace(model);
  Response first = make_response(model);
  Response second = make_response(model);
  run(model, {}, workspace, first);
  run(model, {}, workspace, second);
  EXPECT_EQ(first.status, Status::Completed);
  EXPECT_NE(testing::last_of(first, 0), 0.0);
  EXPECT_EQ(first.probes, second.probes);
  EXPECT_EQ(first.chain.position, second.chain.position);
}

}  // namespace
}  // namespace plastica
