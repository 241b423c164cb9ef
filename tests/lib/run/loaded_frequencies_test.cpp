#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "plastica/run/natural_frequencies.hpp"
#include "tests/support/chain_scene.hpp"

/// Natural frequencies of beams on which something acts.
namespace plastica {
namespace {

using std::numbers::pi;

constexpr SolverOptions kPlanar{.level = Level::Planar, .rotary_inertia = RotaryInertia::Off};

double mass_of(const Scene& scene) {
  return scene.material.density * scene.section.width * scene.section.height;
}

std::vector<double> frequencies_of(const Scene& scene, const SolverOptions& options, int count) {
  const LoadedFrequencies loaded = natural_frequencies(scene, options, count);
  EXPECT_EQ(loaded.status, Status::Completed) << name_of(loaded.status);
  return loaded.frequency;
}

std::vector<double> unloaded(Scene scene, int count) {
  scene.loads = {{.force = {0.0, 1.0, 0.0}}};
  return unloaded_frequencies(prepare(scene, kPlanar), count);
}

Scene pinned(int segments) {
  Scene scene = testing::chain_scene(segments);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  return scene;
}

TEST(LoadedFrequencies, OfAPinnedColumnFallWithItsThrust) {
  // The modes of the chain are sines with and without thrust, which share mass and stiffness:
  // omega_m^2(P) = omega_m^2 (1 - P/P_m), exactly; that joints are stiffer than their law by 1e-9
  // counts a thousand times as much where a thousandth is left.
  constexpr int kSegments = 12;
  Scene scene = pinned(kSegments);
  const std::vector<double> still = unloaded(scene, 3);
  const double stiffness = testing::bending_stiffness_of(scene);
  for (const double fraction : {-20.0, 0.5, 0.999}) {
    const double first = 2.0 * kSegments * kSegments * stiffness * (1.0 - std::cos(pi / kSegments));
    scene.loads = {{.force = {0.0, 0.0, -fraction * first}}};
    for (const Level level : {Level::Planar, Level::Spatial}) {
      SolverOptions options = kPlanar;
      options.level = level;
      const std::vector<double> found = frequencies_of(scene, options, 6);
      for (int m = 1; m <= 3; ++m) {
        const double critical =
            2.0 * kSegments * kSegments * stiffness * (1.0 - std::cos(m * pi / kSegments));
        const double exact =
            still[static_cast<std::size_t>(m - 1)] * std::sqrt(1.0 - fraction * first / critical);
        const int k = level == Level::Planar ? m - 1 : 2 * m - 1;
        EXPECT_NEAR(found[static_cast<std::size_t>(k)] / exact, 1.0, fraction < 0.9 ? 1e-8 : 6e-7)
            << fraction << ' ' << m;
      }
    }
  }
}

TEST(LoadedFrequencies, OfAPullAtTimeZeroAreThoseOfTheMotion) {
  Scene scene = pinned(8);
  scene.loads = {{.force = {0.0, 0.0, 2e4}, .history = History::constant()}};
  SolverOptions motion = kPlanar;
  motion.duration = 1.0;
  const std::vector<double> still = frequencies_of(scene, motion, 2);
  EXPECT_GT(still[0], 1.3 * unloaded(scene, 1)[0]);
  motion.analysis = Analysis::Dynamics;
  motion.damping = Damping::Stiffness;
  motion.damping_time = 1e-4;
  EXPECT_EQ(frequencies_of(scene, motion, 2), still);
  scene.loads[0].history = History::ramp();  // nothing acts at time 0
  EXPECT_NEAR(frequencies_of(scene, motion, 1)[0], unloaded(pinned(8), 1)[0], 1e-9);
}

TEST(LoadedFrequencies, OfAWireAreThoseOfAString) {
  // f_m = m/2 sqrt(T/mu).
  Scene scene = pinned(64);
  scene.section.width = scene.section.height = 1e-4;
  scene.loads = {{.force = {0.0, 0.0, 1.0}}};
  const double first = 0.5 * std::sqrt(1.0 / mass_of(scene));
  const std::vector<double> found = frequencies_of(scene, kPlanar, 3);
  const double bending = pi * pi * testing::bending_stiffness_of(scene);  // 1.6e-5 of the pull
  for (int m = 1; m <= 3; ++m) {
    const double exact = m * first * std::sqrt(1.0 + m * m * bending);
    EXPECT_NEAR(found[static_cast<std::size_t>(m - 1)] / exact, 1.0, 2e-3 * m * m) << m;
  }
}

TEST(LoadedFrequencies, OfAHangingChainAreThoseOfBernoulli) {
  // omega = j_m/2 sqrt(g/L), j_m the zeros of J_0.
  constexpr double kZeros[] = {2.404825557695773, 5.520078110286311};
  double error[2][2];
  int row = 0;
  for (const int segments : {16, 64}) {
    Scene scene = testing::chain_scene(segments);
    scene.section.width = scene.section.height = 1e-6;
    scene.material.youngs_modulus = 2e5;  // it bends at its clamp within 1e-6 of its length
    scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Clamp});
    scene.gravity = {0.0, 0.0, 9.81};
    const std::vector<double> found = frequencies_of(scene, kPlanar, 2);
    for (std::size_t m = 0; m < 2; ++m) {
      error[row][m] = found[m] * 2.0 * pi / (0.5 * kZeros[m] * std::sqrt(9.81)) - 1.0;
    }
    ++row;
  }
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_LE(std::fabs(error[1][m]), 2e-3);
    EXPECT_LT(std::fabs(error[1][m]), 0.1 * std::fabs(error[0][m]));
  }
}

