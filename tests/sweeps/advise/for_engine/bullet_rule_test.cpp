#include <gtest/gtest.h>

#ifdef PLASTICA_HAS_BULLET

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "plastica/run/path_stops.hpp"
#include "sweeps/advise/for_engine/engine_loads.hpp"
#include "sweeps/advise/for_engine/hinge_chain.hpp"
#include "tests/calibrate/engine/engine_scenes.hpp"
#include "tests/sweeps/advise/for_engine/bullet_beam.hpp"
#include "tests/sweeps/advise/for_engine/engine_advice_scenes.hpp"
#include "tests/sweeps/advise/for_engine/engine_truth.hpp"

/// Bullet itself says whether our rule of it is its own, and whether its beams are.
namespace plastica::testing {
namespace {

constexpr double kRounding = 1e-10;

/// What acts on a scene's beam in each step; one load at most, without moment, not spread.
std::vector<BulletStep> steps_of(const Scene& scene, double time_step, int count) {
  std::vector<BulletStep> steps(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    BulletStep& step = steps[static_cast<std::size_t>(i)];
    const double time = i * time_step;
    for (std::size_t k = 0; k < 3; ++k) {
      step.gravity[k] = scene.gravity[k] * scene.gravity_history.at(time);
      for (const Load& load : scene.loads) {
        step.force[k] += load.force[k] * load.history.at(time);
        step.moment[k] += load.moment[k] * load.history.at(time);
      }
      for (const Support& support : scene.supports) {
        step.turned[k] += support.rotation[k] * support.history.at(time);
      }
    }
  }
  return steps;
}

/// Where a load acts: on the segment before it.
struct LoadedPlace {
  std::size_t segment;
  double along;
};

LoadedPlace loaded_place(const Scene& scene, const calibrate::EngineBeam& beam) {
  const double fraction = scene.loads.empty() ? 1.0 : scene.loads.front().at.fraction;
  double begin = 0.0;
  for (std::size_t i = 0;; ++i) {
    const double end = begin + beam.segments[i].length / scene.beam.length;
    if (fraction <= end + 1e-12 || i + 1 == beam.segments.size()) {
      return {i, (fraction - begin) * scene.beam.length};
    }
    begin = end;
  }
}

/// The largest difference of a coordinate of Bullet's over the largest coordinate, at any step.
double rule_error(const Scene& scene, const SolverOptions& solver, int count) {
  const calibrate::EngineBeam beam = calibrate::engine_beam(scene, solver);
  const LoadedPlace place = loaded_place(scene, beam);
  const std::vector<BulletState> theirs =
      BulletBeam(beam).states(steps_of(scene, beam.time_step, count), place.segment, place.along);
  sweeps::HingeChain chain(*sweeps::advised_engine("bullet"), beam, {true, true, true});
  const sweeps::EngineLoads loads(scene, beam);
  std::vector<sweeps::SegmentWrench> wrenches;
  double largest = 0.0;
  double error = 0.0;
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    const double time = static_cast<double>(i) * beam.time_step;
    const Vec<double, 3> turned = loads.ground_rotation(time);
    for (std::size_t k = 0; k < 3; ++k) chain.set_rest(k, turned[k]);
    loads.gather(chain, time, wrenches);
    EXPECT_TRUE(chain.step(loads.gravity(time), wrenches));
    if (theirs[i].coordinates.size() != chain.freedoms()) {
      ADD_FAILURE() << theirs[i].coordinates.size() << " links, " << chain.freedoms();
      return INFINITY;
    }
    for (std::size_t j = 0; j < chain.freedoms(); ++j) {
      largest = std::max(largest, std::abs(theirs[i].coordinates[j]));
      error = std::max(error, std::abs(theirs[i].coordinates[j] - chain.coordinate(j)));
    }
  }
  EXPECT_GT(largest, 1e-3);
  const double chord = scene.beam.length / static_cast<double>(chain.size());
  const Vec<double, 3> tip = chain.point(chain.size() - 1, {{0.0, 0.0, chord}});
  for (std::size_t k = 0; k < 3; ++k) {
    error = std::max(error, largest * std::abs(tip[k] - theirs.back().tip[k]) / scene.beam.length);
  }
  ::testing::Test::RecordProperty("error", fmt::format("{:.2e}", error / largest));
  return error / largest;
}

TEST(BulletRule, IsBulletsOfAStripThatFallsFar) {
  EXPECT_LT(rule_error(soft_strip(12), {.time_step = 2e-5}, 3000), kRounding);
}

TEST(BulletRule, IsBulletsInSpaceUnderAForceThatSwings) {
  Scene scene = soft_strip(6);
  scene.section.height = 0.03;
  scene.loads.push_back({.at = Place::end(),
                         .force = {1.0, 0.5, -2.0},
                         .moment = {0.0, 0.02, 0.1},
                         .history = History::sine(0.02, 3.0)});
  EXPECT_LT(rule_error(scene, {.time_step = 2e-5}, 2000), kRounding);
}

TEST(BulletRule, IsBulletsWithDampingAndMasses) {
  Scene scene = soft_strip(5);
  scene.masses.push_back({.at = Place::end(), .mass = 0.2, .inertia = {1e-4, 2e-4, 3e-4}});
  scene.masses.push_back({.at = {0.4, {}}, .mass = 0.1});
  EXPECT_LT(rule_error(scene,
                       {.analysis = Analysis::Dynamics,
                        .time_step = 2e-5,
                        .damping = Damping::Stiffness,
                        .damping_time = 1e-4},
                       2000),
            kRounding);
}

TEST(BulletRule, IsBulletsOfStartsThatTurnAndSlide) {
  Scene scene = soft_strip(4);
  scene.supports[0].kind = SupportKind::Roller;
  EXPECT_LT(rule_error(scene, {.time_step = 2e-5}, 1500), kRounding);
}

Histories run_in_bullet(const plastica::Setup& setup, const sweeps::EngineAdvice& advice) {
  const Scene& scene = setup.scene;
  const int per_sample = advice.setting.steps;
  const LoadedPlace place = loaded_place(scene, advice.beam);
  const std::vector<BulletState> states =
      BulletBeam(advice.beam)
          .states(steps_of(scene, advice.time_step, setup.solver.steps * per_sample), place.segment,
                  place.along);
  Histories histories;
  for (const Probe& probe : scene.probes) {
    std::vector<double> history{0.0};
    for (int sample = 1; sample <= setup.solver.steps; ++sample) {
      std::array<double, 3> moved = states[static_cast<std::size_t>(sample * per_sample - 1)].tip;
      moved[2] -= scene.beam.length;
      history.push_back(probe.component == Component::Size
                            ? std::hypot(moved[0], moved[1], moved[2])
                            : moved[static_cast<std::size_t>(probe.component)]);
    }
    histories.push_back(std::move(history));
  }
  return histories;
}

void expect_within_in_bullet(const std::string& text, const std::vector<double>& errors) {
  expect_within("bullet", text, errors, run_in_bullet);
}

TEST(BulletAdvice, HoldsInBulletForAStripThatIsLetGo) {
  expect_within_in_bullet(released_strip(), {0.05, 0.02});
}

TEST(BulletAdvice, HoldsInBulletForTheRobotsArmWhoseClampTurns) {
  expect_within_in_bullet(robot_arm(), {0.05, 0.02, 0.01});
}

TEST(BulletAdvice, HoldsInBulletInSpace) { expect_within_in_bullet(biaxial_bar(), {0.05, 0.02}); }

// Explicit dampers ask for steps below 2/(time w^2), so less of them than in MuJoCo.
TEST(BulletAdvice, HoldsInBulletForADampedBarWithAMassAtItsEnd) {
  expect_within_in_bullet(damped_arm("0.1 ms"), {0.05, 0.02});
}

}  // namespace
}  // namespace plastica::testing

#else

TEST(BulletRule, NeedsBullet) {
  GTEST_SKIP() << "Bullet is not installed in double precision (apt-get install libbullet-dev)";
}

#endif
