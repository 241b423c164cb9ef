#include <gtest/gtest.h>

#ifdef PLASTICA_HAS_MUJOCO

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "plastica/io/scene_file.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/advise/for_engine/engine_advice.hpp"
#include "tests/sweeps/advise/for_engine/engine_advice_scenes.hpp"
#include "tests/sweeps/advise/for_engine/mujoco_scene.hpp"

/// Advice for MuJoCo is run in MuJoCo.
namespace plastica::testing {
namespace {

/// The error of a history as the advice measures it, computed here anew: of the history the root
/// mean square over that of the truth, of the largest size and of the last value the difference
/// over the truth's largest size.
double error_of(const std::vector<double>& history, const std::vector<double>& truth) {
  double squares = 0.0;
  double difference = 0.0;
  double largest = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    squares += truth[i] * truth[i];
    difference += (history[i] - truth[i]) * (history[i] - truth[i]);
    largest = std::max(largest, std::abs(history[i]));
    scale = std::max(scale, std::abs(truth[i]));
  }
  return std::max({std::sqrt(difference / squares), std::abs(largest - scale) / scale,
                   std::abs(history.back() - truth.back()) / scale});
}

/// The scene by our own dynamics, much finer than any advice here: 128 segments, 8000 steps, energy
/// conserved; joints that stretch and shear.
std::vector<std::vector<double>> truth_of(plastica::Setup setup) {
  setup.scene.beam.segments = 128;
  setup.solver.scheme = Scheme::EnergyMomentum;
  setup.solver.translation = JointTranslation::Elastic;
  setup.solver.time_step = setup.solver.duration / 8000.0;
  const Response response = completed(setup.scene, setup.solver);
  return response.probes;
}

/// The largest error of the scene's probes in MuJoCo itself, by advice within an error.
double error_in_mujoco(const plastica::Setup& setup, const sweeps::EngineAdvice& advice,
                       const std::vector<std::vector<double>>& truth) {
  MujocoScene mujoco(setup.scene, advice.beam);
  EXPECT_NEAR(mujoco.model().opt.timestep, advice.time_step, 1e-13 * advice.time_step);
  const auto histories = mujoco.run(setup.solver.steps, advice.setting.steps);
  double error = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    error = std::max(error, error_of(histories[k], truth[k]));
  }
  return error;
}

/// Advises for some errors, and runs each advice in MuJoCo.
void expect_within(const std::string& text, const std::vector<double>& errors) {
  const plastica::Setup setup = io::parse_scene_file(text, "scene.toml").setup;
  const auto truth = truth_of(setup);
  for (const double within : errors) {
    SCOPED_TRACE(within);
    sweeps::AdviceOptions options;
    options.within = within;
    const sweeps::EngineAdvice advice = sweeps::advise_for_mujoco(setup, options);
    ASSERT_EQ(advice.end, sweeps::EngineAdviceEnd::Found);
    EXPECT_LE(advice.promised, within);
    const double measured = error_in_mujoco(setup, advice, truth);
    ::testing::Test::RecordProperty("measured_within_" + std::to_string(within),
                                    std::to_string(measured));
    EXPECT_LE(measured, advice.promised);
    // Near what was asked for, so that it is not dearer than need be.
    EXPECT_GT(measured, 0.2 * within);
  }
}

TEST(MujocoAdvice, HoldsInMujocoForAStripThatIsLetGo) {
  expect_within(released_strip(), {0.05, 0.02, 0.005});
}

TEST(MujocoAdvice, HoldsInMujocoForABarUnderAForceThatComesAtOnce) {
  expect_within(struck_bar(), {0.05, 0.01});
}

TEST(MujocoAdvice, HoldsInMujocoForAStripThatIsSwungFar) {
  expect_within(swung_strip(), {0.05, 0.02});
}

TEST(MujocoAdvice, HoldsInMujocoForTheRobotsArmWhoseClampTurns) {
  expect_within(robot_arm(), {0.05, 0.02, 0.01});
}

TEST(MujocoAdvice, HoldsInMujocoInSpace) { expect_within(biaxial_bar(), {0.05, 0.02}); }

TEST(MujocoAdvice, HoldsInMujocoForADampedBarWithAMassAtItsEnd) {
  expect_within(damped_arm(), {0.05, 0.01});
}

}  // namespace
}  // namespace plastica::testing

#endif
