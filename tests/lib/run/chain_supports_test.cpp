#include <gtest/gtest.h>

#include <cmath>

#include "plastica/theory/beam_cases.hpp"
#include "plastica/theory/lumped_chain.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

// Supports other than a clamp, against closed forms; loads are small, so that these hold.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::completed;
using testing::last_of;
using testing::tolerance;

constexpr double kProppedForce = 1e-2;  ///< [N]; finite rotations cost 1e-11 of the deflection

double chain_ratio(int segments) {
  return theory::tip_force_ratio(theory::ChainConvention::HalfJoint, segments);
}

TEST(ChainSupports, ShareTheLoadWithASpringByTheirStiffness) {
  constexpr int kSegments = 10;
  Scene scene = cantilever_scene(kSegments);
  const double beam = 3.0 * bending_stiffness_of(scene) / chain_ratio(kSegments);  // [N/m]
  scene.loads.push_back({.force = {0.0, -kProppedForce, 0.0}});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Elastic});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Reaction, Place::end(), Component::Y);
  for (const double spring : {0.1 * beam, beam, 10.0 * beam}) {
    scene.supports.back().stiffness = {0.0, spring, 0.0};
    const Response response = completed(scene, {.steps = 1});
    EXPECT_NEAR(last_of(response, 0) / (-kProppedForce / (beam + spring)), 1.0, tolerance(1e-9));
    EXPECT_NEAR(last_of(response, 1) / (kProppedForce * spring / (beam + spring)), 1.0,
                tolerance(1e-9));
  }
}

TEST(ChainSupports, TurnASpringOfRotation) {
  // The end turns by M L/EI without the spring.
  constexpr int kSegments = 10;
  Scene scene = cantilever_scene(kSegments);
  const double beam = bending_stiffness_of(scene);  // [N m/rad]
  scene.loads.push_back({.moment = {kProppedForce, 0.0, 0.0}});
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Elastic,
                            .rotational_stiffness = {3.0 * beam, 0.0, 0.0}});
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
  // A spring that holds rotation stands beside the half joint of the end segment.
  EXPECT_NEAR(last_of(completed(scene, {.steps = 1}), 0) / (kProppedForce / (4.0 * beam)), 1.0,
              tolerance(1e-9));
}

/// A beam on a pin and on a slope: the slope's push R along its normal n balances the load about
/// the pin, R n_y L = F L/2, and has no other part; its end moves along the slope alone.
TEST(ChainSupports, OfAnInclinedRollerPushAcrossTheSlopeAlone) {
  for (const double angle : {0.0, 0.4, -0.9}) {
    Scene scene = testing::chain_scene(16);
    scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
    scene.supports.push_back({.at = Place::end(),
                              .kind = SupportKind::InclinedRoller,
                              .normal = {0.0, std::cos(angle), std::sin(angle)}});
    const double force = 0.1;
    scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, -force, 0.0}});
    for (const Component axis : {Component::Y, Component::Z}) {
      add_probe(scene, ProbeQuantity::Reaction, Place::end(), axis);
      add_probe(scene, ProbeQuantity::Displacement, Place::end(), axis);
    }
    for (const Level level : {Level::Planar, Level::Spatial}) {
      if (level == Level::Spatial) {
        scene.supports.push_back(
            {.at = {0.5, {}}, .hold = HeldFreedoms{true, false, false, false, false, false}});
      }
      const Response response = completed(scene, {.level = level, .steps = 1});
      EXPECT_NEAR(last_of(response, 0), 0.5 * force, 1e-6 * force) << angle;
      EXPECT_NEAR(last_of(response, 2), 0.5 * force * std::tan(angle), 1e-6 * force) << angle;
      EXPECT_NEAR(std::cos(angle) * last_of(response, 1) + std::sin(angle) * last_of(response, 3),
                  0.0, 1e-12);
    }
  }
}

/// The same slope at the start: the mirror image.
TEST(ChainSupports, OfAnInclinedRollerAtTheStartAreTheMirrorImage) {
  const double angle = 0.4;
  Scene scene = testing::chain_scene(16);
  scene.supports.push_back({.at = Place::start(),
                            .kind = SupportKind::InclinedRoller,
                            .normal = {0.0, std::cos(angle), -std::sin(angle)}});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Pin});
  scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, -0.1, 0.0}});
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Z);
  const Response response = completed(scene, {.level = Level::Planar, .steps = 1});
  EXPECT_NEAR(last_of(response, 0), 0.05, 1e-7);
  EXPECT_NEAR(last_of(response, 1), -0.05 * std::tan(angle), 1e-7);
}

TEST(ChainSupports, LetGoOfAPillarAndCloseItAgain) {
  constexpr int kSegments = 32;
  Scene scene = cantilever_scene(kSegments);
  scene.loads.push_back({.at = {0.5, {}},
                         .force = {0.0, -kProppedForce, 0.0},
                         .history = History::turning_points({1.0, -1.0, 1.0})});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Pillar});
  add_probe(scene, ProbeQuantity::Reaction, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const Response response = completed(scene, {.steps = 30});
  const theory::BeamCase propped{.ends = theory::BeamEnds::ClampedPinned,
                                 .bending_stiffness = bending_stiffness_of(scene),
                                 .load = {.position = 0.5, .force = -kProppedForce}};
  theory::BeamCase free = propped;
  free.ends = theory::BeamEnds::ClampedFree;
  const double push = theory::beam_reactions(propped).end_force;
  const double lifted = -theory::beam_deflection(free, 1.0);
  // Convergence in 1/N^2, 1e-3.
  EXPECT_NEAR(response.probes[0][10] / push, 1.0, tolerance(1e-3));
  EXPECT_NEAR(response.probes[1][10], 0.0, tolerance(1e-15));
  EXPECT_EQ(response.probes[0][20], 0.0);
  EXPECT_NEAR(response.probes[1][20] / lifted, 1.0, tolerance(1e-3));
  EXPECT_NEAR(response.probes[0][30] / response.probes[0][10], 1.0, tolerance(1e-9));
  EXPECT_NEAR(response.probes[1][30], 0.0, tolerance(1e-15));
  for (std::size_t k = 0; k < response.samples; ++k) {
    EXPECT_GE(response.probes[0][k], -tolerance(1e-15)) << k;  // it never pulls
    EXPECT_GE(response.probes[1][k], -tolerance(1e-15)) << k;  // nor is it gone through
  }
}

