#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "plastica/run/turn_warning.hpp"
#include "tests/support/chain_scene.hpp"

// Supports that hold or spring the rotation of a beam where loads act or segments meet.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::chain_scene;
using testing::completed;
using testing::last_of;

constexpr double kPull = 1e-2;  ///< [N]; small, so that closed forms hold

/// A beam on springs in its middle, its end pulled down: the tip over
/// F a^3/3EI + F a^2/k_r + F/k, less 1. What is before the middle carries nothing.
double spring_error(int segments, double per_stiffness, bool thick_start) {
  Scene scene = chain_scene(segments);
  const double bending = bending_stiffness_of(scene);
  const double turning = per_stiffness * bending;
  const double pushing = 1e6 * bending;
  scene.supports.push_back({.at = {0.5, {}},
                            .kind = SupportKind::Elastic,
                            .stiffness = {pushing, pushing, pushing},
                            .rotational_stiffness = {turning, turning, turning}});
  if (thick_start) {
    Region thick{.from = Place::start(),
                 .to = {0.5, {}},
                 .section = scene.section,
                 .material = scene.material};
    thick.section.height *= 3.0;
    thick.own = {"section.height"};
    scene.regions.push_back(thick);
  }
  scene.loads.push_back({.at = Place::end(), .force = {0.0, -kPull, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const double a = 0.5 * scene.beam.length;
  const double exact = -kPull * (a * a * a / (3.0 * bending) + a * a / turning + 1.0 / pushing);
  return last_of(completed(scene, {.level = Level::Planar, .steps = 1}), 0) / exact - 1.0;
}

TEST(InnerSupports, SpringsOfRotationAreOfSecondOrder) {
  for (const double stiffness : {0.5, 4.0, 100.0, 1e5}) {
    for (const bool thick_start : {false, true}) {
      SCOPED_TRACE(stiffness);
      const double coarse = std::abs(spring_error(20, stiffness, thick_start));
      EXPECT_LT(coarse, 0.01);
      EXPECT_LT(std::abs(spring_error(40, stiffness, thick_start)), 0.27 * coarse + 1e-9);
    }
  }
}

// What is as stiff as a clamp is one.
TEST(InnerSupports, AStiffSpringIsAClamp) {
  const auto tip_of = [](const Support& support) {
    Scene scene = chain_scene(12);
    scene.supports.push_back(support);
    scene.loads.push_back({.at = Place::end(), .force = {0.0, -kPull, 0.0}});
    scene.loads.push_back({.at = Place::start(), .force = {0.0, 3.0 * kPull, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    add_probe(scene, ProbeQuantity::Displacement, Place::start(), Component::Y);
    const Response response = completed(scene, {.level = Level::Planar, .steps = 1});
    return std::array{last_of(response, 0), last_of(response, 1)};
  };
  const double stiff = 1e5 * bending_stiffness_of(chain_scene(12));
  const auto clamped = tip_of({.at = {0.5, {}}, .kind = SupportKind::Clamp});
  const auto sprung = tip_of({.at = {0.5, {}},
                              .kind = SupportKind::Elastic,
                              .stiffness = {stiff, stiff, stiff},
                              .rotational_stiffness = {stiff, stiff, stiff}});
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(sprung[i] / clamped[i], 1.0, 1e-3);
}

TEST(InnerSupports, TakeAMomentThatActsOnThemselves) {
  for (const double at : {0.0, 0.5, 1.0}) {
    SCOPED_TRACE(at);
    Scene scene = chain_scene(20);
    scene.supports.push_back({.at = {at, {}}, .kind = SupportKind::Clamp});
    scene.loads.push_back({.at = {at, {}}, .moment = {28.0, -3.0, 5.0}});
    for (const double place : {0.0, 1.0}) {
      add_probe(scene, ProbeQuantity::Displacement, {place, {}}, Component::Size);
    }
    for (const Component axis : {Component::X, Component::Y, Component::Z}) {
      add_probe(scene, ProbeQuantity::ReactionMoment, {at, {}}, axis);
    }
    const Response response = completed(scene, {.level = Level::Spatial, .steps = 4});
    EXPECT_EQ(last_of(response, 0), 0.0);
    EXPECT_EQ(last_of(response, 1), 0.0);
    EXPECT_DOUBLE_EQ(last_of(response, 2), -28.0);
    EXPECT_DOUBLE_EQ(last_of(response, 3), 3.0);
    EXPECT_DOUBLE_EQ(last_of(response, 4), -5.0);
  }
}

// About an axis that the support leaves free a moment acts on the beam: M L/3EI, to second order.
TEST(InnerSupports, LeaveTheBeamAMomentAboutAFreeAxis) {
  const auto error_of = [](int segments) {
    Scene scene = chain_scene(segments);
    scene.supports.push_back(
        {.at = Place::start(), .hold = HeldFreedoms{true, true, true, false, true, true}});
    scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
    scene.loads.push_back({.at = Place::start(), .moment = {kPull, 2.0, 0.0}});
    add_probe(scene, ProbeQuantity::Rotation, Place::start(), Component::X);
    add_probe(scene, ProbeQuantity::ReactionMoment, Place::start(), Component::Y);
    const Response response = completed(scene, {.level = Level::Spatial, .steps = 1});
    EXPECT_NEAR(last_of(response, 1), -2.0, 1e-9);
    const double exact = kPull * scene.beam.length / (3.0 * bending_stiffness_of(scene));
    return std::abs(last_of(response, 0) / exact - 1.0);
  };
  const double coarse = error_of(20);
  EXPECT_LT(coarse, 0.01);
  EXPECT_LT(error_of(40), 0.27 * coarse);
}

// A moment on a clamp that turns does work on the support, not on the beam.
TEST(InnerSupports, BalanceTheEnergyOfAMomentOnAClampThatTurns) {
  Scene scene = cantilever_scene(16);
  scene.supports[0].rotation = {0.3, 0.0, 0.0};
  scene.loads.push_back({.at = Place::end(), .force = {0.0, -1.0, 0.0}});
  const SolverOptions options{.level = Level::Planar, .steps = 64};
  const Response alone = completed(scene, options);
  scene.loads.push_back({.at = Place::start(), .moment = {5.0, 0.0, 0.0}});
  const Response loaded = completed(scene, options);
  EXPECT_GT(alone.chain.energy.back().external, 0.0);
  EXPECT_EQ(loaded.chain.energy.back().external, alone.chain.energy.back().external);
  EXPECT_EQ(loaded.chain.energy.back().elastic, alone.chain.energy.back().elastic);
}

// The force at a clamp is the same at either end of a beam, and of a spring in its place.
TEST(InnerSupports, ShowTheForceOfTheJointToTheGround) {
  for (const bool springs : {false, true}) {
    for (const bool at_end : {false, true}) {
      Scene scene = chain_scene(10);
      const Place held = at_end ? Place::end() : Place::start();
      const Place pulled = at_end ? Place::start() : Place::end();
      const double stiff = 1e2 * bending_stiffness_of(scene);
      if (springs) {
        scene.supports.push_back({.at = held,
                                  .kind = SupportKind::Elastic,
                                  .stiffness = {stiff, stiff, stiff},
                                  .rotational_stiffness = {stiff, stiff, stiff}});
      } else {
        scene.supports.push_back({.at = held, .kind = SupportKind::Clamp});
      }
      // Across the beam, and in tension.
      const double sign = at_end ? -1.0 : 1.0;
      scene.loads.push_back({.at = pulled, .force = {0.0, -0.1, sign * 0.03}});
      for (const Component axis : {Component::Y, Component::Z}) {
        add_probe(scene, ProbeQuantity::Force, held, axis);
      }
      const Response response = completed(scene, {.level = Level::Planar, .steps = 1});
      // Of what is beyond: the load, or, at the end, the ground.
      EXPECT_NEAR(last_of(response, 0), -sign * 0.1, 1e-4) << springs << at_end;
      EXPECT_NEAR(last_of(response, 1), 0.03, 1e-4) << springs << at_end;
    }
  }
}

// Bent by 4 rad: in a plane that is counted, in space it comes back from the other side.
TEST(TurnWarning, NamesARotationThatPassesHalfATurnInSpace) {
  Scene scene = cantilever_scene(32);
  scene.loads.push_back(
      {.at = Place::end(),
       .moment = {4.0 * bending_stiffness_of(scene) / scene.beam.length, 0.0, 0.0}});
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
  scene.probes.back().name = "turned";
  for (const Level level : {Level::Planar, Level::Spatial}) {
    const Response response = completed(scene, {.level = level, .steps = 20});
    const bool in_space = level == Level::Spatial;
    EXPECT_NEAR(last_of(response, 0), in_space ? 4.0 - 2.0 * std::numbers::pi : 4.0, 1e-6);
    const auto said = turn_warnings(scene, level, response);
    ASSERT_EQ(said.size(), in_space ? 1U : 0U);
    if (!in_space) continue;
    EXPECT_TRUE(said[0].starts_with("turned passes half a turn: ")) << said[0];
  }
}

}  // namespace
}  // namespace plastica
