#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "plastica/io/scene_file.hpp"
#include "tests/support/motion_scene.hpp"

/// The files of data/scenes that move.
namespace plastica {
namespace {

Setup scene_file(const std::string& name) {
  return io::read_scene_file(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/" + name + ".toml")
      .setup;
}

TEST(MotionScenes, LaysFigure8DownWhereStaticsPutsIt) {
  const auto moving = scene_file("report_fig08_motion");
  const auto still = scene_file("report_fig08_round");
  const Response motion = testing::completed(moving.scene, moving.solver);
  const Response rest = testing::completed(still.scene, still.solver);
  for (std::size_t probe = 0; probe < 3; ++probe) {
    const double expected = testing::last_of(rest, probe);
    EXPECT_NEAR(testing::last_of(motion, probe), expected, 1e-6 * std::fabs(expected)) << probe;
  }
  EXPECT_LT(motion.energy_balance_error, 1e-9);
}

TEST(MotionScenes, BreaksFigure11InTheMiddle) {
  const auto setup = scene_file("report_fig11_broken");
  const Response response = simulate(setup.scene, setup.solver);
  EXPECT_EQ(response.status, Status::Broken);
  ASSERT_EQ(response.chain.events.size(), 1U);
  EXPECT_EQ(response.chain.events[0].joints.size(), 1U);
  EXPECT_EQ(response.chain.events[0].fragments, (std::vector<Fragment>{{0, 9}, {10, 19}}));
  // Energy-momentum makes a little where joints yield in a step's midst.
  EXPECT_LT(testing::largest_residual(response), 1e-8);
  EXPECT_LT(response.energy_balance_error, 1e-5);
}

TEST(MotionScenes, BreaksTheBumperAtThePillar) {
  const auto setup = scene_file("crash_bumper");
  const Response response = simulate(setup.scene, setup.solver);
  EXPECT_EQ(response.status, Status::Broken);
  ASSERT_FALSE(response.chain.events.empty());
  EXPECT_EQ(response.chain.events[0].joints[0].joint, 14);
  EXPECT_NEAR(response.chain.events[0].time, 0.012, 0.001);
  EXPECT_LT(testing::largest_residual(response), 1e-3);
  EXPECT_LT(response.energy_balance_error, 5e-3);
  for (const double y : response.probes[1]) EXPECT_GT(y, -0.02 - 1e-6);
}

}  // namespace
}  // namespace plastica
