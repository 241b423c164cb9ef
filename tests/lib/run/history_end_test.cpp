#include <gtest/gtest.h>

#include "plastica/theory/lumped_chain.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/tolerance.hpp"

// What happens after the end of a history, against equilibrium, momentum and what was prescribed.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::completed;
using testing::motion_options;
using testing::tolerance;

constexpr double kHeldForce = 1e-2;  ///< [N]; finite rotations cost 1e-11 of the deflection

const std::vector<History> kHeld{{{0.0, 1.0}, {0.0, 1.0}}, History::turning_points({1.0})};

/// Samples each half second up to 3 s.
constexpr std::size_t kAt1 = 2;
constexpr std::size_t kAt2 = 4;
constexpr std::size_t kAt3 = 6;
const SolverOptions kPath{.duration = 3.0, .steps = 6};

TEST(HistoryEnd, HoldsAForceAtRest) {
  constexpr int kSegments = 10;
  Scene scene = cantilever_scene(kSegments);
  scene.loads.push_back({.force = {0.0, -kHeldForce, 0.0}});
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const double displacement =
      -kHeldForce / (3.0 * bending_stiffness_of(scene)) *
      theory::tip_force_ratio(theory::ChainConvention::HalfJoint, kSegments);
  const auto expect = [&](double at_1, double at_2, double at_3) {
    const Response response = completed(scene, kPath);
    for (const auto& [sample, factor] :
         {std::pair(kAt1, at_1), std::pair(kAt2, at_2), std::pair(kAt3, at_3)}) {
      EXPECT_NEAR(response.probes[0][sample], factor * kHeldForce, tolerance(1e-9) * kHeldForce);
      EXPECT_NEAR(response.probes[1][sample] / (factor * displacement), 1.0, tolerance(1e-9));
    }
  };
  for (const History& history : kHeld) {
    scene.loads[0].history = history;
    expect(1.0, 1.0, 1.0);
  }
  scene.loads[0].history = History::ramp();
  expect(1.0, 2.0, 3.0);
}

TEST(HistoryEnd, HoldsGravityAtRest) {
  Scene scene = cantilever_scene(4);
  scene.material.density = 1000.0;
  scene.gravity = {0.0, -1e-3, 0.0};
  scene.gravity_history = kHeld[0];
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  const double weight = 1000.0 * 0.02 * 0.02 * 1e-3;
  const Response response = completed(scene, kPath);
  EXPECT_NEAR(response.probes[0][kAt2], weight, tolerance(1e-9) * weight);
  EXPECT_NEAR(response.probes[0][kAt3], weight, tolerance(1e-9) * weight);
}

TEST(HistoryEnd, StopsAClampAtRestAndInMotion) {
  Scene scene = cantilever_scene(4);
  scene.supports[0].translation = {0.0, 0.1, 0.0};
  add_probe(scene, ProbeQuantity::Displacement, Place::start(), Component::Y);
  // Whose energy balances, whatever the stop makes ring.
  SolverOptions motion = motion_options(Scheme::EnergyMomentum, 1e-2, 300);
  motion.steps = kPath.steps;
  for (const SolverOptions& options : {kPath, motion}) {
    for (const History& history : kHeld) {
      scene.supports[0].history = history;
      const Response response = completed(scene, options);
      EXPECT_NEAR(response.probes[0][kAt1], 0.1, 1e-9);
      EXPECT_NEAR(response.probes[0][kAt2], 0.1, 1e-9);
      EXPECT_NEAR(response.probes[0][kAt3], 0.1, 1e-9);
    }
    scene.supports[0].history = History::ramp();
    EXPECT_NEAR(completed(scene, options).probes[0][kAt3], 0.3, 1e-9);
  }
}

/// The momentum of a free beam is the impulse of what pushes it: in the first second half a unit,
/// then one a second, or with a ramp t^2/2.
TEST(HistoryEnd, HoldsTheForceOnAFreeBeam) {
  Scene scene = testing::chain_scene(4);
  scene.material.density = 1000.0;
  scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, kHeldForce, 0.0}});
  add_probe(scene, ProbeQuantity::Momentum, Place::end(), Component::Y);
  SolverOptions options = motion_options(Scheme::EnergyMomentum, 1e-2, 300);
  options.steps = kPath.steps;
  const auto expect = [&](double at_2, double at_3) {
    const Response response = completed(scene, options);
    EXPECT_NEAR(response.probes[0][kAt2], at_2 * kHeldForce, tolerance(1e-8) * kHeldForce);
    EXPECT_NEAR(response.probes[0][kAt3], at_3 * kHeldForce, tolerance(1e-8) * kHeldForce);
  };
  for (const History& history : kHeld) {
    scene.loads[0].history = history;
    expect(1.5, 2.5);
  }
  scene.loads[0].history = History::ramp();
  expect(2.0, 4.5);
}

/// Loads that act at time 0 did work to get there, half of force times way (Clapeyron), which they
/// take back.
TEST(HistoryEnd, CountsWhatTheLoadsOfTheBeginningDid) {
  Scene scene = testing::cantilever_scene(4);
  scene.loads = {{.at = Place::end(), .force = {0.0, 1.0, 0.0}}};
  scene.loads[0].history = {{0.0, 1.0}, {1.0, 0.0}};
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const Response response = completed(scene, {.steps = 4});
  const auto& energy = response.chain.energy;
  const double work = 0.5 * response.probes[0][0];
  EXPECT_NEAR(energy.front().external, work, 1e-6 * work);
  EXPECT_NEAR(energy.back().external, 0.0, 1e-6 * work);
  for (const Energies& at : energy) EXPECT_NEAR(at.residual, 0.0, 1e-6 * work);
}

/// A scene that gives no history keeps the ramp, which goes on as far as the path needs.
TEST(HistoryEnd, IsThatOfARampWhereASceneGivesNone) {
  EXPECT_EQ(Load{}.history, History::ramp());
  EXPECT_EQ(Support{}.history, History::ramp());
  EXPECT_EQ(Scene{}.gravity_history, History::ramp());
}

}  // namespace
}  // namespace plastica
