#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plastica/run/axial_warning.hpp"
#include "tests/support/axial_limit.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/motion_scene.hpp"

// Scenes in which the axial force of yielding joints follows from equilibrium: both ends held,
// start and end exchanged, motion.

namespace plastica {
namespace {

using testing::add_probe;
using testing::chain_scene;
using testing::last_of;
using testing::properties_of;

/// A slack beam: an arc between two clamps, loaded at its lowest point towards the outside, so that
/// it hangs. Multipliers carry the axial force.
Scene hanging(int segments) {
  Scene scene = chain_scene(segments);
  scene.yield_model = YieldModel::Interaction;
  scene.yield_cap = YieldCap::FullyPlastic;
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 0.6;
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Clamp});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
  return scene;
}

/// At both clamps, from the response alone: the axial force is what the force there has along the
/// half joint's axis, and where the joint yields the moment is M_p (1 - n^2).
TEST(AxialForce, OfAHangingBeamLimitsTheMomentsAtItsClamps) {
  Scene scene = hanging(16);
  const SectionProperties p = properties_of(scene);
  const double yield = scene.material.yield_stress * p.area;
  const double plastic = scene.material.yield_stress * p.plastic_section_modulus_x;
  // Across the chord, outwards: the arc bends towards y, its middle is on the other side.
  const double chord = 0.3;
  scene.loads.push_back(
      {.at = {0.5, {}},
       .force = {0.0, -0.2 * yield * std::cos(chord), 0.2 * yield * std::sin(chord)}});
  add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Size);
  const Response response = testing::completed(scene, {.level = Level::Planar, .steps = 20});
  const ChainHistory& chain = response.chain;
  const std::size_t last = response.samples - 1;
  const std::size_t n = chain.joints - 1;
  EXPECT_LT(std::fabs(chain.energy[last].residual), 5e-3 * chain.energy[last].external);
  for (const std::size_t node : {std::size_t{0}, n}) {
    const std::size_t support = node == 0 ? 0 : 1;
    const double* reaction = &chain.reaction[(last * chain.supports + support) * 6];
    const double moment = reaction[3];
    const double theta = chain.angle[(last * chain.joints + node) * 3];
    EXPECT_GT(std::fabs(chain.plastic_angle[(last * chain.joints + node) * 3]), 1e-4);
    // Tangent of the undeformed beam in the y-z plane at the clamp, and half the joint's turn: from
    // the ground outwards at the start, back to it at the end.
    const double tangent = node == 0 ? 0.0 : 0.6;
    const double turned = tangent - (node == 0 ? 0.5 : -0.5) * theta;
    const double along = std::cos(turned) * reaction[2] + std::sin(turned) * reaction[1];
    const double ratio = std::fabs(along) / yield;
    EXPECT_GT(ratio, 0.5);
    EXPECT_NEAR(std::fabs(moment) / (plastic * (1.0 - ratio * ratio)), 1.0, 1e-6) << node;
  }
}

