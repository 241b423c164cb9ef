#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

// Moments and rotational springs at ends that may turn, and at joints between uneven segments: the
// whole length is strained, and the chain is of order 2.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::chain_scene;
using testing::completed;
using testing::last_of;
using testing::tolerance;

constexpr double kMoment = 1e-3;  ///< [N m]; finite rotations cost 1e-12 of the deflection

double value_of(const Scene& scene, std::size_t probe) {
  return last_of(completed(scene, {.steps = 1}), probe);
}

/// Errors fall with the square of the segments, and are at most `most` over their square. The half
/// of an end, strained half a segment off, adds a term of third order: c (1 + a/N)/N^2, with
/// |a| < 8, changes the order that 64 and 256 segments show by less than 0.08.
void expect_quartered(const std::function<double(int)>& error, double most) {
  const double coarse = error(16);
  const double fine = error(64);
  const double finest = error(256);
  EXPECT_LT(std::fabs(coarse), most / (16.0 * 16.0));
  EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 2.0, tolerance(0.3));
  EXPECT_NEAR(std::log2(fine / finest) / 2.0, 2.0, tolerance(0.08));
}

/// On a pin at the start and a roller at the end.
Scene simple_beam(int segments) {
  Scene scene = chain_scene(segments);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  return scene;
}

