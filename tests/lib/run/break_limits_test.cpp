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
  // Strains (h/2, b/2, J/W_t) angle/h.
  EXPECT_NEAR(watch.excess(lone(20, 10, {0.19, 0.0, 0.0})), -0.05, 1e-12);
  EXPECT_TRUE(watch.broken(lone(20, 10, {0.19, 0.0, 0.0})).empty());
  const auto expect = [&](const JointAngles& angle, BreakCause cause, double strain, double limit) {
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
    EXPECT_EQ(at->angle, angle);
  };
  expect({0.21, 0.0, 0.0}, BreakCause::BendingX, 0.105, 0.1);
  expect({0.21, 0.05, 0.0}, BreakCause::BendingY, 0.0125, 0.01);  // further over its limit
  expect({0.0, 0.0, -0.13}, BreakCause::Torsion, 0.052, 0.05);
}

TEST(BreakWatch, TakesTheCornerOfARectangleAndTheResultantOfACircle) {
  const std::array<double, 4> limit{0.1, 0.1, kNone, 0.1};
  const auto angles = lone(20, 10, {0.12, -0.16, 0.0});
  BreakWatch rectangle = watch_of(ideal_scene(), 20, limit);
  EXPECT_NEAR(strain_of(rectangle, angles, 10), (kHeight * 0.12 + kWidth * 0.16) / 2.0 / kHeight,
              1e-15);
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

/// What a probe reads is what is compared with the limit, of components with a length of their own,
/// too: half the length makes the same angle twice the curvature. A hinge length is the same about
/// all axes, so that a lone hinge is the same about each, and in the plane.
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
