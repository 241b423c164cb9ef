#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/lib/run/watched_beam.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/sanitized.hpp"

/// Breaks of joints that stretch for good.
namespace plastica {
namespace {

using namespace testing::watched;

TEST(BreakWatch, AddsStretchToTheStrainOfBending) {
  BreakWatch watch = watch_of(ideal_scene(), 20, {0.1, kNone, kNone, 0.1});
  // Of the hinge length h: 0.5 theta, and e/h.
  const auto flow = [](double theta, double elongation) {
    return lone(20, 10, {theta, 0.0, 0.0, elongation});
  };
  EXPECT_NEAR(strain_of(watch, flow(0.1, 0.0), 10), 0.05, 1e-15);
  EXPECT_NEAR(strain_of(watch, flow(0.1, 0.006), 10), 0.08, 1e-6);
  EXPECT_NEAR(strain_of(watch, flow(0.1, -0.006), 10), 0.08, 1e-6) << "the other side's fibre";
  // About y over the width, and without bending the mean of both.
  EXPECT_NEAR(strain_of(watch, lone(20, 10, {0.0, 0.04, 0.0, 0.006}), 10), 0.02 + 0.06, 1e-6);
  EXPECT_NEAR(strain_of(watch, flow(0.0, 0.006), 10), 0.5 * (0.03 + 0.06), 1e-15);
  EXPECT_TRUE(watch.broken(flow(0.1, 0.0099)).empty());
  EXPECT_EQ(watch.broken(flow(0.1, 0.0101)).front().cause, BreakCause::Stretch);
  EXPECT_EQ(watch.broken(flow(0.15, 0.006)).front().cause, BreakCause::BendingX);
  EXPECT_EQ(watch.broken(flow(0.0, 0.021)).front().cause, BreakCause::Stretch);
}

/// A bar that is pulled until its permanent strain is p has the stress Y + H p, H = E E_t/(E -
/// E_t), and the strain p + (Y + H p)/E.
TEST(Breaks, OfAPulledBarAreThoseOfItsCoupon) {
  constexpr double kLimit = 0.03, kTangent = 2e9;
  for (const YieldModel model : {YieldModel::Interaction, YieldModel::Fibre}) {
    for (const bool moves : {true, false}) {
      Scene scene = testing::cantilever_scene(12);
      scene.yield_model = model;
      scene.material.break_strain = kLimit;
      scene.material.hardening.law = HardeningLaw::Linear;
      scene.material.hardening.tangent_modulus = kTangent;
      const double e = scene.material.youngs_modulus;
      const double stress = scene.material.yield_stress + e * kTangent / (e - kTangent) * kLimit;
      const double force = stress * testing::properties_of(scene).area;
      if (moves) {
        Support pull{.at = Place::end(), .kind = SupportKind::Pin};
        pull.hold = HeldFreedoms{true, true, true, false, false, false};
        pull.translation = {0.0, 0.0, 0.1};
        scene.supports.push_back(pull);
      } else {
        scene.loads = {{.at = Place::end(), .force = {0.0, 0.0, 2.0 * force}}};
      }
      testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Z);
      testing::add_probe(scene, ProbeQuantity::Force, {0.5, {}}, Component::Z);
      testing::add_probe(scene, ProbeQuantity::LargestPlasticStrain, {}, {});
      const Response response = simulate(
          scene, {.level = Level::Planar, .translation = JointTranslation::Elastic, .steps = 40});
      ASSERT_FALSE(response.chain.events.empty()) << name_of(response.status);
      const BrokenJoint& broken = response.chain.events.front().joints.front();
      EXPECT_EQ(broken.cause, BreakCause::Stretch);
      EXPECT_NEAR(broken.strain, kLimit, 2e-4 * kLimit);
      EXPECT_NEAR(testing::last_of(response, 0), kLimit + stress / e, 2e-4 * kLimit);
      EXPECT_NEAR(testing::last_of(response, 1), force, 1e-4 * force);
      EXPECT_NEAR(testing::last_of(response, 2), kLimit, 2e-4 * kLimit);
    }
  }
}

/// The same of joints that do not stretch, whatever supports do to their lengths, in however many
/// steps; and with a limit of bending of its own, which is none of stretch.
TEST(Breaks, OfAPulledBarThatDoesNotStretchAreThoseOfItsSection) {
  constexpr double kLimit = 0.02, kTangent = 2e9;
  for (const int steps : {4, 50}) {
    for (const bool props : {false, true}) {
      for (const JointTranslation translation :
           {JointTranslation::Rigid, JointTranslation::Elastic}) {
        Scene scene = testing::cantilever_scene(25);
        scene.yield_model = YieldModel::Interaction;
        scene.material.break_strain = kLimit;
        scene.break_limit_x = 0.05;
        scene.material.hardening.law = HardeningLaw::Linear;
        scene.material.hardening.tangent_modulus = kTangent;
        if (props) {
          Support prop{.at = {0.52, {}}, .kind = SupportKind::Roller};
          prop.hold = HeldFreedoms{false, true, false, false, false, false};
          scene.supports.push_back(prop);
        }
        const double e = scene.material.youngs_modulus;
        const double stress = scene.material.yield_stress + e * kTangent / (e - kTangent) * kLimit;
        const double force = stress * testing::properties_of(scene).area;
        scene.loads = {{.at = Place::end(), .force = {0.0, 0.0, 2.0 * force}}};
        const Response response =
            simulate(scene, {.level = Level::Planar, .translation = translation, .steps = steps});
        ASSERT_FALSE(response.chain.events.empty()) << name_of(response.status);
        const ChainBreak& event = response.chain.events.front();
        EXPECT_NEAR(event.factor, 0.5, 1e-4) << steps << props;
        EXPECT_EQ(event.joints.front().cause, BreakCause::Stretch);
        EXPECT_GT(event.joints.size(), 20U) << "all of them";
      }
    }
  }
}

/// Where strains are summed over windows of the hinge length, too: a free end has no joint to
/// break, and one beside a rotational spring is no longer than its neighbours.
TEST(Breaks, OfAPulledBarAreThoseOfItsJointsAlone) {
  constexpr double kLimit = 0.02, kStress = 100e6, kRate = 40.0;
  for (const bool sprung : {false, true}) {
    for (const JointTranslation translation :
         {JointTranslation::Rigid, JointTranslation::Elastic}) {
      if (testing::kSanitized && sprung == (translation == JointTranslation::Rigid)) continue;
      constexpr int kSegments = 100;  // of half a depth
      Scene scene = testing::cantilever_scene(kSegments);
      scene.yield_model = YieldModel::Interaction;
      scene.material.break_strain = kLimit;
      scene.material.hardening.law = HardeningLaw::VoceChaboche;
      scene.material.hardening.saturation_stress = kStress;
      scene.material.hardening.saturation_rate = kRate;
      scene.on_break = BreakPolicy::RecordOnly;
      if (sprung) {
        scene.supports.push_back({.at = {0.5, {}},
                                  .kind = SupportKind::Elastic,
                                  .rotational_stiffness = {1e6, 0.0, 0.0}});
      }
      const double stress =
          scene.material.yield_stress + kStress * (1.0 - std::exp(-kRate * kLimit));
      const double force = stress * testing::properties_of(scene).area;
      scene.loads = {{.at = Place::end(), .force = {0.0, 0.0, 1.02 * force}}};
      const Response response =
          simulate(scene, {.level = Level::Planar, .translation = translation, .steps = 20});
      ASSERT_FALSE(response.chain.events.empty()) << name_of(response.status);
      EXPECT_NEAR(response.chain.events.front().factor, 1.0 / 1.02, 1e-5) << sprung;
      for (const ChainBreak& event : response.chain.events) {
        for (const BrokenJoint& joint : event.joints) {
          EXPECT_LT(joint.joint, kSegments);
          EXPECT_EQ(joint.cause, BreakCause::Stretch);
        }
      }
    }
  }
}

/// A cantilever that is pulled by a fraction of what its section yields at and bent by a force
/// across. Probes: the permanent rotation of its hinge, and the strain there.
Scene pulled_and_bent(const Section& section, YieldModel model, YieldCap cap, double pull,
                      bool about_x = true) {
  Scene scene = testing::cantilever_scene(20);
  scene.section = section;
  scene.yield_model = model;
  scene.yield_cap = cap;
  const double all = scene.material.yield_stress * testing::properties_of(scene).area;
  scene.loads = {
      {.at = Place::end(), .force = {0.0, 0.0, pull * all}, .history = History::constant()},
      {.at = Place::end(), .force = {about_x ? 0.0 : -500.0, about_x ? -500.0 : 0.0, 0.0}}};
  testing::add_probe(scene, ProbeQuantity::PlasticAngle, Place::start(),
                     about_x ? Component::X : Component::Y);
  testing::add_probe(scene, ProbeQuantity::LargestPlasticStrain, {}, {});
  return scene;
}

SolverOptions bent_to(double displacement, bool about_x = true) {
  SolverOptions options{.level = Level::Planar, .steps = 200};
  options.control = PathControl::Displacement;
  options.control_motion = {about_x ? 0.0 : -displacement, about_x ? -displacement : 0.0, 0.0};
  return options;
}

/// Of a limit of 5 %.
double rotation_at_break(const Section& section, YieldModel model, YieldCap cap, double pull,
                         bool about_x = true) {
  Scene scene = pulled_and_bent(section, model, cap, pull, about_x);
  scene.material.break_strain = 0.05;
  const Response response = simulate(scene, bent_to(0.5, about_x));
  EXPECT_FALSE(response.chain.events.empty()) << name_of(response.status);
  return std::fabs(testing::last_of(response, 0));
}

/// 20 mm deep.
Section solid(SectionShape shape) {
  Section section;
  section.shape = shape;
  section.width = section.height = 0.02;
  section.radius = 0.01;
  return section;
}

/// A joint that does not stretch breaks by what its section does under its axial force: pulled
/// beyond yield while it bends, earlier than by bending alone.
TEST(Breaks, CountTheElongationOfAHingeThatDoesNotShowIt) {
  const auto rotation = [](double pull) {
    return rotation_at_break(solid(SectionShape::Rectangle), YieldModel::Interaction,
                             YieldCap::FullyPlastic, pull);
  };
  // Of m + n^2 = 1, m = M/M_p and n = N/N_p: de/dtheta = 2 n M_p/N_p = n h/2, as much as the
  // extreme fibre has by bending, times n.
  const double alone = rotation(0.0);
  for (const double n : {0.3, 0.6}) {
    EXPECT_NEAR(alone / rotation(n), 1.0 + n, 1e-3) << n << ": steps meet the limit within 1e-4";
  }
}

/// The surface of first yield, m + n = 1, has an edge at n = 0, beside which it lengthens a section
/// by W/A for a unit of curvature, however small n is. A section's neutral axis moves in proportion
/// to n: what the edge lengthens beyond that is none of the extreme fibre's strain.
TEST(Breaks, DoNotCountWhatAnEdgeOfTheYieldSurfaceLengthens) {
  for (const YieldModel model : {YieldModel::Interaction, YieldModel::Conservative}) {
    for (const bool round : {false, true}) {
      const auto rotation = [&](double pull) {
        const SectionShape shape = round ? SectionShape::Circle : SectionShape::Rectangle;
        return rotation_at_break(solid(shape), model, YieldCap::FirstYield, pull);
      };
      // The hinge is as long as it is deep: (h/2) theta/h. The force across has an own pull, where
      // the beam has turned.
      const double alone = rotation(0.0);
      EXPECT_NEAR(alone, 0.1, 1e-3) << round;
      EXPECT_NEAR(alone / rotation(1e-6), 1.0, 1e-3) << round;
      EXPECT_NEAR(alone / rotation(-1e-6), 1.0, 1e-3) << round;
      for (const double n : {0.1, 0.2, 0.6}) {
        // Of a rectangle the neutral axis is n h/2 off the middle, and 3 W/A is h/2; of a circle
        // n pi r/4 at small n, and 4 W/A is r.
        const double by_axis = round ? 0.25 * std::numbers::pi * n : n;
        const double most = round ? 0.25 : 1.0 / 3.0;
        EXPECT_NEAR(alone / rotation(n), 1.0 + std::min(by_axis, most), 5e-3) << n << round;
      }
    }
  }
}

/// An I-section's neutral axis moves fast about x, through the web, and hardly about y.
TEST(Breaks, CountTheElongationByTheAxisThatBends) {
  Section section;
  section.shape = SectionShape::ISection;
  section.width = 0.1;
  section.height = 0.2;
  section.flange_thickness = 0.0085;
  section.web_thickness = 0.0056;
  const double area = section_properties(section, 0.3).area;
  for (const bool about_x : {true, false}) {
    const auto rotation = [&](double pull) {
      return rotation_at_break(section, YieldModel::Interaction, YieldCap::FirstYield, pull,
                               about_x);
    };
    const double alone = rotation(0.0);
    EXPECT_NEAR(alone, 0.1, 1e-3) << about_x;
    for (const double n : {0.05, 0.1}) {
      // Between the axis and its mirror image, of the web's breadth or its height, is n A.
      const double breadth = about_x ? section.web_thickness : section.height;
      const double off = n * area / (2.0 * breadth);
      const double half_depth = 0.5 * (about_x ? section.height : section.width);
      EXPECT_NEAR(alone / rotation(n), 1.0 + off / half_depth, 0.01) << n << about_x;
    }
  }
}

/// Nor does a trifle of a moment turn a bar that is pulled by that surface's other edge: the pull
/// straightens it.
TEST(Breaks, OfAPulledBarDoNotHangOnATrifleAcross) {
  const auto factor_at_break = [](double across) {
    Scene scene = testing::cantilever_scene(12);
    scene.yield_model = YieldModel::Interaction;
    scene.material.break_strain = 0.03;
    scene.material.hardening.law = HardeningLaw::Linear;
    scene.material.hardening.tangent_modulus = 2e9;
    const double all = scene.material.yield_stress * testing::properties_of(scene).area;
    scene.loads = {
        {.at = Place::end(), .force = {0.0, across, 0.0}, .history = History::constant()},
        {.at = Place::end(), .force = {0.0, 0.0, 2.0 * all}}};
    const Response response = simulate(
        scene, {.level = Level::Planar, .translation = JointTranslation::Elastic, .steps = 100});
    EXPECT_FALSE(response.chain.events.empty()) << name_of(response.status);
    return response.chain.events.at(0).factor;
  };
  const double alone = factor_at_break(0.0);
  for (const double across : {1e-6, 1e-3, 1.0}) {
    EXPECT_NEAR(factor_at_break(across) / alone, 1.0, 1e-4) << across << " N";
  }
}

/// A fit learns from it at which limit a specimen broke.
TEST(Breaks, HaveTheSameStrainsWhereNothingLimitsThem) {
  for (const double n : {0.0, 1e-6, 0.2}) {
    const Response response =
        simulate(pulled_and_bent(solid(SectionShape::Rectangle), YieldModel::Interaction,
                                 YieldCap::FirstYield, n),
                 bent_to(0.1));
    ASSERT_EQ(response.status, Status::Completed) << name_of(response.status);
    const double bending = 0.5 * std::fabs(testing::last_of(response, 0));
    EXPECT_GT(bending, 0.01);
    EXPECT_NEAR(testing::last_of(response, 1) / bending, 1.0 + n, 5e-3) << n;
  }
}

}  // namespace
}  // namespace plastica
