#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plastica/theory/lumped_chain.hpp"
#include "plastica/theory/polygon.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

// Loads other than a force at the tip, and what probes see of them.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::completed;
using testing::last_of;
using testing::tolerance;

TEST(ChainLoads, FollowerMomentRollsThePolygonInAPlaneOfSpace) {
  constexpr int kSegments = 16;
  const double turn = 2.0 * std::numbers::pi;
  // About x; about an axis between x and y, for which a square section has no preference.
  for (const double slant : {0.0, 0.7}) {
    for (const bool follows : {false, true}) {
      Scene scene = cantilever_scene(kSegments);
      const double moment = turn * bending_stiffness_of(scene);
      scene.loads.push_back({.moment = {-moment * std::cos(slant), -moment * std::sin(slant), 0.0},
                             .follows = follows});
      const Response response = completed(scene, {.level = Level::Spatial});
      for (int node = 0; node <= kSegments; ++node) {
        // theory: along x, towards y; here along z, towards the axis across moment and z.
        auto expected = theory::polygon_node(kSegments, turn, std::min(node, kSegments - 1));
        if (node == kSegments) {
          // The last segment has the end's half turn, too: it lies along the tangent of the end.
          expected[0] += std::cos(turn) / kSegments;
          expected[1] += std::sin(turn) / kSegments;
        }
        const auto at = testing::last_position(response, static_cast<std::size_t>(node));
        EXPECT_NEAR(at[2], expected[0], tolerance(1e-9)) << node;
        EXPECT_NEAR(at[1], expected[1] * std::cos(slant), tolerance(1e-9)) << node;
        EXPECT_NEAR(at[0], -expected[1] * std::sin(slant), tolerance(1e-9)) << node;
      }
    }
  }
}

