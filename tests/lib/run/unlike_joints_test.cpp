#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

// Joints between unlike regions: the beam read from its other end is the same beam.

namespace plastica {
namespace {

using testing::add_probe;
using testing::chain_scene;
using testing::completed;
using testing::last_of;
using testing::tolerance;

constexpr double kJoint = 0.4;  ///< where the sections meet

Place mirrored(const Place& place) { return {1.0 - place.fraction, {}}; }

/// The beam's image in a plane across z: forces along z turn round, and so do moments about x and
/// y, which are axial vectors.
Scene mirrored(Scene scene) {
  for (Region& region : scene.regions) {
    region.from = mirrored(region.from);
    region.to = mirrored(region.to);
    std::swap(region.from, region.to);
  }
  const auto mirror_force = [](std::array<double, 3>& v) { v[2] = -v[2]; };
  const auto mirror_moment = [](std::array<double, 3>& v) {
    v[0] = -v[0];
    v[1] = -v[1];
  };
  for (Support& support : scene.supports) {
    support.at = mirrored(support.at);
    mirror_force(support.translation);
    mirror_moment(support.rotation);
  }
  for (Load& load : scene.loads) {
    load.at = mirrored(load.at);
    if (load.to) {
      load.to = mirrored(*load.to);
      std::swap(load.at, *load.to);
    }
    mirror_force(load.force);
    mirror_moment(load.moment);
  }
  for (Probe& probe : scene.probes) probe.at = mirrored(probe.at);
  return scene;
}

/// Clamped at both ends, the end sliding along z, thick up to `kJoint` and thin beyond, of other
/// materials.
Scene stepped(int segments) {
  Scene scene = chain_scene(segments);
  for (const Place& end : {Place::start(), Place::end()}) {
    scene.supports.push_back({.at = end, .kind = SupportKind::Clamp});
  }
  scene.supports.back().hold = HeldFreedoms{true, true, false, true, true, true};
  Section thin = scene.section;
  thin.height *= 0.6;
  thin.width *= 0.8;
  Material other = scene.material;
  other.youngs_modulus *= 0.5;
  other.yield_stress *= 1.3;
  scene.regions.push_back({{kJoint, {}}, Place::end(), thin, other});
  return scene;
}

/// Energies, the stress and strain at the step, and the deflection at a place.
void watch(Scene& scene) {
  add_probe(scene, ProbeQuantity::Energy, Place::end(), Component::X);
  scene.probes.back().energy = EnergyKind::Elastic;
  add_probe(scene, ProbeQuantity::Energy, Place::end(), Component::X);
  scene.probes.back().energy = EnergyKind::Plastic;
  add_probe(scene, ProbeQuantity::Stress, {kJoint, {}}, Component::Size);
  add_probe(scene, ProbeQuantity::Strain, {kJoint, {}}, Component::Size);
  add_probe(scene, ProbeQuantity::Displacement, {0.55, {}}, Component::Y);
}

void expect_mirror_images(const Scene& scene, const SolverOptions& options, double relative) {
  const Response one = simulate(scene, options);
  const Response other = simulate(mirrored(scene), options);
  ASSERT_EQ(one.status, other.status);
  ASSERT_TRUE(usable(one.status)) << name_of(one.status);
  ASSERT_GT(one.samples, 3U);
  ASSERT_EQ(one.samples, other.samples);
  for (std::size_t p = 0; p < scene.probes.size(); ++p) {
    const double size = std::fabs(one.probes[p][one.samples - 1]);
    for (std::size_t i = 0; i < one.samples; ++i) {
      EXPECT_NEAR(one.probes[p][i], other.probes[p][i], tolerance(relative) * size)
          << p << ' ' << i;
    }
  }
}

TEST(UnlikeJoints, AreMirrorImagesInThePlane) {
  for (const YieldModel model : {YieldModel::Elastic, YieldModel::PerAxis, YieldModel::Fibre}) {
    Scene scene = stepped(20);
    scene.yield_model = model;
    scene.loads.push_back({.at = {kJoint, {}}, .force = {0.0, -2500.0, 0.0}});
    scene.loads.push_back({.at = {kJoint, {}}, .moment = {150.0, 0.0, 0.0}});
    watch(scene);
    SolverOptions options;
    options.tolerance = 1e-12;
    expect_mirror_images(scene, options, 1e-10);
  }
}

TEST(UnlikeJoints, AreMirrorImagesInSpace) {
  Scene scene = stepped(20);
  scene.yield_model = YieldModel::Interaction;
  scene.loads.push_back(
      {.at = {kJoint, {}}, .force = {600.0, -1500.0, 0.0}, .moment = {0.0, 0.0, 200.0}});
  watch(scene);
  SolverOptions options;
  options.tolerance = 1e-12;
  expect_mirror_images(scene, options, 1e-10);
  scene.yield_model = YieldModel::PerAxis;
  expect_mirror_images(scene, options, 1e-10);
}

/// A force along the beam at the step, followers and a spring at joints: all that changes the axial
/// force at the node of a joint.
TEST(UnlikeJoints, AreMirrorImagesWhereTheAxialForceChangesAtAJoint) {
  int alone = 0;
  for (const YieldModel model : {YieldModel::PerAxis, YieldModel::Interaction, YieldModel::Fibre}) {
    for (const Level level : {Level::Planar, Level::Spatial}) {
      Scene scene = stepped(20);
      scene.yield_model = model;
      const double yield = scene.material.yield_stress * scene.section.width * scene.section.height;
      scene.loads.push_back({.at = {kJoint, {}}, .force = {0.0, -6000.0, 0.3 * yield}});
      scene.loads.push_back(
          {.at = {0.7, {}}, .force = {0.0, 100.0, -0.05 * yield}, .follows = true});
      Support spring{.at = {0.2, {}}, .kind = SupportKind::Elastic};
      spring.stiffness = {0.0, 1e4, 1e6};
      scene.supports.push_back(spring);
      watch(scene);
      SolverOptions options;
      options.level = level;
      options.tolerance = 1e-12;
      SCOPED_TRACE(std::to_string(static_cast<int>(model)));
      expect_mirror_images(scene, options, 1e-9);
      // Newton's method takes no more than without axial force, but for an iteration a step.
      const Response response = completed(scene, options);
      EXPECT_GT(last_of(response, 1), 50.0);
      const PathCounters& counters = response.counters;
      if (model == YieldModel::PerAxis) alone = counters.iterations;
      EXPECT_LE(counters.iterations, alone + counters.steps);
    }
  }
}

/// Half joints on both sides of a guide, each with the axial force of its own side.
TEST(UnlikeJoints, AreMirrorImagesAboutAGuide) {
  for (const Level level : {Level::Planar, Level::Spatial}) {
    Scene scene = stepped(20);
    scene.yield_model = YieldModel::Interaction;
    scene.supports.push_back({.at = {0.6, {}}, .kind = SupportKind::Guide});
    const double yield = scene.material.yield_stress * scene.section.width * scene.section.height;
    scene.loads.push_back({.at = {0.6, {}}, .force = {0.0, -1500.0, 0.2 * yield}});
    watch(scene);
    for (std::size_t p = 2; p < 4; ++p) scene.probes[p].at = {0.6, {}};
    SolverOptions options;
    options.level = level;
    options.tolerance = 1e-12;
    expect_mirror_images(scene, options, 1e-9);
    EXPECT_GT(last_of(simulate(scene, options), 3), 0.0);  // beside the guide
  }
}

TEST(UnlikeJoints, BreakAsMirrorImages) {
  // The thin region breaks at the step, where the moment of the middle load is largest.
  Scene scene = chain_scene(20);
  scene.yield_model = YieldModel::PerAxis;
  scene.material.break_strain = 0.03;
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  Section thin = scene.section;
  thin.height *= 0.6;
  scene.regions.push_back({{0.5, {}}, Place::end(), thin, scene.material});
  scene.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Roller});
  scene.supports.back().translation = {0.0, -0.2, 0.0};
  add_probe(scene, ProbeQuantity::PlasticStrain, {0.5, {}}, Component::Size);
  const Response one = simulate(scene);
  const Response other = simulate(mirrored(scene));
  ASSERT_EQ(one.chain.events.size(), 1U);
  ASSERT_EQ(other.chain.events.size(), 1U);
  const ChainBreak& a = one.chain.events.front();
  const ChainBreak& b = other.chain.events.front();
  EXPECT_NEAR(a.time / b.time, 1.0, tolerance(2e-4));  // to which a break is met
  ASSERT_EQ(a.joints.size(), b.joints.size());
  EXPECT_EQ(a.joints.front().joint, 10);
  EXPECT_EQ(b.joints.front().joint, 10);
  EXPECT_NEAR(std::fabs(a.joints.front().angle[0] / b.joints.front().angle[0]), 1.0,
              tolerance(2e-4));
  // The hinge length is the depth of the part that yields: h/2 theta/h is the strain.
  EXPECT_NEAR(std::fabs(a.joints.front().angle[0]), 0.03 * 2.0, tolerance(0.03 * 2.0 * 0.01));
}