TEST(EndMoments, BendACantileverEvenly) {
  // Any number of segments turns the tip by M L/EI and stores half of that times M.
  for (const int segments : {1, 2, 3, 16}) {
    Scene scene = cantilever_scene(segments);
    scene.loads.push_back({.moment = {kMoment, 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
    add_probe(scene, ProbeQuantity::Energy, Place::end(), Component::X);
    scene.probes.back().energy = EnergyKind::Elastic;
    const double exact = kMoment / bending_stiffness_of(scene);
    EXPECT_NEAR(value_of(scene, 0) / exact, 1.0, tolerance(1e-10)) << segments;
    EXPECT_NEAR(value_of(scene, 1) / (0.5 * kMoment * exact), 1.0, tolerance(1e-10)) << segments;
  }
  expect_quartered(
      [](int segments) {
        Scene scene = cantilever_scene(segments);
        scene.loads.push_back({.moment = {kMoment, 0.0, 0.0}});
        add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
        return std::fabs(value_of(scene, 0)) * 2.0 * bending_stiffness_of(scene) / kMoment - 1.0;
      },
      1.1);
}

TEST(EndMoments, TwistACantileverEvenly) {
  for (const int segments : {1, 2, 16}) {
    Scene scene = cantilever_scene(segments);
    scene.loads.push_back({.moment = {0.0, 0.0, kMoment}});
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
    const SectionProperties p = testing::properties_of(scene);
    const double exact = kMoment / (resolved_shear_modulus(scene.material) * p.torsion_constant);
    EXPECT_NEAR(value_of(scene, 0) / exact, 1.0, tolerance(1e-10)) << segments;
  }
}

TEST(EndMoments, BendASimpleBeamEvenly) {
  // Uniform moment: M L^2/8EI in the middle, M L/2EI at both ends.
  const auto scene_of = [](int segments) {
    Scene scene = simple_beam(segments);
    scene.loads.push_back({.at = Place::start(), .moment = {-kMoment, 0.0, 0.0}});
    scene.loads.push_back({.at = Place::end(), .moment = {kMoment, 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
    add_probe(scene, ProbeQuantity::Rotation, Place::start(), Component::X);
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
    return scene;
  };
  const double ei = bending_stiffness_of(simple_beam(1));
  for (const int segments : {2, 3, 8}) {
    const Scene scene = scene_of(segments);
    EXPECT_NEAR(value_of(scene, 2) * 2.0 * ei / kMoment, 1.0, tolerance(1e-10)) << segments;
    EXPECT_NEAR(value_of(scene, 1) * 2.0 * ei / kMoment, -1.0, tolerance(1e-10)) << segments;
  }
  expect_quartered(
      [&](int segments) {
        return std::fabs(value_of(scene_of(segments), 0)) * 8.0 * ei / kMoment - 1.0;
      },
      5.0);
}

TEST(EndMoments, BendAProppedBeam) {
  // M at the propped end: it turns by M L/4EI, and the prop carries 3M/2L.
  const auto scene_of = [](int segments) {
    Scene scene = cantilever_scene(segments);
    scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
    scene.loads.push_back({.moment = {kMoment, 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
    add_probe(scene, ProbeQuantity::Reaction, Place::end(), Component::Y);
    return scene;
  };
  const double ei = bending_stiffness_of(simple_beam(1));
  expect_quartered(
      [&](int segments) { return value_of(scene_of(segments), 0) * 4.0 * ei / kMoment - 1.0; },
      5.0);
  expect_quartered(
      [&](int segments) {
        return std::fabs(value_of(scene_of(segments), 1)) * 2.0 / (3.0 * kMoment) - 1.0;
      },
      5.0);
}

TEST(EndMoments, AreAlikeAtStartAndEnd) {
  // A beam that is clamped at one end and propped with a moment at the other, both ways round.
  Scene one = cantilever_scene(7);
  one.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  one.loads.push_back({.moment = {kMoment, 0.0, 0.0}});
  add_probe(one, ProbeQuantity::Displacement, {0.3, {}}, Component::Y);
  Scene other = chain_scene(7);
  other.supports.push_back({.at = Place::start(), .kind = SupportKind::Roller});
  other.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
  other.loads.push_back({.at = Place::start(), .moment = {-kMoment, 0.0, 0.0}});
  add_probe(other, ProbeQuantity::Displacement, {0.7, {}}, Component::Y);
  EXPECT_NEAR(value_of(one, 0) / value_of(other, 0), 1.0, tolerance(1e-10));
}

TEST(EndMoments, OfSpringsHoldAsTheyShould) {
  // Rotational springs k at both ends under q: moments q L^2/12 / (1 + 2EI/kL), and in the middle
  // 5 q L^4/384EI less M L^2/8EI.
  expect_quartered(
      [](int segments) {
        Scene scene = simple_beam(segments);
        const double ei = bending_stiffness_of(scene);
        const double k = 3.0 * ei;
        for (const Place& end : {Place::start(), Place::end()}) {
          scene.supports.push_back({.at = end, .kind = SupportKind::Elastic});
          scene.supports.back().rotational_stiffness = {k, 0.0, 0.0};
        }
        constexpr double kLoad = 1e-2;
        scene.loads.push_back(
            {.at = Place::start(), .to = Place::end(), .force = {0.0, kLoad, 0.0}});
        add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
        const double moment = kLoad / 12.0 / (1.0 + 2.0 * ei / k);
        const double exact = 5.0 * kLoad / (384.0 * ei) - moment / (8.0 * ei);
        return value_of(scene, 0) / exact - 1.0;
      },
      20.0);
}

TEST(EndMoments, BendAnOverhangBehindAClamp) {
  // The clamp stands a segment before the free end: both halves of the last one are its joint's.
  Scene scene = chain_scene(4);
  scene.supports.push_back({.at = {0.75, {}}, .kind = SupportKind::Clamp});
  scene.loads.push_back({.moment = {kMoment, 0.0, 0.0}});
  scene.loads.push_back({.at = Place::start(), .moment = {kMoment, 0.0, 0.0}});
  add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
  add_probe(scene, ProbeQuantity::Rotation, Place::start(), Component::X);
  const double turn = kMoment / bending_stiffness_of(scene);
  EXPECT_NEAR(value_of(scene, 0) / turn, 0.25, tolerance(1e-10));
  EXPECT_NEAR(value_of(scene, 1) / turn, 0.75, tolerance(1e-10));
}

TEST(EndMoments, BendUnevenSegmentsUpToWhereTheyAct) {
  // A moment at 0.37: before it the beam is bent, behind it straight.
  for (const int segments : {3, 10, 17}) {
    Scene scene = cantilever_scene(segments);
    scene.loads.push_back({.at = {0.37, {}}, .moment = {kMoment, 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
    const double exact = 0.37 * kMoment / bending_stiffness_of(scene);
    EXPECT_NEAR(value_of(scene, 0) / exact, 1.0, tolerance(1e-10)) << segments;
  }
}

TEST(EndMoments, BreakWhereTheStrainSays) {
  // Under uniform moment all joints reach the break strain at once: (h/2) theta_p/L of the beam,
  // with any number of segments, long or short of the hinge length.
  for (const int segments : {3, 8, 40}) {
    Scene scene = cantilever_scene(segments);
    scene.yield_model = YieldModel::PerAxis;
    scene.material.hardening.law = HardeningLaw::Linear;
    scene.material.hardening.tangent_modulus = 2e9;
    scene.material.break_strain = 0.01;
    scene.loads.push_back({.moment = {2.0 * testing::yield_moment_of(scene), 0.0, 0.0}});
    add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::X);
    const Response response = simulate(scene, {.steps = 50});
    ASSERT_EQ(response.chain.events.size(), 1U) << segments;
    const ChainBreak& event = response.chain.events.front();
    double turned = 0.0;
    for (const BrokenJoint& joint : event.joints) turned += joint.angle[0];
    EXPECT_EQ(event.joints.size(), static_cast<std::size_t>(segments)) << segments;
    EXPECT_NEAR(std::fabs(turned) * 0.5 * scene.section.height / 0.01, 1.0, tolerance(2e-3))
        << segments;
  }
}

/// The first bifurcation of a strip on forks, 100 mm x 0.1 mm, under equal moments at its ends
/// about its strong axis, over pi sqrt(E I_y G J)/L, less one. The forks hold the twist, and the
/// ends turn freely about the weak axis. In its plane the strip is a million times as stiff.
/// Source: Prandtl (1899); Timoshenko & Gere, Theory of Elastic Stability, 6.2.
double lateral_buckling_error(int segments, EndRule rule, Level level) {
  constexpr double kBeyond = 1.6;
  Scene scene = chain_scene(segments);
  scene.end_rule = rule;
  scene.section.width = 1e-4;
  scene.section.height = 0.1;
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  scene.supports[0].hold = HeldFreedoms{true, true, true, false, false, true};
  scene.supports[1].hold = HeldFreedoms{true, true, false, false, false, true};
  const SectionProperties p = testing::properties_of(scene);
  const double moment =
      std::numbers::pi * std::sqrt(scene.material.youngs_modulus * p.second_moment_y *
                                   resolved_shear_modulus(scene.material) * p.torsion_constant);
  scene.loads.push_back({.at = Place::start(), .moment = {-kBeyond * moment, 0.0, 0.0}});
  scene.loads.push_back({.at = Place::end(), .moment = {kBeyond * moment, 0.0, 0.0}});
  const Response response = simulate(scene, {.level = level, .steps = 10});
  EXPECT_EQ(response.status, Status::Unstable) << name_of(response.status);
  return response.critical ? response.critical->factor.front() * kBeyond - 1.0 : 0.0;
}

TEST(EndMoments, BuckleAStripOnForksSideways) {
  for (const Level level : {Level::Planar, Level::Spatial}) {
    expect_quartered(
        [&](int segments) { return lateral_buckling_error(segments, EndRule::ThreeHalves, level); },
        1.1);
  }
}

// A fork's half joint is between the segment and the ground. The torque M u' of the moment, which
// is largest at the ends, acts on the segment and goes past it: L/2N of the compliance against it
// is left out at each end, and so, as M ~ 1/sqrt(compliance), 1/N of the moment too much carried:
// int (M u')^2/GJ dz has 2/N less, u' = cos(pi z/L).
TEST(EndMoments, ArePastTheHalfJointsOfForks) {
  for (const int segments : {64, 256}) {
    EXPECT_NEAR(segments * lateral_buckling_error(segments, EndRule::HalfJoint, Level::Planar), 1.0,
                tolerance(3.0 / segments))
        << segments;
  }
}

}  // namespace
}  // namespace plastica
