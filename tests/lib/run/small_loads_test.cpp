#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "tests/support/motion_scene.hpp"
#include "tests/support/tolerance.hpp"

// Loads that short steps leave far below m L/h^2, the force that moves a beam by its length in a
// step: they move it as large ones do, for all of this is linear.

namespace plastica {
namespace {

using testing::add_probe;
using testing::cantilever_scene;
using testing::last_of;
using testing::motion_options;

constexpr std::array kImplicit{Scheme::LinearlyImplicitEuler, Scheme::LinearlyImplicitMidpoint,
                               Scheme::GeneralizedAlpha, Scheme::EnergyMomentum};

/// A steel bar that a load at its end moves from rest.
Scene loaded_bar(std::array<double, 3> force, std::array<double, 3> moment,
                 const History& history) {
  Scene scene = cantilever_scene(12);
  scene.material.density = 7850.0;
  scene.yield_model = YieldModel::Elastic;
  Load load;
  load.force = force;
  load.moment = moment;
  load.history = history;
  scene.loads = {load};
  return scene;
}

History ramp_over(double time) {
  History ramp;
  ramp.time = {0.0, time};
  ramp.factor = {0.0, 1.0};
  return ramp;
}

double last_twist(double moment, Level level, SolverOptions options, const History& history) {
  Scene scene = loaded_bar({}, {0.0, 0.0, moment}, history);
  add_probe(scene, ProbeQuantity::Rotation, {1.0, {}}, Component::Z);
  options.level = level;
  const Response response = simulate(scene, options);
  EXPECT_EQ(response.status, Status::Completed);
  return last_of(response, 0);
}

/// What translations' rounding would hide: the twist of a bar in space is that of one that knows
/// nothing but twist.
TEST(SmallLoads, TwistABarInSpaceAsAShaft) {
  for (const Scheme scheme : kImplicit) {
    const SolverOptions options = motion_options(scheme, 1e-6, 200);
    for (const History& history : {History::constant(), ramp_over(1e-4)}) {
      for (const double moment : {1.0, 0.03, 1e-6}) {
        const double shaft = last_twist(moment, Level::Twist, options, history);
        const double bar = last_twist(moment, Level::Spatial, options, history);
        EXPECT_GT(shaft, 0.0);
        EXPECT_NEAR(bar / shaft, 1.0, testing::tolerance(1e-7)) << int(scheme) << ' ' << moment;
      }
    }
  }
}

/// Before the wave of a torque M is back from the clamp, the end turns as that of a bar without
/// another end: at the speed M/sqrt(rho I_p G J).
TEST(SmallLoads, TurnAnEndAsAWaveThatRunsAlong) {
  for (const double moment : {1.0, 0.01, 1e-6}) {
    Scene bar = loaded_bar({}, {0.0, 0.0, moment}, History::constant());
    bar.beam.segments = 96;
    add_probe(bar, ProbeQuantity::Rotation, {1.0, {}}, Component::Z);
    SolverOptions options = motion_options(Scheme::GeneralizedAlpha, 1e-6, 200);
    options.level = Level::Spatial;
    const SectionProperties p = testing::properties_of(bar);
    const double shear = bar.material.youngs_modulus / (2.0 * (1.0 + bar.material.poisson_ratio));
    const double polar = p.second_moment_x + p.second_moment_y;
    const double impedance = std::sqrt(bar.material.density * polar * shear * p.torsion_constant);
    const double turned = last_of(simulate(bar, options), 0);
    EXPECT_NEAR(turned / (moment / impedance * options.duration), 1.0, testing::tolerance(1e-6))
        << moment;
  }
}

/// The angles of a shaft that goes on turning grow, and with them their rounding over h^2.
TEST(SmallLoads, LetAShaftTurnForLong) {
  Scene shaft = loaded_bar({}, {}, ramp_over(2.0));
  shaft.loads.clear();
  shaft.beam.segments = 8;
  shaft.supports[0].rotation = {0.0, 0.0, 600.0};
  shaft.supports[0].history = ramp_over(2.0);
  add_probe(shaft, ProbeQuantity::Rotation, {1.0, {}}, Component::Z);
  SolverOptions options = motion_options(Scheme::GeneralizedAlpha, 1e-4, 20000);
  options.level = Level::Twist;
  const Response response = simulate(shaft, options);
  EXPECT_EQ(response.status, Status::Completed);
  // It swings about by what it lagged behind at first: its speed over its lowest frequency.
  EXPECT_NEAR(last_of(response, 0), 600.0, 0.1);
}

/// A hundredth of a load bends by a hundredth, as far as the rounding of places over the square of
/// the step lets it.
TEST(SmallLoads, BendInProportion) {
  for (const Scheme scheme : kImplicit) {
    for (const History& history : {History::constant(), ramp_over(1e-4)}) {
      const auto tip = [&](double force) {
        Scene scene = loaded_bar({0.0, force, 0.0}, {}, history);
        add_probe(scene, ProbeQuantity::Displacement, {1.0, {}}, Component::Y);
        return last_of(simulate(scene, motion_options(scheme, 1e-6, 200)), 0);
      };
      EXPECT_NEAR(tip(0.02) / tip(2.0), 0.01, testing::tolerance(1e-5)) << int(scheme);
    }
  }
}

/// A free bar takes up the impulse of what pushes it.
TEST(SmallLoads, PushAFreeBar) {
  for (const Scheme scheme : kImplicit) {
    Scene scene = loaded_bar({0.0, 0.02, 0.0}, {}, History::constant());
    scene.supports.clear();
    add_probe(scene, ProbeQuantity::Momentum, {}, Component::Y);
    const SolverOptions options = motion_options(scheme, 1e-6, 200);
    const double impulse = 0.02 * options.duration;
    EXPECT_NEAR(last_of(simulate(scene, options), 0) / impulse, 1.0, testing::tolerance(1e-4))
        << int(scheme);
  }
}

/// A twist moves no axis: steps that follow an error see it all the same, as those of a shaft.
TEST(SmallLoads, TwistIsSeenByTheErrorOfSteps) {
  SolverOptions options = motion_options(Scheme::GeneralizedAlpha, 1e-4, 20);
  const double exact = last_twist(10.0, Level::Twist, motion_options(options.scheme, 1e-6, 2000),
                                  History::constant());
  double before = 1.0;
  for (const double error : {1e-4, 1e-6, 1e-8}) {
    options.step_error = error;
    const double bar = last_twist(10.0, Level::Spatial, options, History::constant());
    EXPECT_NEAR(bar, last_twist(10.0, Level::Twist, options, History::constant()),
                testing::tolerance(1e-6 * std::fabs(exact)));
    const double off = std::fabs(bar / exact - 1.0);
    EXPECT_LT(off, 0.5 * before) << error;
    before = off;
  }
  EXPECT_LT(before, 0.005);
}

}  // namespace
}  // namespace plastica