/// A column with a load across its middle and one along it, at the end that is guided; and the same
/// beam read from its other end.
struct Column {
  Scene forth, back;
};
Column column(YieldModel model, double n, double across) {
  Scene scene = chain_scene(10);
  scene.yield_model = model;
  scene.yield_cap = model == YieldModel::Fibre ? YieldCap::FirstYield : YieldCap::FullyPlastic;
  scene.beam.length = 0.4;
  const double yield = scene.material.yield_stress * properties_of(scene).area;

  Column made{scene, scene};
  for (const bool back : {false, true}) {
    Scene& one = back ? made.back : made.forth;
    const Place clamp = back ? Place::end() : Place::start();
    const Place guide = back ? Place::start() : Place::end();
    one.supports.push_back({.at = clamp, .kind = SupportKind::Clamp});
    Support guided{.at = guide, .kind = SupportKind::Guide};
    one.supports.push_back(guided);
    const double sense = back ? -1.0 : 1.0;
    one.loads.push_back({.at = {0.3, {}}, .force = {0.0, across, 0.0}});
    if (back) one.loads.back().at = {0.7, {}};
    one.loads.push_back({.at = guide,
                         .force = {0.0, 0.0, sense * n * yield},
                         .history = {{0.0, 0.2, 1.0}, {0.0, 1.0, 1.0}}});
    add_probe(one, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
    add_probe(one, ProbeQuantity::ReactionMoment, clamp, Component::X);
    add_probe(one, ProbeQuantity::ReactionMoment, guide, Component::X);
  }
  return made;
}

void expect_mirrored(Level level, YieldModel model) {
  // Past the hinge at the clamp.
  const Column two = column(model, -0.15, 5.5e3);
  const Response forth = simulate(two.forth, {.level = level, .steps = 30});
  const Response back = simulate(two.back, {.level = level, .steps = 30});
  ASSERT_EQ(forth.status, Status::Completed) << name_of(forth.status);
  ASSERT_EQ(back.status, Status::Completed) << name_of(back.status);
  ASSERT_GT(forth.chain.energy[forth.samples - 1].plastic, 0.0);
  ASSERT_EQ(forth.samples, back.samples);
  const std::size_t last = forth.samples - 1;
  EXPECT_NEAR(forth.probes[0][last] / back.probes[0][last], 1.0, 1e-7);
  EXPECT_NEAR(forth.probes[1][last] / back.probes[1][last], -1.0, 1e-7);
  EXPECT_NEAR(forth.probes[2][last] / back.probes[2][last], -1.0, 1e-7);
}

TEST(AxialForce, IsTheSameFromBothEnds) {
  expect_mirrored(Level::Planar, YieldModel::Interaction);
  expect_mirrored(Level::Planar, YieldModel::Fibre);
  expect_mirrored(Level::Spatial, YieldModel::Interaction);
}

/// A beam on two supports, of four stiff segments, is bent by a force across its middle and has one
/// along it there, which one half of it carries: the joint between has half of it, whichever half
/// that is. It yields first, at m = 1 - (n/2)^2; its neighbours have half of its moment.
TEST(AxialForce, OfAJointIsTheMeanOfBothSidesWhereALoadActs) {
  for (const bool back : {false, true}) {
    for (const double n : {-0.5, 0.3, 0.6}) {
      Scene scene = chain_scene(4);
      scene.material.youngs_modulus = 1e16;
      scene.yield_model = YieldModel::Interaction;
      scene.yield_cap = YieldCap::FullyPlastic;
      scene.supports.push_back(
          {.at = back ? Place::end() : Place::start(), .kind = SupportKind::Pin});
      scene.supports.push_back(
          {.at = back ? Place::start() : Place::end(), .kind = SupportKind::Roller});
      const SectionProperties p = properties_of(scene);
      const double stress = scene.material.yield_stress;
      scene.loads.push_back({.at = {0.5, {}},
                             .force = {0.0, 1.3 * 4.0 * stress * p.plastic_section_modulus_x, 0.0},
                             .history = {{0.0, 0.1, 1.0}, {0.0, 0.01, 1.0}}});
      scene.loads.push_back({.at = {0.5, {}},
                             .force = {0.0, 0.0, n * stress * p.area},
                             .history = {{0.0, 0.1, 1.0}, {0.0, 1.0, 1.0}}});
      for (const Level level : {Level::Planar, Level::Spatial}) {
        const Response response = simulate(scene, {.level = level, .steps = 40});
        ASSERT_EQ(response.status, Status::LimitLoad) << name_of(response.status);
        EXPECT_NEAR(1.3 * response.limit->below, 1.0 - 0.25 * n * n, 1e-3) << n;
      }
    }
  }
}

/// A motion leaves the axial force out, and says so: 1 - n^2 is left.
TEST(AxialForce, OfAMotionIsLeftOutAndSaid) {
  for (const Scheme scheme : {Scheme::GeneralizedAlpha, Scheme::EnergyMomentum}) {
    Scene scene = testing::cantilever_scene(4);
    scene.yield_model = YieldModel::Interaction;
    scene.yield_cap = YieldCap::FullyPlastic;
    const SectionProperties p = properties_of(scene);
    const double yield = scene.material.yield_stress * p.area;
    const double plastic = scene.material.yield_stress * p.plastic_section_modulus_x;
    scene.loads.push_back({.at = Place::end(),
                           .force = {0.0, 0.0, 0.6 * yield},
                           .history = {{0.0, 0.2, 1.0}, {0.0, 1.0, 1.0}}});
    // A moment at the end is the same along the beam, whatever the axial force does.
    scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Elastic});
    scene.supports.back().stiffness = {0.0, 1e7, 0.0};
    scene.loads.push_back({.at = {0.5, {}},
                           .force = {0.0, 20.0 * plastic, 0.0},
                           .history = {{0.0, 0.2, 1.0}, {0.0, 0.0, 1.0}}});
    add_probe(scene, ProbeQuantity::Moment, Place::start(), Component::X);
    SolverOptions options;
    options.analysis = Analysis::Dynamics;
    options.level = Level::Planar;
    options.scheme = scheme;
    options.time_step = 2e-3;
    options.steps = 50;
    const Response response = simulate(scene, options);
    ASSERT_EQ(response.status, Status::Completed) << name_of(response.status);
    EXPECT_GT(response.chain.energy.back().plastic, 0.0);
    ASSERT_TRUE(response.axial);
    EXPECT_NEAR(response.axial->ratio, 0.6, 0.03);
    EXPECT_NEAR(response.axial->left, 1.0 - std::pow(response.axial->ratio, 2), 1e-9);
    EXPECT_NE(axial_warnings(scene, options, response).at(0).find("a motion"), std::string::npos);
    EXPECT_LT(response.energy_balance_error, kBalanceTolerance);
  }
}

}  // namespace
}  // namespace plastica
