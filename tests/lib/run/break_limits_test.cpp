#include "plastica/run/break_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/lib/run/watched_beam.hpp"

namespace plastica {
namespace {

using namespace testing::watched;

TEST(BreakWatch, ChecksEachAxisAgainstItsOwnLimit) {
  BreakWatch watch = watch_of(ideal_scene(), 20, {0.1, 0.01, 0.05, kNone});
  // Strains (h/2)/h, (b/2)/b and J/W_t/h times the angle.
  EXPECT_NEAR(watch.excess(lone(20, 10, {0.19, 0.0, 0.0})), -0.05, 1e-12);
  EXPECT_TRUE(watch.broken(lone(20, 10, {0.19, 0.0, 0.0})).empty());
  const auto expect = [&](const JointFlow& angle, BreakCause cause, double strain, double limit) {
    const auto broken = watch.broken(lone(20, 10, angle));
    ASSERT_FALSE(broken.empty());
    const BrokenJoint* at = nullptr;
    for (const BrokenJoint& joint : broken) {
      if (joint.joint == 10) at = &joint;
    }
    ASSERT_NE(at, nullptr);
    EXPECT_EQ(at->cause, cause);
    EXPECT_NEAR(at->strain, strain, 1e-15);
    EXPECT_EQ(at->limit, limit);
    EXPECT_EQ(at->angle, (std::array<double, 3>{angle[0], angle[1], angle[2]}));
  };
  expect({0.21, 0.0, 0.0}, BreakCause::BendingX, 0.105, 0.1);
  expect({0.21, 0.05, 0.0}, BreakCause::BendingY, 0.025, 0.01);  // further over its limit
  expect({0.0, 0.0, -0.13}, BreakCause::Torsion, 0.052, 0.05);
}

TEST(BreakWatch, TakesTheCornerOfARectangleAndTheResultantOfACircle) {
  const std::array<double, 4> limit{0.1, 0.1, kNone, 0.1};
  const auto angles = lone(20, 10, {0.12, -0.16, 0.0});
  BreakWatch rectangle = watch_of(ideal_scene(), 20, limit);
  EXPECT_NEAR(strain_of(rectangle, angles, 10), (0.12 + 0.16) / 2.0, 1e-15);
  auto joints = joints_of(20, limit);
  for (chain::JointModel& joint : joints) {
    joint.round = true;
    joint.width = joint.height = kHeight;
  }
  BreakWatch circle(ideal_scene(), joints);
  EXPECT_NEAR(strain_of(circle, angles, 10), kHeight / 2.0 * 0.2 / kHeight, 1e-15);
  // Neither axis is over its limit.
  EXPECT_NEAR(circle.excess(lone(20, 10, {0.15, 0.15, 0.0})), 0.15 * std::sqrt(2.0) / 0.2 - 1.0,
              1e-12);
  EXPECT_EQ(circle.broken(lone(20, 10, {0.15, 0.15, 0.0})).front().cause, BreakCause::Biaxial);
}

/// The depth in the plane of bending is the hinge length: a beam that is turned by a right angle
/// breaks as before, whatever its joints' lengths.
TEST(BreakWatch, IsTheSameForABeamThatIsTurned) {
  for (const int segments : {5, 20, 33}) {
    for (const bool hardens : {false, true}) {
      const Scene scene = hardens ? hardening_scene() : ideal_scene();
      auto joints = joints_of(segments, {0.1, 0.1, kNone, 0.1});
      std::vector<JointFlow> angles, turned_angles;
      for (std::size_t j = 0; j < joints.size(); ++j) {
        const double angle = 0.01 * std::sin(1.0 + 0.7 * static_cast<double>(j));
        angles.push_back({angle, 0.3 * angle, 0.0});
        turned_angles.push_back({0.3 * angle, angle, 0.0});
      }
      BreakWatch upright(scene, joints);
      for (chain::JointModel& joint : joints) std::swap(joint.width, joint.height);
      BreakWatch turned(scene, joints);
      for (std::size_t j = 0; j < joints.size(); ++j) {
        const auto a = upright.strains_at(angles, j), b = turned.strains_at(turned_angles, j);
        EXPECT_NEAR(a[0], b[1], 1e-15);
        EXPECT_NEAR(a[1], b[0], 1e-15);
        EXPECT_NEAR(a[3], b[3], 1e-15);
      }
    }
  }
}

/// What a probe reads is what is compared with the limit, of components with a length of their own,
/// too: half the length makes the same angle twice the curvature. A hinge length that is given is
/// the same about all axes.
TEST(BreakWatch, ProbesReadTheMeasureOfComponentsWithTheirOwnLengths) {
  for (const bool windows : {false, true}) {
    Scene scene = ideal_scene();
    scene.hinge_length = windows ? 0.2 : 0.0;
    auto joints = joints_of(20, {kNone, 0.1, kNone, kNone});
    for (chain::JointModel& joint : joints) joint.length[1] = 0.5 * joint.length[0];
    BreakWatch watch(scene, joints);
    const auto angles = lone(20, 10, {0.0, 0.01, 0.0});
    const double expected = kWidth / 2.0 * 0.01 / (windows ? 0.2 : 0.5 * 0.05);
    EXPECT_NEAR(watch.strains_at(angles, 10)[1], expected, 1e-15);
    EXPECT_NEAR(strain_of(watch, angles, 10), expected, 1e-15);
    EXPECT_NEAR(watch.lone_strain(angles[10], 10), expected, 1e-15);
  }
}

TEST(BreakWatch, ListsEveryJointOverItsLimit) {
  Scene scene = ideal_scene();
  scene.hinge_length = 0.0;
  BreakWatch watch = watch_of(scene, 20);
  auto angles = lone(20, 3, {0.06, 0.0, 0.0});
  angles[8] = {0.04, 0.0, 0.0};
  angles[17] = {-0.07, 0.0, 0.0};
  const auto broken = watch.broken(angles);
  ASSERT_EQ(broken.size(), 2U);
  EXPECT_EQ(broken[0].joint, 3);
  EXPECT_EQ(broken[1].joint, 17);
  EXPECT_NEAR(watch.excess(angles), 0.4, 1e-12);
}

TEST(BreakWatch, ListsJointsThatReachTheLimitTogetherWithinItsTolerance) {
  Scene scene = ideal_scene();
  scene.hinge_length = 0.0;
  BreakWatch watch = watch_of(scene, 20);
  const double limit_angle = 0.1 * 0.05 / (kHeight / 2.0);
  auto angles = lone(20, 3, {limit_angle * (1.0 + 1e-6), 0.0, 0.0});
  angles[8] = {limit_angle * (1.0 - 1e-6), 0.0, 0.0};
  angles[9] = {limit_angle * (1.0 - 1e-3), 0.0, 0.0};
  EXPECT_EQ(watch.broken(angles).size(), 2U);
  angles[3] = angles[8];
  EXPECT_TRUE(watch.broken(angles).empty());  // none is over it
}

TEST(BreakWatch, BreaksNothingWithoutALimit) {
  BreakWatch watch = watch_of(ideal_scene(), 20, {kNone, kNone, kNone, kNone});
  const auto angles = lone(20, 3, {100.0, 100.0, 100.0});
  EXPECT_FALSE(watch.active());
  EXPECT_EQ(watch.excess(angles), -1.0);
  EXPECT_TRUE(watch.broken(angles).empty());
  EXPECT_TRUE(watch_of(ideal_scene(), 20, {kNone, kNone, 0.1, kNone}).active());
}

TEST(BreakWatch, HoldsTheReportsSineBeyondHalfATurn) {
  Scene scene = ideal_scene();
  scene.formulas = Formulas::Report;
  BreakWatch watch = watch_of(scene, 20);
  const double pi = std::numbers::pi;
  const auto strain = [&](double angle) {
    return strain_of(watch, lone(20, 10, {angle, 0.0, 0.0}), 10);
  };
  EXPECT_NEAR(strain(1.0), kHeight / 0.05 * std::sin(0.5), 1e-14);
  EXPECT_NEAR(strain(pi), kHeight / 0.05, 1e-14);
  EXPECT_NEAR(strain(1.5 * pi), kHeight / 0.05, 1e-14);
  EXPECT_NEAR(strain(-2.0 * pi), kHeight / 0.05, 1e-14);
}

TEST(BreakWatch, PutsNoAccumulatedAngleIntoTheReportsSine) {
  Scene scene = ideal_scene();
  scene.formulas = Formulas::Report;
  scene.break_measure = BreakMeasure::Accumulated;
  BreakWatch watch = watch_of(scene, 20);
  EXPECT_NEAR(strain_of(watch, lone(20, 10, {9.0, 0.0, 0.0}), 10), kHeight / 2.0 * 9.0 / 0.05,
              1e-13);
}

TEST(BreakWatch, OfTheReportLooksAtEachAxisAloneAndAtTheLongerSideInTorsion) {
  Scene scene = ideal_scene();
  scene.formulas = Formulas::Report;
  BreakWatch watch = watch_of(scene, 20, {kNone, kNone, kNone, kNone});
  const double x = kHeight / 0.05 * std::sin(0.15);
  EXPECT_NEAR(strain_of(watch, lone(20, 10, {0.3, 0.3, 0.0}), 10), x, 1e-15);
  EXPECT_NEAR(strain_of(watch, lone(20, 10, {0.0, 0.0, 0.3}), 10), kHeight / 2.0 * 0.3 / 0.05,
              1e-15);
}

}  // namespace
}  // namespace plastica
