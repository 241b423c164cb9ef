#include <gtest/gtest.h>

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

}  // namespace
}  // namespace plastica
