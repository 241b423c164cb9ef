#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/chain_scene.hpp"

namespace plastica {
namespace {

/// When a beam in free flight for 0.7 s of seven samples is cut.
double time_of_cut(double asked) {
  Scene scene = testing::chain_scene(4);
  scene.initial_motions.push_back({.velocity = {0.0, 3.0, 0.0}});
  scene.cuts.push_back({{0.5, {}}, asked});
  const SolverOptions options{
      .analysis = Analysis::Dynamics, .duration = 0.7, .steps = 7, .time_step = 0.01};
  const Response response = simulate(scene, options);
  EXPECT_EQ(response.chain.events.size(), 1U);
  return response.chain.events.at(0).time;
}

TEST(MotionCut, ComesAtItsTimeBetweenSamplesAndAtOne) {
  EXPECT_DOUBLE_EQ(time_of_cut(0.25), 0.25);
  // In numbers, the third of seven parts of 0.7 s is a little less than 0.3 s.
  ASSERT_LT(0.7 * 3 / 7, 0.3);
  EXPECT_DOUBLE_EQ(time_of_cut(0.3), 0.3);
  EXPECT_EQ(time_of_cut(0.0), 0.0);
}

TEST(MotionCut, AtTheEndLeavesWhatElseHoldsTheLastSegment) {
  // The clamp at the end is cut; a roller within the last segment holds on.
  Scene scene = testing::cantilever_scene(4);
  scene.beam.segment_fractions = {0.25, 0.25, 0.25, 0.25};
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
  scene.supports.back().hold = HeldFreedoms{true, true, false, true, true, true};
  scene.supports.push_back({.at = {0.9, {}}, .kind = SupportKind::Roller});
  scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, -100.0, 0.0}});
  scene.cuts.push_back({.at = Place::end(), .time = 0.0});
  testing::add_probe(scene, ProbeQuantity::Displacement, {0.9, {}}, Component::Y);
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const SolverOptions options{
      .analysis = Analysis::Dynamics, .duration = 0.02, .steps = 20, .time_step = 1e-3};
  const Response response = simulate(scene, options);
  ASSERT_EQ(response.samples, 21U);
  double held = 0.0;
  double moved = 0.0;
  for (std::size_t i = 0; i < response.samples; ++i) {
    held = std::max(held, std::fabs(response.probes[0][i]));
    moved = std::max(moved, std::fabs(response.probes[1][i]));
  }
  EXPECT_LT(held, 1e-9);
  EXPECT_GT(moved, 1e-6);
}

}  // namespace
}  // namespace plastica
