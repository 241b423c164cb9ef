#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

// Probes of rotation and spin within the beam.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::completed;
using testing::last_of;
using testing::tolerance;

double rotation_of(Scene scene, double at, Component component = Component::X) {
  add_probe(scene, ProbeQuantity::Rotation, {at, {}}, component);
  return last_of(completed(scene, {}), scene.probes.size() - 1);
}

TEST(BeamSlope, OfAUniformMomentIsExactAtEveryPlace) {
  // M s/EI, of a moment at the end, and of one within the beam up to its place.
  for (const int segments : {4, 7, 10}) {
    for (const double moment_at : {1.0, 0.5}) {
      Scene scene = cantilever_scene(segments);
      scene.loads.push_back({.at = {moment_at, {}}, .moment = {1e-3, 0.0, 0.0}});
      const double curvature = 1e-3 / bending_stiffness_of(scene);
      for (const double at : {0.2, 0.37, 0.5, 0.63, 0.9, 1.0}) {
        if (at < 0.5 / segments) continue;  // the first half segment shows the first segment
        const double exact = curvature * std::min(at, moment_at);
        EXPECT_NEAR(rotation_of(scene, at) / exact, 1.0, tolerance(1e-9))
            << segments << ' ' << moment_at << ' ' << at;
      }
    }
  }
}

TEST(BeamSlope, OfTwoRegionsIsExactUnderAMomentAtTheirBorder) {
  // The part before gives way alone.
  Scene scene = cantilever_scene(6);
  Region beyond{{0.5, {}}, Place::end(), scene.section, scene.material};
  beyond.section.height *= 2.0;
  scene.regions.push_back(beyond);
  scene.loads.push_back({.at = {0.5, {}}, .moment = {1e-3, 0.0, 0.0}});
  const double exact = 1e-3 * 0.5 / bending_stiffness_of(scene);
  EXPECT_NEAR(rotation_of(scene, 0.5) / exact, 1.0, tolerance(1e-9));
  EXPECT_NEAR(rotation_of(scene, 0.75) / exact, 1.0, tolerance(1e-9)) << "nothing bends it beyond";
}

TEST(BeamSlope, UnderATipForceIsOfSecondOrderWhereverItIsProbed) {
  // F (L s - s^2/2)/EI
  for (const double at : {0.25, 0.37, 0.5, 0.81}) {
    const auto error = [&](int segments) {
      Scene scene = cantilever_scene(segments);
      scene.loads.push_back({.force = {0.0, 1e-2, 0.0}});
      const double exact = 1e-2 * (at - 0.5 * at * at) / bending_stiffness_of(scene);
      return std::fabs(std::fabs(rotation_of(scene, at)) / exact - 1.0);
    };
    for (const int segments : {8, 16, 32, 64, 128}) {
      EXPECT_LT(error(segments) * segments * segments, 1.2) << at << ' ' << segments;
    }
  }
}

TEST(BeamSlope, OfATwistedBarIsExactAtEveryPlace) {
  // T s/GJ; in space and at the level of twist alone.
  for (const Level level : {Level::Twist, Level::Spatial}) {
    Scene scene = cantilever_scene(5);
    scene.loads.push_back({.moment = {0.0, 0.0, 1e-3}});
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
    add_probe(scene, ProbeQuantity::Rotation, {0.43, {}}, Component::Z);
    SolverOptions options;
    options.level = level;
    const Response response = completed(scene, options);
    EXPECT_NEAR(last_of(response, 1) / last_of(response, 0), 0.43, tolerance(1e-9));
  }
}

TEST(BeamSlope, BendsInSpaceAsInThePlaneAndSkewToBoth) {
  // Of small moments about x and y each by itself, the larger about a skew axis in space.
  Scene scene = cantilever_scene(6);
  scene.section.width = 0.5 * scene.section.height;
  scene.loads.push_back({.moment = {1e-3, 2e-3, 0.0}});
  const double x = 1e-3 / bending_stiffness_of(scene);
  EXPECT_NEAR(rotation_of(scene, 0.4, Component::X) / (0.4 * x), 1.0, tolerance(1e-6));
  const double y = 2e-3 / (bending_stiffness_of(scene) * 0.25);
  EXPECT_NEAR(rotation_of(scene, 0.4, Component::Y) / (0.4 * y), 1.0, tolerance(1e-6));
}

TEST(BeamSlope, OfACircleIsItsAngleHoweverFarItIsBent) {
  // A moment of 2 pi EI/L winds the beam up: the slope at s is 2 pi s/L, in a plane beyond a turn.
  Scene scene = cantilever_scene(20);
  const double moment = 3.0 * 3.14159265358979 * bending_stiffness_of(scene);
  scene.loads.push_back({.moment = {moment, 0.0, 0.0}});
  EXPECT_NEAR(rotation_of(scene, 0.33) / (0.33 * moment / bending_stiffness_of(scene)), 1.0,
              tolerance(1e-7));
  EXPECT_NEAR(rotation_of(scene, 0.9) / (0.9 * moment / bending_stiffness_of(scene)), 1.0,
              tolerance(1e-7));
}

TEST(BeamSlope, AtAHingeIsThatOfTheSegmentBefore) {
  // All of its angle is at the hinge, so that the segment before turns as one.
  Scene scene = cantilever_scene(8);
  scene.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Hinge});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, 1e-2, 0.0}});
  const double before = rotation_of(scene, 0.49);
  const double beyond = rotation_of(scene, 0.51);
  EXPECT_NEAR(rotation_of(scene, 0.5) / before, 1.0, tolerance(1e-12));
  EXPECT_LT(before * beyond, 0.0);
}

TEST(BeamSlope, IsTheIntegralOfItsSpinAndAPointOfItsVelocity) {
  // Of unlike regions that shear, in the plane and in space: central differences over two samples.
  for (const Level level : {Level::Planar, Level::Spatial}) {
    Scene scene = cantilever_scene(6);
    Region beyond{{0.5, {}}, Place::end(), scene.section, scene.material};
    beyond.section.height *= 0.5;
    scene.regions.push_back(beyond);
    scene.loads.push_back({.force = {0.0, 10.0, 0.0}, .history = History::constant()});
    for (const double at : {0.43, 0.5, 0.71}) {
      add_probe(scene, ProbeQuantity::Rotation, {at, {}}, Component::X);
      add_probe(scene, ProbeQuantity::Spin, {at, {}}, Component::X);
    }
    add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
    add_probe(scene, ProbeQuantity::Velocity, {0.5, {}}, Component::Y);
    SolverOptions options;
    options.level = level;
    options.translation = JointTranslation::Elastic;
    options.analysis = Analysis::Dynamics;
    options.steps = 400;
    options.time_step = 1e-5;
    options.duration = 4e-3;
    const Response response = completed(scene, options);
    for (std::size_t p = 0; p < response.probes.size(); p += 2) {
      const auto& value = response.probes[p];
      const auto& rate = response.probes[p + 1];
      double largest = 0.0;
      double off = 0.0;
      for (std::size_t i = 200; i + 1 < response.samples; ++i) {
        const double step = response.chain.time[i + 1] - response.chain.time[i - 1];
        largest = std::max(largest, std::fabs(rate[i]));
        off = std::max(off, std::fabs((value[i + 1] - value[i - 1]) / step - rate[i]));
      }
      EXPECT_LT(off, 5e-3 * largest) << p;
    }
  }
}

}  // namespace
}  // namespace plastica
