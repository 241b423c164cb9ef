#include "sweeps/advise/for_engine/body_chain.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "calibrate/engine/engine_world.hpp"
#include "calibrate/engine/hinge_numbers.hpp"
#include "sweeps/advise/for_engine/hinge_chain.hpp"
#include "tests/calibrate/engine/engine_scenes.hpp"
#include "tests/support/message.hpp"
#include "tests/support/sanitized.hpp"
#include "tests/sweeps/advise/for_engine/dense_mates.hpp"

namespace plastica::testing {
namespace {

using sweeps::BodyChain;
using sweeps::HingeChain;
using sweeps::SegmentWrench;

const sweeps::AdvisedEngine& kChrono = *sweeps::advised_engine("chrono");
constexpr Vec<double, 3> kDown{{0.0, -9.81, 0.0}};

/// The difference of all velocities and places between a chain and the dense step, over the
/// largest velocity.
double difference(const BodyChain& chain, const DenseMates& dense) {
  double off = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const DenseBody& body = dense.body(i);
    const Eigen::Vector3d arm = body.turn * body.center;
    const Eigen::Vector3d spin = body.turn * body.spin;
    const Eigen::Vector3d velocity = body.velocity - spin.cross(arm);
    const Eigen::Matrix3d frame = body.turn.toRotationMatrix();
    const sweeps::SegmentPose& pose = chain.pose(i);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      off = std::max({off, std::abs(velocity[row] - pose.velocity[k]),
                      std::abs(spin[row] - pose.spin[k]),
                      std::abs((body.position - arm)[row] - pose.position[k])});
      largest = std::max({largest, std::abs(velocity[row]), std::abs(spin[row])});
      for (std::size_t c = 0; c < 3; ++c) {
        off = std::max(off, std::abs(frame(row, static_cast<Eigen::Index>(c)) - pose.frame(k, c)));
      }
    }
  }
  return off / largest;
}

/// Runs a chain under a force and a moment at its tip, and steps both ways every now and then.
/// @param spin  about x, of the whole beam at the beginning [rad/s]
/// @return the largest difference; the largest C/h into `recovery`
double dense_difference(const calibrate::EngineBeam& beam, int steps, double& recovery,
                        double spin = 0.0) {
  BodyChain chain(kChrono, beam);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Vec<double, 3> all{{spin, 0.0, 0.0}};
    chain.set_motion(i, cross(all, chain.pose(i).position), all);
  }
  DenseMates dense(beam, calibrate::kChronoDampingFraction);
  const std::size_t last = chain.size() - 1;
  double off = 0.0;
  for (int n = 0; n < steps; ++n) {
    std::vector<SegmentWrench> wrenches(chain.size());
    wrenches[last].force = {{0.3, 0.1 * std::sin(0.3 * n), -0.2}};
    wrenches[last].moment = {{0.01, -0.02, 0.03}};
    std::vector<Eigen::Vector3d> forces(chain.size(), Eigen::Vector3d::Zero());
    std::vector<Eigen::Vector3d> moments = forces;
    const bool compares = n % 10 == 0 || n + 3 > steps;
    if (compares) {
      dense.take(chain);
      forces[last] = DenseMates::vector(wrenches[last].force.at);
      moments[last] = DenseMates::vector(wrenches[last].moment.at) -
                      (dense.body(last).turn * dense.body(last).center).cross(forces[last]);
      dense.step({0.0, -9.81, 0.0}, forces, moments);
      recovery = std::max(recovery, dense.largest_recovery());
    }
    EXPECT_TRUE(chain.step(kDown, wrenches));
    if (compares) off = std::max(off, difference(chain, dense));
  }
  ::testing::Test::RecordProperty("difference", fmt::format("{:.2e}", off));
  return off;
}

calibrate::EngineBeam soft_beam(int segments, double time_step, double damping_time = 0.0) {
  Scene scene = soft_strip(segments);
  scene.section.height = 0.03;
  calibrate::EngineBeam beam = beam_of(scene, {.time_step = time_step});
  calibrate::put_into({.damping_time = damping_time}, beam);
  return beam;
}

