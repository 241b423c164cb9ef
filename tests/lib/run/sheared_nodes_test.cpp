#include <gtest/gtest.h>

#include <cmath>

#include "tests/lib/run/sheared_beam.hpp"

// Points under forces, and supports within a beam that shears.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::chain_scene;
using testing::completed;
using testing::elastic;
using testing::expect_second_order;
using testing::kPullForce;
using testing::last_of;
using testing::properties_of;
using testing::shear_stiffness_of;
using testing::tolerance;
using testing::value_of;

TEST(ShearedNodes, MovesThePointThatIsPulledByTheForceOfItsOwnSide) {
  // Stretched up to the load alone: F L/2EA whatever the segments, and whatever the bar beyond.
  for (const int segments : {2, 3, 4, 10}) {
    for (const double beyond : {1.0, 0.3, 4.0}) {
      Scene scene = cantilever_scene(segments);
      Region other{{0.5, {}}, Place::end(), scene.section, scene.material};
      other.section.height *= beyond;
      scene.regions.push_back(other);
      scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, 0.0, 1e3}});
      add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Z);
      const double exact = 0.5e3 / (scene.material.youngs_modulus * properties_of(scene).area);
      EXPECT_NEAR(value_of(scene) / exact, 1.0, tolerance(1e-9)) << segments << ' ' << beyond;
    }
  }
}

/// A short beam on a pin and a roller, three times as long as deep, with a probe of y.
Scene stocky_beam(int segments, double probed) {
  Scene scene = chain_scene(segments);
  scene.section.height = 0.3;
  scene.supports.push_back({.kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  add_probe(scene, ProbeQuantity::Displacement, {probed, {}}, Component::Y);
  return scene;
}

TEST(ShearedNodes, BendsAndShearsUnderTheForceItself) {
  // F a^2 b^2/3EIL + F ab/kappa G A L at the load.
  for (const double at : {0.5, 0.25}) {
    for (const bool follows : {false, true}) {
      expect_second_order(
          [&](int segments) {
            Scene scene = stocky_beam(segments, at);
            scene.loads.push_back(
                {.at = {at, {}}, .force = {0.0, kPullForce, 0.0}, .follows = follows});
            const double parts = at * (1.0 - at);
            const double exact = kPullForce * (parts * parts / (3.0 * bending_stiffness_of(scene)) +
                                               parts / shear_stiffness_of(scene));
            return value_of(scene) / exact - 1.0;
          },
          2.0, {8, 32, 128});
    }
  }
}

TEST(ShearedNodes, ShearsOnBothSidesOfASupportWithin) {
  // The reaction that moves a place by w is w over what a unit force there moves it by.
  expect_second_order(
      [](int segments) {
        constexpr double kMotion = 1e-6;
        Scene scene = stocky_beam(segments, 1.0);
        Support held{.at = {0.25, {}}, .kind = SupportKind::Roller};
        held.translation = {0.0, kMotion, 0.0};
        scene.supports.push_back(held);
        scene.probes.clear();
        add_probe(scene, ProbeQuantity::Reaction, {0.25, {}}, Component::Y);
        const double parts = 0.25 * 0.75;
        const double exact = kMotion / (parts * parts / (3.0 * bending_stiffness_of(scene)) +
                                        parts / shear_stiffness_of(scene));
        return value_of(scene) / exact - 1.0;
      },
      4.0, {8, 32, 128});
}

TEST(ShearedNodes, SharesAForceBetweenTheSupportsBesideIt) {
  // Three supports at 0, a, L and a force behind them: the reaction at a is P w(x, a)/w(a, a),
  // where w(x, a) is what a unit force at x moves the place a by (Maxwell).
  expect_second_order(
      [](int segments) {
        constexpr double kSupported = 0.25;
        constexpr double kPulled = 0.625;
        Scene scene = stocky_beam(segments, kPulled);
        scene.supports.push_back({.at = {kSupported, {}}, .kind = SupportKind::Roller});
        scene.loads.push_back({.at = {kPulled, {}}, .force = {0.0, kPullForce, 0.0}});
        const double bending = bending_stiffness_of(scene);
        const double shear = shear_stiffness_of(scene);
        const auto moved = [&](double at, double by) {  // of L = 1, at <= by
          const double b = 1.0 - by;
          return b * at * (1.0 - b * b - at * at) / (6.0 * bending) + at * b / shear;
        };
        const double reaction = moved(kSupported, kPulled) / moved(kSupported, kSupported);
        const double exact =
            kPullForce * (moved(kPulled, kPulled) - reaction * moved(kSupported, kPulled));
        return value_of(scene) / exact - 1.0;
      },
      8.0, {16, 64, 256});
}

TEST(ShearedNodes, PassesALoadStraightIntoItsSupport) {
  // Nothing strains the beam, and the reaction is the load: what is left of it is rounding.
  const double half = std::sqrt(0.5);
  for (const SupportKind kind :
       {SupportKind::Clamp, SupportKind::Pin, SupportKind::Roller, SupportKind::InclinedRoller}) {
    for (const double force : {1e-2, 50.0, 70.0, 1e5}) {
      for (const int segments : {6, 8, 24}) {
        for (const Analysis analysis : {Analysis::Statics, Analysis::Dynamics}) {
          Scene scene = cantilever_scene(segments);
          Support within{.at = {0.5, {}}, .kind = kind};
          const bool oblique = kind == SupportKind::InclinedRoller;
          if (oblique) within.normal = {0.0, half, half};
          scene.supports.push_back(within);
          const bool along = kind == SupportKind::Clamp || kind == SupportKind::Pin;
          scene.loads.push_back({.at = {0.5, {}},
                                 .force = {0.0, oblique ? half * force : -force,
                                           oblique ? half * force
                                           : along ? 0.5 * force
                                                   : 0.0}});
          scene.loads.back().history = {{0.0, 0.05}, {0.0, 1.0}};
          add_probe(scene, ProbeQuantity::Reaction, {0.5, {}}, Component::Y);
          SolverOptions options = elastic();
          options.analysis = analysis;
          options.time_step = 0.01;
          SCOPED_TRACE(static_cast<int>(kind) * 1000 + segments);
          const Response response = completed(scene, options);
          const double exact = oblique ? -half * force : force;
          EXPECT_NEAR(last_of(response, 0) / exact, 1.0, tolerance(1e-6))
              << static_cast<int>(kind) << ' ' << force << ' ' << segments;
        }
      }
    }
  }
}

TEST(ShearedNodes, LetsNoPointJumpWithItsForceInAMotion) {
  // At time 0 nothing has moved; a force is there from then on.
  Scene scene = stocky_beam(16, 0.5);
  scene.loads.push_back(
      {.at = {0.5, {}}, .force = {0.0, -300.0, 0.0}, .history = History::constant()});
  SolverOptions options = elastic();
  options.analysis = Analysis::Dynamics;
  options.time_step = 1e-5;
  options.duration = 1e-4;
  const Response response = completed(scene, options);
  EXPECT_EQ(response.probes[0][0], 0.0);
}

}  // namespace
}  // namespace plastica