// A lone hinge takes the hinge length, whatever the joint's length about an axis is: about both
// axes, and in space as in the plane.
TEST(UnlikeJoints, BreakAtTheAngleOfALoneHingeAboutEitherAxis) {
  for (const std::size_t across : {0U, 1U}) {
    for (const auto level : {Level::Planar, Level::Spatial}) {
      SCOPED_TRACE(::testing::Message()
                   << "across " << across << ", level " << static_cast<int>(level));
      Scene scene = chain_scene(4);
      scene.yield_model = YieldModel::PerAxis;
      scene.material.break_strain = 0.02;
      scene.section.width = 0.03;
      scene.section.height = 0.02;
      Section thin = scene.section;
      thin.height = 0.01;
      Material soft = scene.material;
      soft.youngs_modulus *= 0.3;
      soft.yield_stress *= 0.4;
      scene.regions.push_back({{0.5, {}}, Place::end(), thin, soft});
      scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Clamp});
      Support push{.at = Place::end(), .kind = SupportKind::Roller};
      push.hold = HeldFreedoms{across == 0, across == 1, false, false, false, false};
      push.translation[across] = 0.8 * scene.beam.length;
      scene.supports.push_back(push);
      add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::X);
      const Response response = simulate(scene, {.level = level, .steps = 400});
      ASSERT_EQ(response.chain.events.size(), 1U) << name_of(response.status);
      const BrokenJoint& broken = response.chain.events.front().joints.front();
      EXPECT_EQ(broken.joint, 2);
      // L_p is the thin part's depth in the plane of bending, d: (d/2) theta/d.
      const double exact = 2.0 * 0.02;
      EXPECT_NEAR(std::fabs(broken.angle[1 - across]) / exact, 1.0, 2e-4);
    }
  }
}

