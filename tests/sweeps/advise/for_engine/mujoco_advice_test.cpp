#include <gtest/gtest.h>

#ifdef PLASTICA_HAS_MUJOCO

#include <string>
#include <vector>

#include "tests/sweeps/advise/for_engine/engine_advice_scenes.hpp"
#include "tests/sweeps/advise/for_engine/engine_truth.hpp"
#include "tests/sweeps/advise/for_engine/mujoco_scene.hpp"

/// Advice for MuJoCo is run in MuJoCo.
namespace plastica::testing {
namespace {

Histories run_in_mujoco(const plastica::Setup& setup, const sweeps::EngineAdvice& advice) {
  MujocoScene mujoco(setup.scene, advice.beam);
  EXPECT_NEAR(mujoco.model().opt.timestep, advice.time_step, 1e-13 * advice.time_step);
  return mujoco.run(setup.solver.steps, advice.setting.steps);
}

void expect_within_in_mujoco(const std::string& text, const std::vector<double>& errors) {
  expect_within("mujoco", text, errors, run_in_mujoco);
}

TEST(MujocoAdvice, HoldsInMujocoForAStripThatIsLetGo) {
  expect_within_in_mujoco(released_strip(), {0.05, 0.02, 0.005});
}

TEST(MujocoAdvice, HoldsInMujocoForABarUnderAForceThatComesAtOnce) {
  expect_within_in_mujoco(struck_bar(), {0.05, 0.01});
}

TEST(MujocoAdvice, HoldsInMujocoForAStripThatIsSwungFar) {
  expect_within_in_mujoco(swung_strip(), {0.05, 0.02});
}

TEST(MujocoAdvice, HoldsInMujocoForTheRobotsArmWhoseClampTurns) {
  expect_within_in_mujoco(robot_arm(), {0.05, 0.02, 0.01});
}

TEST(MujocoAdvice, HoldsInMujocoInSpace) { expect_within_in_mujoco(biaxial_bar(), {0.05, 0.02}); }

TEST(MujocoAdvice, HoldsInMujocoForADampedBarWithAMassAtItsEnd) {
  expect_within_in_mujoco(damped_arm(), {0.05, 0.01});
}

}  // namespace
}  // namespace plastica::testing

#endif