// The differences of the dense step leave 7e-12 at most.
constexpr double kOfDense = 1e-10;

TEST(BodyChain, StepsAsAllBodiesInOneMatrix) {
  double recovery = 0.0;
  EXPECT_LT(dense_difference(soft_beam(3, 2e-3), 31, recovery), kOfDense);
  EXPECT_LT(dense_difference(soft_beam(3, 2e-3, 0.02), 31, recovery), kOfDense);
  // So mates were open, and what closes them was compared as well.
  EXPECT_GT(recovery, 1e-4);
}

TEST(BodyChain, HoldsWhatAMateHolds) {
  calibrate::EngineBeam beam = soft_beam(3, 2e-3, 0.01);
  beam.joints[1].rotation[1] = calibrate::JointHold::Rigid;
  beam.joints[1].stiffness[1] = 0.0;
  beam.joints[2].rotation = {calibrate::JointHold::Rigid, calibrate::JointHold::Free,
                             calibrate::JointHold::Rigid};
  beam.joints[2].stiffness = {};
  beam.joints[0].holds = {true, true, false};  // it slides along its axis
  double recovery = 0.0;
  EXPECT_LT(dense_difference(beam, 31, recovery), kOfDense);
}

TEST(BodyChain, ClosesMatesNoFasterThanChronoDoes) {
  // Steps that are long for how fast it turns.
  double recovery = 0.0;
  EXPECT_LT(dense_difference(soft_beam(3, 0.02), 10, recovery, 20.0), kOfDense);
  EXPECT_GT(recovery, 0.6);
}

/// One rigid bar of which a spring at its start holds the turn about x; small turns.
struct Oscillator {
  explicit Oscillator(double time_step, double damping_time)
      : beam(beam_of(cantilever_scene(1), {.time_step = time_step})) {
    calibrate::put_into({.damping_time = damping_time}, beam);
    const calibrate::EngineSegment& segment = beam.segments[0];
    inertia = segment.inertia[0] + segment.mass * segment.length * segment.length / 4.0;
    stiffness = beam.joints[0].stiffness[0];
  }
  calibrate::EngineBeam beam;
  double inertia = 0.0, stiffness = 0.0;
};

/// Turns and speeds about x, after each step from a spin, over the spin.
std::vector<std::array<double, 2>> swings(const calibrate::EngineBeam& beam, int steps,
                                          const Vec<double, 3>& gravity = {}) {
  constexpr double kSpin = 1e-6;
  BodyChain chain(kChrono, beam);
  chain.set_motion(0, {}, {{kSpin, 0.0, 0.0}});
  const std::vector<SegmentWrench> none(1);
  std::vector<std::array<double, 2>> found;
  for (int n = 0; n < steps; ++n) {
    EXPECT_TRUE(chain.step(gravity, none));
    const sweeps::SegmentPose& pose = chain.pose(0);
    found.push_back({std::asin(pose.frame(2, 1)) / kSpin, pose.spin[0] / kSpin});
  }
  return found;
}

TEST(BodyChain, DampsAnOscillatorAsImplicitEuler) {
  // q_n is a sine of n phi times a^n: a = (1 + s)^-1/2, phi = atan s^1/2, s = (h w)^2.
  for (const double hw : {0.01, 0.3, 5.0}) {
    SCOPED_TRACE(hw);
    Oscillator one(1e-3, 0.0);
    one.beam.time_step = hw / std::sqrt(one.stiffness / one.inertia);
    const double a = 1.0 / std::sqrt(1.0 + hw * hw);
    const double phi = std::atan(hw);
    const auto found = swings(one.beam, 30);
    for (std::size_t n = 1; n <= found.size(); ++n) {
      const double steps = static_cast<double>(n);
      // From q = 0 and v = 1: v_1 = 1/(1 + s), q_1 = h v_1.
      const double exact = one.beam.time_step / hw * std::pow(a, steps) * std::sin(steps * phi);
      EXPECT_NEAR(found[n - 1][0], exact, 1e-9 * one.beam.time_step / hw) << n;
    }
  }
}

