#include "plastica/run/path_stops.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/motion_scene.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica {
namespace {

using testing::motion_options;

SolverOptions sampled(double time_step, double every, int samples) {
  SolverOptions options = motion_options(Scheme::EnergyMomentum, time_step, samples);
  options.duration = every * samples;
  return options;
}

TEST(TakenTimeStep, IsCutToTheSamples) {
  const Scene scene = testing::cantilever_scene(4);
  EXPECT_DOUBLE_EQ(taken_time_step(scene, sampled(0.05, 0.002, 10)), 0.002);
  EXPECT_DOUBLE_EQ(taken_time_step(scene, sampled(0.002, 0.002, 10)), 0.002);
}

TEST(TakenTimeStep, DividesTheWayBetweenSamplesEvenly) {
  const Scene scene = testing::cantilever_scene(4);
  const double taken = taken_time_step(scene, sampled(0.002, 0.005, 10));
  EXPECT_NEAR(taken, 0.005 / 3.0, testing::tolerance(1e-15));
  // And comes to itself.
  EXPECT_DOUBLE_EQ(taken_time_step(scene, sampled(taken, 0.005, 10)), taken);
}

TEST(TakenTimeStep, IsThatAskedForOfAdaptiveSteps) {
  SolverOptions options = sampled(0.05, 0.002, 10);
  options.step_error = 1e-5;
  EXPECT_EQ(taken_time_step(testing::cantilever_scene(4), options), 0.05);
}

TEST(FixedSteps, AreCountedBetweenSamplesCornersAndCuts) {
  Scene scene = testing::cantilever_scene(4);
  Load load;
  load.force = {0.0, 1.0, 0.0};
  load.history = {{0.0, 0.013, 0.04}, {0.0, 1.0, 1.0}};
  scene.loads = {load};
  scene.cuts.push_back({{0.5, {}}, 0.035});
  const SolverOptions options = sampled(0.004, 0.01, 4);
  const PathStops stops = path_stops(scene, options);
  const std::vector<double> times{0.01, 0.013, 0.02, 0.03, 0.035, 0.04};
  ASSERT_EQ(stops.time.size(), times.size());
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(stops.time[k], times[k], 1e-15);
  const std::vector<bool> recorded{true, false, true, true, false, true};
  EXPECT_EQ(stops.recorded, recorded);
  const FixedSteps steps = fixed_steps(stops, options.time_step);
  EXPECT_EQ(steps.count, 3 + 1 + 2 + 3 + 2 + 2);
  EXPECT_NEAR(steps.longest, 0.007 / 2.0, 1e-15);
  EXPECT_NEAR(steps.samples, 0.01, 1e-15);
}

// cos(2 pi t / T) turns at 0, T/2, T: rounding puts the first at 2e-18 s.
TEST(FixedSteps, DoNotBeginWithATurnThatRoundingHasMade) {
  Scene scene = testing::cantilever_scene(4);
  Load load;
  load.force = {0.0, 1.0, 0.0};
  load.history = History::sine(0.04, 2.0, 0.5 * std::numbers::pi);
  scene.loads = {load};
  SolverOptions options;
  options.analysis = Analysis::Statics;
  options.duration = 0.08;
  options.steps = 4;
  const PathStops stops = path_stops(scene, options);
  ASSERT_EQ(stops.time.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(stops.time[k], 0.02 * static_cast<double>(k + 1), 1e-15);
  }
  EXPECT_EQ(stops.recorded, std::vector<bool>(4, true));
}

TEST(FixedSteps, AreThoseThatAMotionTakes) {
  Scene scene = testing::struck_scene(4, 0.1, YieldModel::Elastic);
  const SolverOptions options = sampled(0.05, 0.002, 5);
  const Response response = simulate(scene, options);
  ASSERT_EQ(response.status, Status::Completed);
  EXPECT_EQ(response.counters.steps, 5);
  EXPECT_NEAR(response.longest_step, 0.002, 1e-12);
  EXPECT_NEAR(response.shortest_step, 0.002, 1e-12);
}

TEST(FixedSteps, AreThoseThatLanesTake) {
  Scene scene = testing::struck_scene(4, 0.1, YieldModel::Elastic);
  SolverOptions options = sampled(3e-5, 1e-4, 5);
  options.scheme = Scheme::ArticulatedMidpoint;
  const Response response = simulate(scene, options);
  ASSERT_EQ(response.status, Status::Completed);
  EXPECT_EQ(response.counters.steps, 20);
  EXPECT_NEAR(response.longest_step, 2.5e-5, 1e-15);
  EXPECT_NEAR(response.shortest_step, 2.5e-5, 1e-15);
}

// Two time steps that come to the same run have the same bits.
TEST(TakenTimeStep, DecidesTheRun) {
  const Scene scene = testing::struck_scene(4, 0.1, YieldModel::Elastic);
  const Response coarse = simulate(scene, sampled(0.05, 0.002, 5));
  const Response same = simulate(scene, sampled(0.002, 0.002, 5));
  EXPECT_EQ(coarse.chain.position, same.chain.position);
}

}  // namespace
}  // namespace plastica
