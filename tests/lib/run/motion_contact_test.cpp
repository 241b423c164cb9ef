#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/motion_scene.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica {
namespace {

using testing::add_probe;
using testing::last_energy;
using testing::motion_options;

/// A soft cantilever that falls by its weight onto a pillar 10 mm below its end.
Scene falling_scene(double restitution) {
  Scene scene = testing::cantilever_scene(12);
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  Support pillar{.at = Place::end(), .kind = SupportKind::Pillar};
  pillar.gap = 0.01;
  pillar.restitution = restitution;
  scene.supports.push_back(pillar);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Reaction, Place::end(), Component::Y);
  return scene;
}

class Contact : public ::testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, Contact,
                         ::testing::Values(Scheme::LinearlyImplicitEuler,
                                           Scheme::LinearlyImplicitMidpoint,
                                           Scheme::GeneralizedAlpha, Scheme::EnergyMomentum),
                         [](const auto& each) {
                           return "Scheme" + std::to_string(static_cast<int>(each.param));
                         });

TEST_P(Contact, IsNotCrossedAndDoesNotPull) {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    if (testing::kSanitized && restitution != 0.5) continue;
    const Response response =
        simulate(falling_scene(restitution),
                 motion_options(GetParam(), 1e-3, testing::kSanitized ? 200 : 400));
    ASSERT_EQ(response.status, Status::Completed);
    for (const double y : response.probes[0]) EXPECT_GE(y, -0.01 - 1e-7);
    for (const double force : response.probes[1]) EXPECT_GE(force, 0.0);
    EXPECT_LT(*std::min_element(response.probes[0].begin(), response.probes[0].end()), -0.009);
  }
}

TEST_P(Contact, LosesNothingWhenAllIsGivenBackAndMoreWhenNothingIs) {
  const auto lost = [&](double restitution) {
    return last_energy(simulate(falling_scene(restitution), motion_options(GetParam(), 2e-4, 500)))
        .impact;
  };
  // Velocities before an impact fit the joints to rounding.
  EXPECT_NEAR(lost(1.0), 0.0, 1e-5);
  EXPECT_GT(lost(0.0), 1e-3);
}

TEST(MotionContact, ThrowsASegmentBackByItsRestitution) {
  Scene scene = testing::chain_scene(1);
  scene.beam.segment_fractions = {1.0};  // no segment ends at the pillar
  scene.initial_motions.push_back({.velocity = {0.0, -1.0, 0.0}});
  Support pillar{.at = Place{0.5, {}}, .kind = SupportKind::Pillar};
  pillar.gap = 0.001;
  pillar.restitution = 0.6;
  scene.supports.push_back(pillar);
  add_probe(scene, ProbeQuantity::Velocity, Place{0.5, {}}, Component::Y);
  const Response response = simulate(scene, motion_options(Scheme::EnergyMomentum, 1e-4, 11));
  EXPECT_NEAR(response.probes[0][9], -1.0, 1e-9);
  EXPECT_NEAR(response.probes[0][11], 0.6, 1e-9);
  const double mass = 7850.0 * 0.02 * 0.02;
  EXPECT_NEAR(last_energy(response).impact, 0.5 * mass * (1.0 - 0.36), 1e-9);
}

TEST(MotionContact, MakesNoEnergyByRingingOnTwoPillars) {
  // A free steel beam that falls on them flat; its ends ring, and touch and leave many times.
  Scene scene = testing::chain_scene(16);
  InitialMotion falls;
  falls.velocity = {0.0, -0.315, 0.0};
  scene.initial_motions = {falls};
  for (const double at : {0.25, 1.0}) {
    Support pillar{.at = {at, {}}, .kind = SupportKind::Pillar};
    pillar.gap = 1e-3;
    pillar.restitution = 0.5;
    scene.supports.push_back(pillar);
  }
  const Response response = simulate(
      scene, motion_options(Scheme::GeneralizedAlpha, 1e-5, testing::kSanitized ? 600 : 2000));
  ASSERT_EQ(response.status, Status::Completed);
  EXPECT_GT(last_energy(response).impact, 0.05 * last_energy(response).external);
  EXPECT_LT(response.energy_balance_error, kBalanceTolerance);
}

