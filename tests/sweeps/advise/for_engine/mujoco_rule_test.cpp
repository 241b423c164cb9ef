#include <gtest/gtest.h>

#ifdef PLASTICA_HAS_MUJOCO

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "calibrate/engine/engine_world.hpp"
#include "sweeps/advise/for_engine/engine_loads.hpp"
#include "sweeps/advise/for_engine/hinge_chain.hpp"
#include "tests/calibrate/engine/engine_scenes.hpp"
#include "tests/sweeps/advise/for_engine/mujoco_scene.hpp"

/// MuJoCo itself says whether our rule of it is its own.
namespace plastica::testing {
namespace {

struct RuleCase {
  Scene scene;
  SolverOptions solver{};
  int steps = 400;
  std::array<bool, 3> turns{true, true, true};
};

/// The largest difference of a coordinate of MuJoCo's over the largest coordinate, at any step.
double rule_error(const RuleCase& one) {
  const calibrate::EngineBeam beam = calibrate::engine_beam(one.scene, one.solver);
  MujocoScene mujoco(one.scene, beam);
  sweeps::HingeChain chain(*sweeps::advised_engine("mujoco"), beam, one.turns);
  const sweeps::EngineLoads loads(one.scene, beam);
  std::vector<sweeps::SegmentWrench> wrenches;
  double largest = 0.0;
  double error = 0.0;
  // The chain's freedoms are MuJoCo's, in its order, or every third of them.
  const std::size_t every = static_cast<std::size_t>(mujoco.model().nv) / chain.freedoms();
  const auto first = static_cast<std::size_t>(
      every == 1 ? 0 : std::ranges::find(one.turns, true) - one.turns.begin());
  for (int i = 0; i < one.steps; ++i) {
    const double time = i * beam.time_step;
    loads.gather(chain, time, wrenches);
    EXPECT_TRUE(chain.step(loads.gravity(time), wrenches));
    mujoco.step();
    for (std::size_t j = 0; j < chain.freedoms(); ++j) {
      const double theirs = mujoco.data().qpos[first + every * j];
      largest = std::max(largest, std::abs(theirs));
      error = std::max(error, std::abs(theirs - chain.coordinate(j)));
    }
  }
  const double length = one.scene.beam.length;
  const std::size_t last = chain.size() - 1;
  const double chord = distance(beam.segments[last].start, beam.segments[last].end);
  const Point theirs = mujoco.place(1.0);
  const Point ours = chain.point(last, {{0.0, 0.0, chord}}).at;
  const double tip = distance(theirs, ours) / length;
  ::testing::Test::RecordProperty("tip_m", std::to_string(length_of(theirs)));
  EXPECT_GT(largest, 1e-3);
  return std::max(tip, error / largest);
}

constexpr double kRounding = 1e-11;

TEST(MujocoRule, IsMujocosOfAStripThatFallsFar) {
  RuleCase one{soft_strip(16), {.time_step = 1e-3}};
  EXPECT_LT(rule_error(one), kRounding);
  one.turns = {true, false, false};
  EXPECT_LT(rule_error(one), kRounding);
}

TEST(MujocoRule, IsMujocosInSpace) {
  RuleCase one{soft_strip(12), {.time_step = 1e-3}};
  one.scene.section.height = 0.03;
  one.scene.loads.push_back({.at = Place::end(),
                             .force = {1.0, 0.5, -2.0},
                             .moment = {0.0, 0.02, 0.1},
                             .history = History::sine(0.2, 3.0)});
  EXPECT_LT(rule_error(one), kRounding);
}

TEST(MujocoRule, IsMujocosUnderSpreadFollowingAndPassingLoads) {
  RuleCase one{soft_strip(10), {.time_step = 5e-4}};
  one.scene.gravity = {0.0, -9.81, 3.0};
  one.scene.gravity_history = History::smooth_step(0.0, 0.1);
  one.scene.loads.push_back({.at = {0.27, {}},
                             .to = Place{0.83, {}},
                             .force = {0.4, 2.0, 0.0},
                             .history = History::turning_points({1.0, 0.0})});
  one.scene.loads.push_back({.at = {0.55, {}},
                             .force = {0.0, 1.5, 0.3},
                             .moment = {0.05, 0.0, 0.0},
                             .follows = true,
                             .history = History::constant()});
  EXPECT_LT(rule_error(one), kRounding);
}

TEST(MujocoRule, IsMujocosWhereLoadsActAtJoints) {
  RuleCase one{soft_strip(10), {.time_step = 5e-4}};
  one.scene.loads.push_back({.at = {0.3, {}},
                             .force = {0.2, 1.0, 0.0},
                             .moment = {0.05, 0.02, 0.01},
                             .history = History::constant()});
  one.scene.loads.push_back({.at = {0.7, {}},
                             .force = {0.0, 1.0, 0.5},
                             .moment = {-0.05, 0.0, 0.0},
                             .follows = true,
                             .history = History::constant()});
  EXPECT_LT(rule_error(one), kRounding);
}

TEST(MujocoRule, IsMujocosWithTheHingesOfAPlaneAlone) {
  RuleCase across{soft_strip(10), {.time_step = 1e-3}, 400, {false, true, false}};
  across.scene.gravity = {9.81, 0.0, 0.0};
  EXPECT_LT(rule_error(across), kRounding);
  RuleCase twisted{soft_strip(10), {.time_step = 1e-5}, 400, {false, false, true}};
  twisted.scene.gravity = {};
  twisted.scene.loads.push_back(
      {.at = Place::end(), .moment = {0.0, 0.0, 0.05}, .history = History::constant()});
  EXPECT_LT(rule_error(twisted), kRounding);
}

TEST(MujocoRule, IsMujocosWithDampingAndMasses) {
  for (const double damping : {0.0, 1e-4, 2e-2}) {
    SCOPED_TRACE(damping);
    RuleCase one{soft_strip(8),
                 {.analysis = Analysis::Dynamics,
                  .time_step = 2e-3,
                  .damping = Damping::Stiffness,
                  .damping_time = damping}};
    one.scene.masses.push_back({.at = Place::end(), .mass = 0.2, .inertia = {1e-4, 2e-4, 3e-4}});
    one.scene.masses.push_back({.at = {0.4, {}}, .mass = 0.1});
    EXPECT_LT(rule_error(one), kRounding);
  }
}

TEST(MujocoRule, IsMujocosOfOtherStartsAndShapes) {
  RuleCase pinned{soft_strip(9), {.time_step = 1e-3}, 300};
  pinned.scene.supports[0].kind = SupportKind::Pin;
  EXPECT_LT(rule_error(pinned), kRounding);
  RuleCase rolling = pinned;
  rolling.scene.supports[0].kind = SupportKind::Roller;
  rolling.scene.loads.push_back(
      {.at = {0.5, {}}, .force = {0.3, 0.0, 0.7}, .history = History::constant()});
  EXPECT_LT(rule_error(rolling), kRounding);
  RuleCase rigid{soft_strip(9), {.time_step = 1e-3}, 300};
  rigid.scene.end_rule = EndRule::Equal;
  EXPECT_LT(rule_error(rigid), kRounding);
  RuleCase arc{soft_strip(9), {.time_step = 1e-3}, 300};
  arc.scene.beam.shape = BeamShape::Arc;
  arc.scene.beam.arc_angle = 1.2;
  arc.scene.beam.arc_towards = {1.0, 0.0, 0.0};
  EXPECT_LT(rule_error(arc), kRounding);
}

}  // namespace
}  // namespace plastica::testing

#else

TEST(MujocoRule, NeedsMujoco) {
  GTEST_SKIP() << "MuJoCo is not installed (apt-get install libmujoco-dev)";
}

#endif
