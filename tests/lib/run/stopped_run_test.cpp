#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/response_bits.hpp"
#include "tests/support/sanitized.hpp"

/// Runs that a flag ends: within a step, not to be taken for results, and without a trace in what
/// is run next.
namespace plastica {
namespace {

using testing::add_probe;
using testing::bits_of;

/// A cantilever that yields under a force at its end.
Scene bent(int segments) {
  Scene scene = testing::cantilever_scene(segments);
  scene.yield_model = YieldModel::PerAxis;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 20e9;
  Load load;
  load.at = Place::end();
  load.force = {0.0, -1.2 * testing::yield_moment_of(scene), 0.0};
  scene.loads.push_back(load);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

Scene struck(int segments) {
  Scene scene = testing::struck_scene(segments, 1.0, YieldModel::PerAxis);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

SolverOptions under(PathControl control) {
  SolverOptions options;
  options.control = control;
  options.control_motion = {0.0, -0.1, 0.0};
  return options;
}

/// Runs with a flag that is raised after so many steps. @return how many were told
int run_until(int steps, const Model& model, Response& response) {
  std::atomic<bool> stop{false};
  Workspace workspace = make_workspace(model);
  workspace.stop = &stop;
  int reported = 0;
  workspace.on_progress = [&](double /*time*/) {
    stop = ++reported >= steps;
    return true;
  };
  run(model, {}, workspace, response);
  return reported;
}

/// Stops a run after `steps` steps, and expects that it leaves the samples up to there.
void expect_stops_within_a_step(const Scene& scene, const SolverOptions& options, int steps) {
  const Model model = prepare(scene, options);
  Response whole = make_response(model);
  const int all = run_until(1'000'000, model, whole);
  ASSERT_EQ(whole.status, Status::Completed) << name_of(whole.status);
  ASSERT_GT(all, steps + 1);
  Response response = make_response(model);
  EXPECT_EQ(run_until(steps, model, response), steps);
  EXPECT_EQ(response.status, Status::Interrupted);
  EXPECT_FALSE(usable(response.status));
  EXPECT_LT(response.samples, whole.samples);
  for (std::size_t i = 0; i < response.samples; ++i) {
    EXPECT_EQ(response.probes[0][i], whole.probes[0][i]) << i;
    EXPECT_EQ(response.chain.time[i], whole.chain.time[i]) << i;
  }
}

TEST(StoppedRun, OfAPathEndsWithinAStep) {
  for (const PathControl control :
       {PathControl::Load, PathControl::ArcLength, PathControl::Displacement}) {
    expect_stops_within_a_step(bent(8), under(control), 1);
    expect_stops_within_a_step(bent(8), under(control), 4);
  }
}

TEST(StoppedRun, OfAMotionEndsWithinAStep) {
  for (const Scheme scheme : {Scheme::GeneralizedAlpha, Scheme::EnergyMomentum}) {
    const SolverOptions options = testing::motion_options(scheme, 1e-4, 20);
    expect_stops_within_a_step(struck(4), options, 1);
    expect_stops_within_a_step(struck(4), options, 7);
  }
}

TEST(StoppedRun, OfAnArticulatedMotionEndsAtItsLastSample) {
  const SolverOptions options = testing::motion_options(Scheme::ArticulatedMidpoint, 1e-5, 20);
  expect_stops_within_a_step(struck(4), options, 7);
}

TEST(StoppedRun, LeavesNoTraceInTheNextOne) {
  std::vector<SolverOptions> all{under(PathControl::Load), under(PathControl::ArcLength)};
  for (const Scheme scheme : {Scheme::GeneralizedAlpha, Scheme::ArticulatedMidpoint}) {
    all.push_back(testing::motion_options(scheme, 1e-4, 20));
  }
  for (const SolverOptions& options : all) {
    const bool moves = options.analysis == Analysis::Dynamics;
    const Model model = prepare(moves ? struck(6) : bent(6), options);
    Response alone = make_response(model);
    Workspace fresh = make_workspace(model);
    run(model, {}, fresh, alone);
    Workspace workspace = make_workspace(model);
    std::atomic<bool> stop{true};
    workspace.stop = &stop;
    Response response = make_response(model);
    run(model, {}, workspace, response);
    EXPECT_EQ(response.status, Status::Interrupted);
    EXPECT_EQ(response.samples, moves ? 1U : 0U);
    stop = false;
    run(model, {}, workspace, response);
    EXPECT_TRUE(bits_of(response) == bits_of(alone));
  }
}

TEST(StoppedRun, KeepsTheShapesUpToThere) {
  SolverOptions options = under(PathControl::Load);
  options.steps = 40;
  options.frames = 4;
  const Model model = prepare(bent(6), options);
  Response whole = make_response(model);
  Workspace workspace = make_workspace(model);
  run(model, {}, workspace, whole);
  std::atomic<bool> stop{false};
  workspace.stop = &stop;
  workspace.on_progress = [&](double time) {
    stop = time >= 0.6;
    return true;
  };
  Response response = make_response(model);
  run(model, {}, workspace, response);
  ASSERT_EQ(response.status, Status::Interrupted);
  EXPECT_EQ(response.chain.frame_sample[2], 20U);
  EXPECT_EQ(response.chain.frame_sample[3], response.samples - 1);
  const std::size_t numbers = 3 * whole.chain.joints * 3;
  for (std::size_t i = 0; i < numbers; ++i) {
    EXPECT_EQ(response.chain.position[i], whole.chain.position[i]);
  }
}

/// Raises a flag after a while, from a thread of its own.
class Raiser {
 public:
  Raiser(std::atomic<bool>& flag, int milliseconds)
      : thread_([&flag, milliseconds] {
          std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
          flag = true;
        }) {}

 private:
  std::jthread thread_;
};

TEST(StoppedRun, EndsWhatWouldTakeHours) {
  // 10^8 steps; a stretch of 256 articulated steps of so many segments is cut, too.
  const int segments = testing::kSanitized ? 2000 : 20'000;
  for (const Scheme scheme : {Scheme::GeneralizedAlpha, Scheme::ArticulatedMidpoint}) {
    SolverOptions options = testing::motion_options(scheme, 1e-7, 10);
    options.duration = 10.0;
    const Model model = prepare(struck(segments), options);
    Workspace workspace = make_workspace(model);
    Response response = make_response(model);
    std::atomic<bool> stop{false};
    workspace.stop = &stop;
    const Raiser raiser(stop, 20);
    run(model, {}, workspace, response);
    EXPECT_EQ(response.status, Status::Interrupted);
    EXPECT_EQ(response.samples, 1U);
  }
}

TEST(StoppedBatch, CountsWhatWasUnderWayAsNotBegun) {
  // Fast cases between two that take hours.
  for (const int threads : {1, 2}) {
    std::vector<BatchCase> cases;
    for (int i = 0; i < 8; ++i) cases.push_back({std::to_string(i), bent(4 + i), {}});
    SolverOptions forever = testing::motion_options(Scheme::GeneralizedAlpha, 1e-7, 10);
    forever.duration = 10.0;
    cases.push_back({"long", struck(30), forever});
    cases.push_back({"long too", struck(31), forever});
    std::atomic<bool> stop{false};
    BatchOptions options;
    options.threads = threads;
    options.stop = &stop;
    std::size_t reported = 0;
    options.progress = [&](std::size_t finished) { reported = finished; };
    const Raiser raiser(stop, 50);
    std::size_t taken = 0;
    run_batch(
        cases.size(), [&](std::size_t i) { return cases[i]; },
        [&](std::size_t i, BatchRow&& row) {
          EXPECT_LT(i, 8U);
          EXPECT_EQ(row.response.status, Status::Completed);
          ++taken;
        },
        options);
    EXPECT_EQ(reported, taken);
  }
}

TEST(StoppedBatch, OfPathsSideBySideDropsThoseThatHaveNotEnded) {
  const Model model = prepare(bent(200), {}, std::vector<std::string>{"material.yield_stress"});
  std::vector<double> values;
  for (int i = 0; i < 4000; ++i) values.push_back(240e6 + 1e4 * i);
  std::atomic<bool> stop{false};
  BatchOptions options;
  options.threads = 1;
  options.stop = &stop;
  std::size_t finished = 0;
  options.progress = [&](std::size_t so_many) { finished = so_many; };
  const Raiser raiser(stop, 30);
  const std::vector<Response> responses = run_batch(model, values, values.size(), options);
  std::size_t completed = 0;
  for (const Response& response : responses) {
    if (response.status == Status::Completed) {
      ++completed;
    } else {
      EXPECT_EQ(response.status, Status::NotRun);
      EXPECT_TRUE(response.chain.time.empty());
    }
  }
  EXPECT_EQ(completed, finished);
  EXPECT_LT(completed, values.size());
}

/// Stopped between the first equilibrium that yields and its acceptance, joints yield as none of
/// the path's accepted equilibria does. When that is only a clock knows: many tries.
TEST(StoppedBatch, OfPathsSideBySideEndsInTheFirstStepThatYieldsAsInAnyOther) {
  using Clock = std::chrono::steady_clock;
  const Model model = prepare(bent(20), {}, std::vector<std::string>{"material.yield_stress"});
  const std::vector<double> values(8, 240e6);
  BatchOptions options;
  options.threads = 1;
  const auto begin = Clock::now();
  const std::vector<Response> whole = run_batch(model, values, values.size(), options);
  const auto took = Clock::now() - begin;
  constexpr int kTries = testing::kSanitized ? 10 : 150;
  for (int i = 0; i < kTries; ++i) {
    std::atomic<bool> stop{false};
    options.stop = &stop;
    const std::jthread raiser([&stop, at = Clock::now() + took * i / kTries] {
      while (Clock::now() < at) std::this_thread::yield();
      stop = true;
    });
    for (const Response& response : run_batch(model, values, values.size(), options)) {
      if (response.status != Status::Completed) continue;
      EXPECT_TRUE(bits_of(response) == bits_of(whole.front()));
    }
  }
}

TEST(StoppedBatch, HasTheSameBitsWithAFlagThatIsNeverRaised) {
  // Of many segments an articulated motion is stepped in other stretches in company than alone: 43
  // steps and 256. Which they are is nothing to a sanitizer.
  const int segments = testing::kSanitized ? 60 : 3000;
  std::vector<BatchCase> cases;
  SolverOptions options = testing::motion_options(Scheme::ArticulatedMidpoint, 1e-6, 2);
  options.duration = 1e-4;
  for (int i = 0; i < 3; ++i) cases.push_back({std::to_string(i), struck(segments), options});
  const std::atomic<bool> stop{false};
  BatchOptions how;
  how.threads = 1;
  how.stop = &stop;
  const std::vector<BatchRow> rows = run_batch(cases, how);
  const Response alone = simulate(cases.front().scene, options);
  EXPECT_EQ(alone.status, Status::Completed);
  for (const BatchRow& row : rows) EXPECT_TRUE(bits_of(row.response) == bits_of(alone));
}

}  // namespace
}  // namespace plastica
