#include "sweeps/advise/for_engine/hinge_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "calibrate/engine/engine_world.hpp"
#include "calibrate/engine/hinge_numbers.hpp"
#include "tests/calibrate/engine/engine_scenes.hpp"
#include "tests/support/message.hpp"

namespace plastica::testing {
namespace {

using sweeps::HingeChain;
using sweeps::SegmentWrench;

const sweeps::AdvisedEngine& kMujoco = *sweeps::advised_engine("mujoco");
constexpr std::array<bool, 3> kAboutX{true, false, false};

/// A cantilever for MuJoCo. @param damping  of its joints over their stiffness [s]
calibrate::EngineBeam cantilever_beam(int segments, double time_step, double damping) {
  calibrate::EngineBeam beam = beam_of(cantilever_scene(segments), {.time_step = time_step});
  calibrate::put_into({.damping_time = damping}, beam);
  return beam;
}

/// Of the inner end of a chain's only segment, about x [kg m^2].
double inertia_of(const calibrate::EngineSegment& segment) {
  return segment.inertia[0] + segment.mass * segment.length * segment.length / 4.0;
}

TEST(HingeChain, SwingsAsItsRuleInClosedForm) {
  // q'' - 2 q' + q = -h^2 w^2 q' of three steps in a row, from rest: turns by phi a step, where
  // cos phi = 1 - h^2 w^2/2, and q_n = q_0 (cos n phi - tan(phi/2) sin n phi).
  constexpr double kStep = 1e-4;
  const calibrate::EngineBeam beam = cantilever_beam(1, kStep, 0.0);
  const calibrate::EngineJoint& joint = beam.joints[0];
  const double inertia =
      inertia_of(beam.segments[0]) +
      calibrate::hinge_numbers(calibrate::HingeEngine::Mujoco, beam, joint, 0).armature;
  const double square = joint.stiffness[0] / inertia * kStep * kStep;
  const double phi = std::acos(1.0 - 0.5 * square);
  HingeChain chain(kMujoco, beam, kAboutX);
  chain.set_state(std::array{0.01}, std::array{0.0});
  const std::vector<SegmentWrench> none(1);
  for (int n = 1; n <= 2000; ++n) {
    ASSERT_TRUE(chain.step({}, none));
    const double exact = 0.01 * (std::cos(n * phi) - std::tan(0.5 * phi) * std::sin(n * phi));
    ASSERT_NEAR(chain.coordinate(0), exact, 1e-12) << n;
  }
}

TEST(HingeChain, TakesDampingImplicitly) {
  constexpr double kStep = 1e-3;
  const calibrate::EngineBeam beam = cantilever_beam(1, kStep, 5e-3);
  const calibrate::EngineJoint& joint = beam.joints[0];
  const double stiffness = joint.stiffness[0];
  const double damping = 5e-3 * stiffness;
  // Armature of such a joint: damping time x step x stiffness.
  const double inertia = inertia_of(beam.segments[0]) + damping * kStep;
  HingeChain chain(kMujoco, beam, kAboutX);
  chain.set_state(std::array{0.02}, std::array{1.0});
  double q = 0.02;
  double v = 1.0;
  const std::vector<SegmentWrench> none(1);
  for (int n = 0; n < 100; ++n) {
    ASSERT_TRUE(chain.step({}, none));
    v += kStep * (-stiffness * q - damping * v) / (inertia + kStep * damping);
    q += kStep * v;
    ASSERT_NEAR(chain.coordinate(0), q, 1e-15) << n;
  }
}

TEST(HingeChain, FallsAsAPendulumWhoseEnergyDoesNotDrift) {
  Scene scene = cantilever_scene(1);
  scene.supports[0].kind = SupportKind::Pin;
  calibrate::EngineBeam beam = beam_of(scene, {.time_step = 1e-3});
  HingeChain chain(kMujoco, beam, kAboutX);
  const double inertia = inertia_of(beam.segments[0]);
  const Vec<double, 3> gravity{{0.0, -9.81, 0.0}};
  const std::vector<SegmentWrench> none(1);
  const auto energy = [&] {
    const double height = chain.point(0, {{0.0, 0.0, 0.5}})[1];
    return 0.5 * inertia * chain.speed(0) * chain.speed(0) + beam.segments[0].mass * 9.81 * height;
  };
  const double most = beam.segments[0].mass * 9.81 * 0.5;
  double off = 0.0;
  for (int n = 0; n < 20'000; ++n) {
    ASSERT_TRUE(chain.step(gravity, none));
    off = std::max(off, std::abs(energy()));
  }
  // Of first order in the step, and no more after 20 s than in the first swing.
  EXPECT_LT(off, 0.01 * most);
  EXPECT_GT(off, 1e-4 * most);
}

/// Where the tip is after 0.1 s under gravity [m].
double fallen_tip(double time_step) {
  Scene scene = cantilever_scene(6);
  scene.material.youngs_modulus = 1e9;
  calibrate::EngineBeam beam = beam_of(scene, {.time_step = time_step});
  calibrate::put_into({.damping_time = 0.0}, beam);
  HingeChain chain(kMujoco, beam, kAboutX);
  const std::vector<SegmentWrench> none(6);
  const long steps = std::lround(0.1 / time_step);
  for (long n = 0; n < steps; ++n) chain.step({{0.0, -9.81, 0.0}}, none);
  return chain.point(5, {{0.0, 0.0, 1.0 / 6.0}})[1];
}

TEST(HingeChain, IsOfFirstOrder) {
  const double a = fallen_tip(2e-4);
  const double b = fallen_tip(1e-4);
  const double c = fallen_tip(5e-5);
  EXPECT_NEAR((a - b) / (b - c), 2.0, 0.1);
}

TEST(HingeChain, FollowsAGroundThatTurns) {
  // With much damping it comes to where the spring is at rest.
  calibrate::EngineBeam beam = cantilever_beam(1, 1e-3, 0.01);
  HingeChain chain(kMujoco, beam, kAboutX);
  chain.set_rest(0, 0.3);
  chain.set_rest(1, 0.7);  // no hinge about y moves
  const std::vector<SegmentWrench> none(1);
  for (int n = 0; n < 5000; ++n) chain.step({}, none);
  EXPECT_NEAR(chain.coordinate(0), 0.3, 1e-9);
}

TEST(HingeChain, GivesUpWhereMujocoDoes) {
  HingeChain chain(kMujoco, cantilever_beam(2, 1e-3, 0.0), kAboutX);
  std::vector<SegmentWrench> wrenches(2);
  EXPECT_TRUE(chain.step({}, wrenches));
  wrenches[1].moment = {{1e15, 0.0, 0.0}};
  EXPECT_FALSE(chain.step({}, wrenches));
  HingeChain other(kMujoco, cantilever_beam(2, 1e-3, 0.0), kAboutX);
  wrenches[1].moment = {{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}};
  EXPECT_FALSE(other.step({}, wrenches));
}

TEST(HingeChain, RefusesWhatIsNoChainOnTheGround) {
  Scene held_twice = cantilever_scene(4);
  held_twice.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  EXPECT_EQ(message_of([&] { HingeChain(kMujoco, beam_of(held_twice), kAboutX); }),
            "support_2: is off the beam's start");
  EXPECT_EQ(message_of([&] { HingeChain(kMujoco, beam_of(chain_scene(4)), kAboutX); }),
            "support: is missing: nothing holds the beam at its start");
}

}  // namespace
}  // namespace plastica::testing