TEST(UnlikeJoints, StoreTheWorkOfTheLoad) {
  // A linear beam stores half of force times way, whatever its joints are made of; with bending and
  // twist at once finite rotations cost 1e-7 of it at 1 N.
  for (const bool space : {false, true}) {
    Scene scene = stepped(16);
    scene.supports.pop_back();
    scene.loads.push_back(
        {.force = {space ? 3e-6 : 0.0, 1e-5, 0.0}, .moment = {0.0, 0.0, space ? 2e-6 : 0.0}});
    add_probe(scene, ProbeQuantity::Energy, Place::end(), Component::X);
    scene.probes.back().energy = EnergyKind::Elastic;
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::X);
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
    const Response response = completed(scene, {.steps = 1});
    const Load& load = scene.loads.front();
    const double work =
        0.5 * (load.force[0] * last_of(response, 1) + load.force[1] * last_of(response, 2) +
               load.moment[2] * last_of(response, 3));
    EXPECT_NEAR(last_of(response, 0) / work, 1.0, tolerance(1e-9));
  }
}

TEST(UnlikeJoints, DissipateWhatTheLoadPutsIn) {
  // Pushed far beyond yielding: external work less what is stored and dissipated is the trapezoid's
  // error, which falls with the square of the step.
  const auto residual = [](int steps) {
    Scene scene = stepped(12);
    scene.yield_model = YieldModel::PerAxis;
    scene.material.hardening.law = HardeningLaw::Linear;
    scene.material.hardening.tangent_modulus = 5e9;
    scene.regions[0].material.hardening = scene.material.hardening;
    scene.supports.push_back({.at = {kJoint, {}}, .kind = SupportKind::Roller});
    scene.supports.back().translation = {0.0, -0.03, 0.0};
    add_probe(scene, ProbeQuantity::Energy, Place::end(), Component::X);
    scene.probes.back().energy = EnergyKind::Residual;
    add_probe(scene, ProbeQuantity::Energy, Place::end(), Component::X);
    scene.probes.back().energy = EnergyKind::External;
    const Response response = completed(scene, {.steps = steps});
    return std::fabs(last_of(response, 0) / last_of(response, 1));
  };
  EXPECT_LT(residual(200), 1e-3);
  EXPECT_LT(residual(800), 1e-4);
}

TEST(UnlikeJoints, TurnByTheCurvaturesOfBothHalves) {
  // A moment at a step in the middle: before it the beam is bent, behind it straight, so that the
  // tip turns by M z/EI of the inner part alone, at any number of segments and stiffness.
  for (const int segments : {5, 8, 13}) {
    Scene scene = stepped(segments);
    scene.supports.pop_back();
    scene.loads.push_back({.at = {kJoint, {}}, .moment = {1e-3, 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
    const double exact = 1e-3 * kJoint / testing::bending_stiffness_of(scene);
    EXPECT_NEAR(last_of(completed(scene, {.steps = 1}), 0) / exact, 1.0, tolerance(1e-9))
        << segments;
  }
}

}  // namespace
}  // namespace plastica