TEST(ChainSupports, TouchAPillarBelowAGapWhenTheTipHasGoneThatFar) {
  constexpr int kSegments = 10;
  Scene scene = cantilever_scene(kSegments);
  const double beam = 3.0 * bending_stiffness_of(scene) / chain_ratio(kSegments);
  const double gap = 0.4 * kProppedForce / beam;
  scene.loads.push_back({.force = {0.0, -kProppedForce, 0.0}});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Pillar, .gap = gap});
  add_probe(scene, ProbeQuantity::Reaction, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const Response response = completed(scene, {.steps = 10});
  for (std::size_t k = 0; k < response.samples; ++k) {
    const double force = kProppedForce * static_cast<double>(k) / 10.0;
    EXPECT_NEAR(response.probes[0][k] / kProppedForce, std::max(0.0, force / kProppedForce - 0.4),
                tolerance(1e-9));
    EXPECT_NEAR(response.probes[1][k] / gap, -std::min(1.0, force / kProppedForce / 0.4),
                tolerance(1e-9));
  }
}

/// Clamped at both ends, the far one free to slide along the beam.
Scene clamped_twice(int segments) {
  Scene scene = cantilever_scene(segments);
  scene.supports.push_back(
      {.at = Place::end(), .hold = HeldFreedoms{true, true, false, true, true, true}});
  add_probe(scene, ProbeQuantity::Reaction, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::ReactionMoment, Place::end(), Component::X);
  add_probe(scene, ProbeQuantity::ReactionMoment, Place::start(), Component::X);
  return scene;
}

// With half joints the rule of their sums is the trapezoid's: the flexibility of the ends against
// turning is (1/3)(1 + 1/2N^2) L/EI, its other entry (1/6)(1 - 1/N^2) L/EI. Inverted, with
// d = 1 + 2/N^2: 4 (1 + 1/2N^2)/d and 2 (1 - 1/N^2)/d EI/L for a turn, their sum for a shift.

TEST(ChainSupports, SettleByAPrescribedTranslation) {
  constexpr int kSegments = 16;
  Scene scene = clamped_twice(kSegments);
  const double ei = bending_stiffness_of(scene) / (1.0 + 2.0 / kSegments / kSegments);
  constexpr double kShift = 1e-6;
  scene.supports.back().translation = {0.0, kShift, 0.0};
  const Response response = completed(scene, {.steps = 1});
  EXPECT_NEAR(last_of(response, 0) / (12.0 * ei * kShift), 1.0, tolerance(1e-8));
  EXPECT_NEAR(last_of(response, 1) / (6.0 * ei * kShift), 1.0, tolerance(1e-8));
  EXPECT_NEAR(last_of(response, 2) / (6.0 * ei * kShift), 1.0, tolerance(1e-8));
}

TEST(ChainSupports, TurnByAPrescribedRotation) {
  constexpr int kSegments = 16;
  constexpr double kSquare = 1.0 / kSegments / kSegments;
  Scene scene = clamped_twice(kSegments);
  const double ei = bending_stiffness_of(scene) / (1.0 + 2.0 * kSquare);
  constexpr double kRotation = 1e-6;
  scene.supports.back().rotation = {kRotation, 0.0, 0.0};
  const Response response = completed(scene, {.steps = 1});
  EXPECT_NEAR(last_of(response, 1) / (4.0 * (1.0 + 0.5 * kSquare) * ei * kRotation), 1.0,
              tolerance(1e-8));
  EXPECT_NEAR(last_of(response, 2) / (2.0 * (1.0 - kSquare) * ei * kRotation), 1.0,
              tolerance(1e-8));
}

TEST(ChainSupports, CarryTheBeamAroundWithoutStrain) {
  // One and a half turns about an oblique axis and a way, by the clamp alone.
  Scene scene = cantilever_scene(8);
  const double turn = 3.0 * std::acos(-1.0);
  scene.supports[0].rotation = {0.6 * turn, 0.0, 0.8 * turn};
  scene.supports[0].translation = {2.0, -3.0, 1.0};
  const Response response = completed(scene, {.steps = 40});
  const std::size_t last = response.samples - 1;
  EXPECT_NEAR(response.chain.energy[last].elastic, 0.0, tolerance(1e-18));
  const auto tip = testing::last_position(response, 8);
  // Half a turn takes z to 2 (z . n) n - z, n = (0.6, 0, 0.8).
  EXPECT_NEAR(tip[0], 2.0 + 2.0 * 0.8 * 0.6, tolerance(1e-12));
  EXPECT_NEAR(tip[1], -3.0, tolerance(1e-12));
  EXPECT_NEAR(tip[2], 1.0 + 2.0 * 0.8 * 0.8 - 1.0, tolerance(1e-12));
}

}  // namespace
}  // namespace plastica