/// A free rod of one segment, 3.14 kg.
Scene rod() {
  Scene scene = testing::chain_scene(1);
  scene.material.density = 7850.0;
  return scene;
}

Support moving_at_one(Support support) {
  support.translation = {0.0, 1.0, 0.0};
  support.history = {{0.0, 1.0}, {0.0, 1.0}};
  return support;
}

/// Two pillars strike a rod at rest: it leaves with (1 + e) v, of which 1/2 m (1 - e^2) v^2 was
/// lost of the work m (1 + e) v^2 of the pillars.
TEST_P(Contact, TellsTheWorkOfMovingPillarsFromWhatIsLost) {
  for (const double restitution : {0.0, 0.6, 1.0}) {
    Scene scene = rod();
    for (const Place& at : {Place::start(), Place::end()}) {
      Support pillar{.at = at, .kind = SupportKind::Pillar};
      pillar.gap = 0.01;
      pillar.restitution = restitution;
      scene.supports.push_back(moving_at_one(pillar));
    }
    const double mass = 7850.0 * 4e-4;
    const Energies energy = last_energy(simulate(scene, motion_options(GetParam(), 1e-3, 30)));
    const double lost = 0.5 * mass * (1.0 - restitution * restitution);
    EXPECT_NEAR(energy.impact, lost, 1e-6) << restitution;
    EXPECT_NEAR(energy.external, mass * (1.0 + restitution), 1e-6) << restitution;
    EXPECT_NEAR(energy.kinetic, energy.external - lost, 1e-6) << restitution;
  }
}

/// A rod that a moving pin takes along meets a pillar that stands: seen from the pin, it turns with
/// a moment of inertia of m L^2/3 about it.
TEST_P(Contact, TellsTheWorkOfOtherSupportsFromWhatIsLost) {
  Scene scene = rod();
  scene.supports.push_back(moving_at_one({.at = Place::start(), .kind = SupportKind::Pin}));
  Support pillar{.at = Place::end(), .kind = SupportKind::Pillar, .normal = {0.0, -1.0, 0.0}};
  pillar.gap = 0.01;
  pillar.restitution = 0.6;
  scene.supports.push_back(pillar);
  scene.initial_motions.push_back({.velocity = {0.0, 1.0, 0.0}});
  const double mass = 7850.0 * 4e-4;
  const Energies energy = last_energy(simulate(scene, motion_options(GetParam(), 1e-3, 15)));
  EXPECT_NEAR(energy.impact, mass / 3.0 * 0.5 * (1.0 - 0.36), 1e-4);
}

TEST(MotionContact, FollowsASupportThatStartsAtOnce) {
  Scene scene = testing::cantilever_scene(8);
  scene.supports[0].translation = {0.0, 0.01, 0.0};
  scene.supports[0].history = {{0.0, 0.01, 0.02}, {0.0, 1.0, 1.0}};
  add_probe(scene, ProbeQuantity::Velocity, Place::start(), Component::Y);
  for (const Scheme scheme :
       {Scheme::LinearlyImplicitMidpoint, Scheme::GeneralizedAlpha, Scheme::EnergyMomentum}) {
    const Response response = simulate(scene, motion_options(scheme, 1e-4, 200));
    // The steps are too long for what the jerk makes ring: its energy is not in question here.
    ASSERT_TRUE(is_complete(response.status)) << name_of(response.status);
    for (std::size_t k = 1; k < 99; ++k) EXPECT_NEAR(response.probes[0][k], 1.0, 0.02) << k;
    for (std::size_t k = 102; k < 200; ++k) EXPECT_NEAR(response.probes[0][k], 0.0, 0.02) << k;
  }
}

}  // namespace
}  // namespace plastica