/// A cantilever under a moment of 2 EI/L at its tip and a force of 8 EI/L^2 across its middle that
/// follows. With psi, the middle's slope less that at a distance s before it, psi'' = 8 cos(psi)
/// and psi(0) = 0, psi'(0) = 2: classic Runge-Kutta gives the slope psi(1/2).
TEST(ChainLoads, FollowerForceWithinTheBeamHasItsAxisDirectionWithOrderTwo) {
  constexpr int kSteps = 2000;
  constexpr double kStep = 0.5 / kSteps;
  double psi = 0.0;
  double rate = 2.0;
  for (int i = 0; i < kSteps; ++i) {
    const double a1 = 8.0 * std::cos(psi);
    const double r2 = rate + 0.5 * kStep * a1;
    const double a2 = 8.0 * std::cos(psi + 0.5 * kStep * rate);
    const double r3 = rate + 0.5 * kStep * a2;
    const double a3 = 8.0 * std::cos(psi + 0.5 * kStep * r2);
    const double r4 = rate + kStep * a3;
    const double a4 = 8.0 * std::cos(psi + kStep * r3);
    psi += kStep / 6.0 * (rate + 2.0 * r2 + 2.0 * r3 + r4);
    rate += kStep / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
  const double tip = psi + 0.5 * 2.0;  // beyond, the moment bends alone
  const auto error = [&](int segments, Level level) {
    Scene scene = cantilever_scene(segments);
    const double stiffness = bending_stiffness_of(scene);
    scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, 8.0 * stiffness, 0.0}, .follows = true});
    scene.loads.push_back({.moment = {-2.0 * stiffness, 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
    return std::fabs(std::fabs(last_of(completed(scene, {.level = level}), 0)) / tip - 1.0);
  };
  for (const Level level : {Level::Planar, Level::Spatial}) {
    const double coarse = error(16, level);
    EXPECT_LT(coarse, 1e-3);
    EXPECT_NEAR(std::log2(coarse / error(64, level)) / 2.0, 2.0, tolerance(0.05));
  }
}

TEST(ChainLoads, FollowerForceTurnsWithItsSegmentWhereADeadOneDoesNot) {
  // Along the tip's normal at every moment: the tip turns by more than the dead force turns it.
  Scene scene = cantilever_scene(16);
  scene.loads.push_back({.force = {0.0, -4.0 * bending_stiffness_of(scene), 0.0}});
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
  const double dead = last_of(completed(scene), 0);
  scene.loads[0].follows = true;
  const Response planar = completed(scene);
  const Response spatial = completed(scene, {.level = Level::Spatial});
  EXPECT_GT(last_of(planar, 0), 1.2 * dead);
  EXPECT_NEAR(last_of(spatial, 0), last_of(planar, 0), tolerance(1e-10));
}

TEST(ChainLoads, DistributedMomentBendsLikeATipForce) {
  // M = m (L - z), as under the tip force m: the tip goes by m L^3/(3 EI) in the same ratio.
  constexpr int kSegments = 10;
  Scene scene = cantilever_scene(kSegments);
  constexpr double kMoment = 1e-2;
  scene.loads.push_back({.at = Place::start(), .to = Place::end(), .moment = {kMoment, 0.0, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const double exact = -kMoment / 3.0 / bending_stiffness_of(scene);
  EXPECT_NEAR(last_of(completed(scene, {.steps = 1}), 0) / exact,
              theory::tip_force_ratio(theory::ChainConvention::HalfJoint, kSegments),
              tolerance(1e-8));
}

TEST(ChainLoads, DistributedForceOnAPartWeighsAsItsResultantAtTheClamp) {
  Scene scene = cantilever_scene(10);
  constexpr double kPerLength = 1e-2;
  scene.loads.push_back(
      {.at = {0.33, {}}, .to = Place{0.78, {}}, .force = {0.0, -kPerLength, 0.0}});
  add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
  add_probe(scene, ProbeQuantity::ReactionMoment, Place::start(), Component::Size);
  const Response response = completed(scene, {.steps = 1});
  EXPECT_NEAR(last_of(response, 0) / (kPerLength * 0.45), 1.0, tolerance(1e-10));
  EXPECT_NEAR(last_of(response, 1) / (kPerLength * 0.45 * 0.555), 1.0, tolerance(1e-9));
}

/// Bent far into yielding, released and bent the other way, over a roller.
Scene worked_scene() {
  Scene scene = cantilever_scene(24);
  scene.yield_model = YieldModel::PerAxis;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 10e9;
  scene.material.hardening.kinematic_fraction = 0.5;
  const double load = 8.0 * testing::yield_moment_of(scene);
  scene.loads.push_back({.at = {0.5, {}},
                         .force = {0.0, -load, 0.0},
                         .history = History::turning_points({1.0, 0.0, -1.0})});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  return scene;
}

TEST(ChainLoads, ActInSpaceAsInThePlane) {
  for (const bool elastic : {false, true}) {
    SolverOptions options{.steps = 30};
    if (elastic) options.translation = JointTranslation::Elastic;
    const Scene scene = worked_scene();
    const Response planar = completed(scene, options);
    options.level = Level::Spatial;
    const Response spatial = completed(scene, options);
    ASSERT_EQ(planar.samples, spatial.samples);
    const auto& strains = planar.chain.plastic_strain;
    EXPECT_GT(*std::max_element(strains.begin(), strains.end()), 3e-4);
    const auto largest = [](const std::vector<double>& values) {
      double size = 0.0;
      for (const double value : values) size = std::max(size, std::fabs(value));
      return size;
    };
    const auto expect_same = [&](const std::vector<double>& a, const std::vector<double>& b) {
      ASSERT_EQ(a.size(), b.size());
      const double size = largest(a);
      double off = 0.0;
      for (std::size_t i = 0; i < a.size(); ++i) off = std::max(off, std::fabs(a[i] - b[i]));
      EXPECT_LE(off / size, tolerance(1e-10));
    };
    expect_same(planar.chain.position, spatial.chain.position);
    expect_same(planar.chain.moment, spatial.chain.moment);
    expect_same(planar.chain.force, spatial.chain.force);
    expect_same(planar.chain.plastic_angle, spatial.chain.plastic_angle);
    expect_same(planar.chain.reaction, spatial.chain.reaction);
  }
}

TEST(ChainLoads, AreSeenBySeveralProbesAsTheHistoryHasThem) {
  Scene scene = worked_scene();
  add_probe(scene, ProbeQuantity::Displacement, Place{0.25, {}}, Component::Y);
  add_probe(scene, ProbeQuantity::Displacement, Place{0.25, {}}, Component::Size);
  add_probe(scene, ProbeQuantity::Moment, Place{1.0, 12}, Component::X);
  add_probe(scene, ProbeQuantity::PlasticAngle, Place::start(), Component::X);
  add_probe(scene, ProbeQuantity::Reaction, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::LoadFactor, Place::end(), Component::Y);
  add_probe(scene, ProbeQuantity::Force, Place{0.75, {}}, Component::Y);
  const Response response = completed(scene, {.steps = 30});
  const ChainHistory& chain = response.chain;
  for (std::size_t k = 0; k < response.samples; ++k) {
    const auto joint = [&](const std::vector<double>& of, std::size_t j, std::size_t axis) {
      return of[(k * chain.joints + j) * 3 + axis];
    };
    EXPECT_EQ(response.probes[0][k], joint(chain.position, 6, 1));
    EXPECT_NEAR(response.probes[1][k],
                std::hypot(joint(chain.position, 6, 1), joint(chain.position, 6, 2) - 0.25),
                tolerance(1e-14));
    EXPECT_EQ(response.probes[2][k], joint(chain.moment, 12, 0));
    EXPECT_EQ(response.probes[3][k], joint(chain.plastic_angle, 0, 0));
    EXPECT_EQ(response.probes[4][k], chain.reaction[(k * chain.supports + 1) * 6 + 1]);
    EXPECT_EQ(response.probes[5][k], chain.factor[k]);
    EXPECT_EQ(response.probes[6][k], joint(chain.force, 18, 1));
  }
}

}  // namespace
}  // namespace plastica