TEST(LoadedFrequencies, OfABarThatAForceHasTurnedAreThoseOfItsNewPlace) {
  // A rigid bar of the length 1 on a hinge of stiffness c, and a force F across at its end: c t =
  // F cos t, and omega^2 = (c + F sin t)/(m/3).
  Scene scene = testing::chain_scene(1);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back(
      {.at = Place::end(), .kind = SupportKind::Elastic, .rotational_stiffness = {700.0, 0, 0}});
  scene.loads = {{.force = {0.0, 900.0, 0.0}}};
  double t = 0.5;
  for (int k = 0; k < 50; ++k) {
    t -= (700.0 * t - 900.0 * std::cos(t)) / (700.0 + 900.0 * std::sin(t));
  }
  const double exact = std::sqrt((700.0 + 900.0 * std::sin(t)) / (mass_of(scene) / 3.0));
  EXPECT_NEAR(frequencies_of(scene, kPlanar, 1)[0] * 2.0 * pi / exact, 1.0, 1e-8);
}

TEST(LoadedFrequencies, OfJointsThatHaveYieldedAreThoseOfTheirUnloading) {
  // A force across the end: what has bent permanently swings as an elastic beam of that shape.
  Scene scene = testing::cantilever_scene(8);
  scene.loads = {{.force = {0.0, 1.2 * testing::yield_moment_of(scene), 0.0}}};
  scene.material.hardening = {.law = HardeningLaw::Linear, .tangent_modulus = 100e9};
  const double elastic = frequencies_of(scene, kPlanar, 1)[0];
  for (const YieldModel model : {YieldModel::PerAxis, YieldModel::Interaction, YieldModel::Fibre}) {
    scene.yield_model = model;
    EXPECT_NEAR(frequencies_of(scene, kPlanar, 1)[0] / elastic, 1.0, 1e-3)
        << static_cast<int>(model);
  }
}

TEST(LoadedFrequencies, OfAnUnstableStateSayHowManyWaysLeaveIt) {
  Scene scene = pinned(8);
  scene.loads = {{.force = {0.0, 0.0, -2.0 * pi * pi * testing::bending_stiffness_of(scene)}}};
  const LoadedFrequencies loaded = natural_frequencies(scene, kPlanar, 2);
  EXPECT_EQ(loaded.status, Status::Unstable);
  ASSERT_EQ(loaded.frequency.size(), 2U);
  EXPECT_EQ(loaded.frequency[0], 0.0);
  EXPECT_GT(loaded.frequency[1], 0.0);
}

}  // namespace
}  // namespace plastica