TEST(BodyChain, DampsAsTheSceneWithHalfOfItsDampingInTheBushing) {
  // (I + h c/2 + h^2 k) v' = (I - h c/2) v - h k q: the trapezoidal rule of the damper.
  constexpr double kStep = 1e-3;
  const Oscillator one(kStep, 5e-3);
  const double damping = 5e-3 * one.stiffness;
  double q = 0.0;
  double v = 1.0;
  const auto found = swings(one.beam, 100);
  for (const auto& at : found) {
    v = ((one.inertia - 0.5 * kStep * damping) * v - kStep * one.stiffness * q) /
        (one.inertia + 0.5 * kStep * damping + kStep * kStep * one.stiffness);
    q += kStep * v;
    ASSERT_NEAR(at[0], q, 1e-9 * kStep);
    ASSERT_NEAR(at[1], v, 1e-9);
  }
  // The decay is the scene's, as the step goes to 0: exp(-c t/2 I) of the envelope.
  const Oscillator fine(2e-6, 1e-5);
  const double omega = std::sqrt(fine.stiffness / fine.inertia);
  const double rate = 0.5 * 1e-5 * fine.stiffness / fine.inertia;
  const auto decays = swings(fine.beam, 20'000);
  const double size = std::hypot(omega * decays.back()[0], decays.back()[1]);
  const double time = 20'000 * 2e-6;
  // Implicit Euler itself damps by w^2 h t/2; what remains is of the phase: 2 rate/w.
  const double exact = std::exp(-(rate + 0.5 * omega * omega * 2e-6) * time);
  EXPECT_NEAR(size / exact, 1.0, 0.02);
}

TEST(BodyChain, SwingsAsARigidPendulum) {
  // From level to straight down: (I/m g l)^1/2 K(1/2^1/2), K = 1.8540746773.
  Scene scene = cantilever_scene(1);
  scene.supports[0].kind = SupportKind::Pin;
  std::vector<double> off;
  for (const int steps : {500, 1000, 2000}) {
    calibrate::EngineBeam beam = beam_of(scene);
    const calibrate::EngineSegment& segment = beam.segments[0];
    const double arm = 0.5 * segment.length;
    const double inertia = segment.inertia[0] + segment.mass * arm * arm;
    const double quarter = 1.8540746773013719 * std::sqrt(inertia / (segment.mass * 9.81 * arm));
    beam.time_step = quarter / steps;
    BodyChain chain(kChrono, beam);
    const std::vector<SegmentWrench> none(1);
    for (int n = 0; n < steps; ++n) ASSERT_TRUE(chain.step(kDown, none));
    // Its axis points down; the speed is that of the energy.
    const sweeps::SegmentPose& pose = chain.pose(0);
    EXPECT_NEAR(pose.frame(1, 2), -1.0, 1e-4);
    off.push_back(pose.frame(2, 2));
    EXPECT_NEAR(pose.spin[0], std::sqrt(2.0 * segment.mass * 9.81 * arm / inertia), 5.0 / steps);
  }
  EXPECT_NEAR(off[0] / off[1], 2.0, 0.1);
  EXPECT_NEAR(off[1] / off[2], 2.0, 0.1);
  EXPECT_LT(std::abs(off[2]), 2e-3);
}

/// How far the tip is from Bullet's after 20 ms under gravity, over its way.
double off_hinges(double time_step, double damping_time) {
  Scene scene = cantilever_scene(4);
  scene.material.youngs_modulus = 1e9;
  calibrate::EngineBeam beam = beam_of(scene, {.time_step = time_step});
  calibrate::put_into({.damping_time = damping_time}, beam);
  BodyChain chain(kChrono, beam);
  HingeChain hinges(*sweeps::advised_engine("bullet"), beam, {true, false, false});
  const std::vector<SegmentWrench> none(4);
  const long steps = std::lround(0.02 / time_step);
  for (long n = 0; n < steps; ++n) {
    EXPECT_TRUE(chain.step(kDown, none));
    EXPECT_TRUE(hinges.step(kDown, none));
  }
  const Vec<double, 3> end{{0.0, 0.0, 0.25}};
  return (chain.point(3, end)[1] - hinges.point(3, end)[1]) / hinges.point(3, end)[1];
}

TEST(BodyChain, ComesToWhatHingesDoAsTheStepGoesToNothing) {
  // The dampers' rate is 1e-4 s: of the same order as the motion's, so that the factor of the
  // bushings' damping shows.
  for (const double damping_time : {0.0, 3e-3}) {
    if (kSanitized && damping_time == 0.0) continue;
    SCOPED_TRACE(damping_time);
    const double coarse = off_hinges(2e-5, damping_time);
    const double fine = off_hinges(1e-5, damping_time);
    EXPECT_NEAR(coarse / fine, 2.0, 0.1);
    EXPECT_LT(std::abs(fine), 2e-3);
  }
}

TEST(BodyChain, KeepsItsMatesClosed) {
  const calibrate::EngineBeam beam = soft_beam(4, 2e-3);
  BodyChain chain(kChrono, beam);
  const std::vector<SegmentWrench> none(4);
  const auto gap = [&] {
    double largest = std::sqrt(dot(chain.pose(0).position, chain.pose(0).position));
    for (std::size_t i = 1; i < 4; ++i) {
      const Vec<double, 3> apart =
          chain.point(i - 1, {{0.0, 0.0, beam.segments[i - 1].length}}) - chain.pose(i).position;
      largest = std::max(largest, std::sqrt(dot(apart, apart)));
    }
    return largest;
  };
  double early = 0.0;
  double late = 0.0;
  for (int n = 0; n < (kSanitized ? 2'000 : 10'000); ++n) {
    // Gravity that turns keeps it going.
    const double angle = 0.02 * n;
    ASSERT_TRUE(chain.step({{9.81 * std::sin(angle), -9.81 * std::cos(angle), 0.0}}, none));
    double& most = n < 1000 ? early : late;
    most = std::max(most, gap());
  }
  EXPECT_GT(early, 1e-7);
  EXPECT_LT(late, 2.0 * early);
  EXPECT_LT(late, 1e-3);
}

TEST(BodyChain, FollowsAGroundThatTurns) {
  // The rule itself damps the swings about where the spring is at rest.
  const calibrate::EngineBeam beam = beam_of(cantilever_scene(1), {.time_step = 1e-2});
  BodyChain chain(kChrono, beam);
  chain.set_rest(0, 0.3);
  const std::vector<SegmentWrench> none(1);
  for (int n = 0; n < 1000; ++n) ASSERT_TRUE(chain.step({}, none));
  EXPECT_NEAR(std::asin(chain.pose(0).frame(2, 1)), 0.3, 1e-9);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(chain.pose(0).position[k], 0.0, 1e-9);
}

TEST(BodyChain, GivesUpWhereNothingIsFinite) {
  BodyChain chain(kChrono, soft_beam(2, 1e-3));
  std::vector<SegmentWrench> wrenches(2);
  EXPECT_TRUE(chain.step(kDown, wrenches));
  wrenches[1].moment = {{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}};
  EXPECT_FALSE(chain.step(kDown, wrenches));
}

TEST(BodyChain, RefusesWhatIsNoChainOnTheGround) {
  Scene held_twice = cantilever_scene(4);
  held_twice.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  EXPECT_EQ(message_of([&] { (void)BodyChain(kChrono, beam_of(held_twice)); }),
            "support_2: is off the beam's start");
  EXPECT_EQ(message_of([&] { (void)BodyChain(kChrono, beam_of(chain_scene(4))); }),
            "support: is missing: nothing holds the beam at its start");
}

}  // namespace
}  // namespace plastica::testing
