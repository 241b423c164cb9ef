#include "plastica/run/break_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "tests/lib/run/watched_beam.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica {
namespace {

using namespace testing::watched;

TEST(BreakWatch, SeesAUniformCurvatureWhateverTheSegments) {
  // l from 1/4 of the hinge length to 2.5 of it; joint 0 is at the beam's end, its window inside.
  for (const int segments : {2, 4, 5, 8, 20, 33}) {
    BreakWatch watch = watch_of(ideal_scene(), segments);
    const auto angles = uniform(segments, 0.3);
    for (std::size_t i = 0; i < watch.size(); ++i) {
      EXPECT_NEAR(strain_of(watch, angles, i), 0.3 * kHeight / 2.0, 1e-15) << segments << ' ' << i;
    }
  }
}

TEST(BreakWatch, SpreadsALoneHingeOverTheHingeLengthWhateverTheSegments) {
  for (const int segments : {2, 4, 5, 8, 20, 33}) {
    BreakWatch watch = watch_of(ideal_scene(), segments);
    const auto middle = static_cast<std::size_t>(segments / 2);
    for (const std::size_t joint : {std::size_t{0}, middle, static_cast<std::size_t>(segments)}) {
      const auto angles = lone(segments, joint, {-0.05, 0.0, 0.0});
      EXPECT_NEAR(strain_of(watch, angles, joint), kHeight / 2.0 * 0.05 / kHeight, 1e-15)
          << segments << ' ' << joint;
    }
  }
}

TEST(BreakWatch, CountsANeighbourWithTheFractionThatItsWindowCovers) {
  // l = L_p/4: a window reaches two joints to each side and covers half of the outer ones.
  BreakWatch watch = watch_of(ideal_scene(), 20);
  const auto angles = lone(20, 10, {0.04, 0.0, 0.0});
  const double whole = kHeight / 2.0 * 0.04 / kHeight;
  EXPECT_NEAR(strain_of(watch, angles, 9), whole, 1e-15);
  EXPECT_NEAR(strain_of(watch, angles, 12), whole / 2.0, 1e-15);
  EXPECT_NEAR(strain_of(watch, angles, 13), 0.0, 1e-15);
}

TEST(BreakWatch, MovesTheWindowOfTheEndIntoTheBeam) {
  // At joint 0 it covers 0 … L_p: joint 3 whole, joint 4 half, joint 5 not.
  BreakWatch watch = watch_of(ideal_scene(), 20);
  const double whole = kHeight / 2.0 * 0.04 / kHeight;
  const JointFlow turned{0.04, 0.0, 0.0};
  EXPECT_NEAR(strain_of(watch, lone(20, 3, turned), 0), whole, 1e-15);
  EXPECT_NEAR(strain_of(watch, lone(20, 4, turned), 0), whole / 2.0, 1e-15);
  EXPECT_NEAR(strain_of(watch, lone(20, 5, turned), 0), 0.0, 1e-15);
  EXPECT_NEAR(strain_of(watch, lone(20, 16, turned), 20), whole / 2.0, 1e-15);
}

/// Theta of a window as its definition has it, joint by joint, with the part of each that it
/// covers.
double summed(const std::vector<chain::JointModel>& joints, const std::vector<JointFlow>& angles,
              std::size_t joint, double window) {
  const double middle = 0.5 * (joints[joint].begin + joints[joint].end);
  const double low = std::max(0.0, std::min(middle - 0.5 * window, joints.back().end - window));
  double sum = 0.0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double covered = std::min(low + window, joints[j].end) - std::max(low, joints[j].begin);
    if (covered > 0.0) sum += covered / (joints[j].end - joints[j].begin) * angles[j][0];
  }
  return sum;
}

TEST(BreakWatch, SumsWindowsOfJointsOfAnyLength) {
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (const int count : {1, 2, 3, 7, 60, 400}) {
    std::vector<chain::JointModel> joints = joints_of(count, {0.1, kNone, kNone, kNone});
    std::vector<double> ends{0.0};
    for (std::size_t j = 0; j < joints.size(); ++j) ends.push_back(ends.back() + number(draw));
    for (std::size_t j = 0; j < joints.size(); ++j) {
      joints[j].begin = ends[j] / ends.back();
      joints[j].end = ends[j + 1] / ends.back();
      joints[j].length.fill(joints[j].end - joints[j].begin);
    }
    for (const double window : {1e-3, 0.05, 0.3, 0.9, 1.0, 5.0}) {
      Scene scene = ideal_scene();
      scene.yield_model = YieldModel::Fibre;  // long joints spread theirs over the window
      scene.hinge_length = window;
      BreakWatch watch(scene, joints);
      std::vector<JointFlow> angles(joints.size());
      for (std::size_t j = 0; j < angles.size(); ++j) {
        if (j % 5 != 4) angles[j][0] = number(draw);
      }
      const std::vector<double> strain = strains_of(watch, angles);
      for (std::size_t j = 0; j < joints.size(); ++j) {
        const double theta = joints[j].own_length() < window
                                 ? summed(joints, angles, j, window)
                                 : angles[j][0] * window / joints[j].own_length();
        const double expected = kHeight / 2.0 * theta / window;
        EXPECT_NEAR(strain[j], expected, 1e-13 * (1.0 + expected)) << count << ' ' << window;
      }
    }
  }
}

TEST(BreakWatch, SeesNothingWhereNothingHasTurned) {
  // A sum that went on from window to window by taking away what leaves would keep its rounding.
  BreakWatch watch = watch_of(ideal_scene(), 500);
  std::vector<JointFlow> angles(501);
  for (std::size_t j = 0; j < 90; ++j) angles[j][0] = 1.0 / (3.0 + static_cast<double>(j));
  const std::vector<double> strain = strains_of(watch, angles);
  for (std::size_t j = 200; j < strain.size(); ++j) EXPECT_EQ(strain[j], 0.0) << j;
}

TEST(BreakWatch, KnowsTheStrainOfALoneJointWithoutTheOthers) {
  Scene fibres = ideal_scene();
  fibres.yield_model = YieldModel::Fibre;
  Scene own = ideal_scene();
  own.hinge_length = 0.0;
  for (const Scene& scene : {ideal_scene(), hardening_scene(), fibres, own}) {
    for (const int segments : {2, 4, 20, 33}) {
      const BreakWatch watch = watch_of(scene, segments);
      for (std::size_t joint = 0; joint < watch.size(); ++joint) {
        const JointFlow angle{0.03, -0.01, 0.02};
        EXPECT_EQ(watch.lone_strain(angle, joint),
                  strain_of(watch, lone(segments, joint, angle), joint));
      }
    }
  }
}

TEST(BreakWatch, CostsNoMoreWhereAHingeHoldsManyJoints) {
  // A million windows of a fifth of a million joints: minutes if each were summed alone.
  constexpr int kSegments = testing::kSanitized ? 20'000 : 1'000'000;
  BreakWatch watch = watch_of(ideal_scene(), kSegments);
  const auto angles = uniform(kSegments, 0.3);
  EXPECT_NEAR(watch.excess(angles), 0.3 * kHeight / 2.0 / 0.1 - 1.0, 1e-9);
}

TEST(BreakWatch, AddsTurnsOfOppositeSignsInAWindow) {
  BreakWatch watch = watch_of(ideal_scene(), 20);
  auto angles = lone(20, 10, {0.04, 0.0, 0.0});
  angles[11] = {-0.04, 0.0, 0.0};
  EXPECT_NEAR(strain_of(watch, angles, 10), 0.0, 1e-15);
}

TEST(BreakWatch, SplitsTheTurnOfALongJointIntoSpreadAndGathered) {
  // l = 1.25 L_p; the neighbours turn by 0.01, the hinge by 0.03.
  BreakWatch watch = watch_of(ideal_scene(), 4);
  auto angles = lone(4, 2, {0.03, 0.0, 0.0});
  angles[1] = {0.01, 0.0, 0.0};
  angles[3] = {0.004, 0.0, 0.0};
  EXPECT_NEAR(strain_of(watch, angles, 2), kHeight / 2.0 * (0.01 / 0.25 + 0.02 / kHeight), 1e-15);
  angles[1] = {-0.01, 0.0, 0.0};  // one that turns the other way shares nothing
  EXPECT_NEAR(strain_of(watch, angles, 2), kHeight / 2.0 * (0.004 / 0.25 + 0.026 / kHeight), 1e-15);
}

TEST(BreakWatch, TakesTheCurvatureOfTheJointWhereTheLawHardens) {
  for (const int segments : {4, 20}) {
    BreakWatch watch = watch_of(hardening_scene(), segments);
    const auto angles = lone(segments, 2, {0.03, 0.0, 0.0});
    EXPECT_NEAR(strain_of(watch, angles, 2), kHeight / 2.0 * 0.03 * segments, 1e-15) << segments;
  }
}

TEST(BreakWatch, TakesTheCurvatureOfALongJointAndTheWindowOfShortOnesWhereTheLawSaturates) {
  Scene scene = ideal_scene();
  scene.yield_model = YieldModel::Fibre;
  EXPECT_NEAR(strain_of(watch_of(scene, 4), lone(4, 2, {0.03, 0.0, 0.0}), 2),
              kHeight / 2.0 * 0.03 / 0.25, 1e-15);
  EXPECT_NEAR(strain_of(watch_of(scene, 20), lone(20, 2, {0.03, 0.0, 0.0}), 2),
              kHeight / 2.0 * 0.03 / kHeight, 1e-15);
}

TEST(BreakWatch, KnowsHowTheLawsSpread) {
  Scene scene = ideal_scene();
  EXPECT_EQ(localization_of(scene), Localization::Concentrated);
  scene.yield_model = YieldModel::Fibre;
  EXPECT_EQ(localization_of(scene), Localization::Saturating);
  EXPECT_EQ(localization_of(hardening_scene()), Localization::Distributed);
  scene = hardening_scene();
  scene.material.hardening.tangent_modulus = 0.0;
  EXPECT_EQ(localization_of(scene), Localization::Concentrated);
  scene.material.hardening.law = HardeningLaw::VoceChaboche;
  scene.material.hardening.backstress_modulus = {20e9, 0.0, 0.0};
  scene.material.hardening.backstress_rate = {300.0, 0.0, 0.0};
  EXPECT_EQ(localization_of(scene), Localization::Saturating);
  scene.material.hardening.backstress_modulus[1] = 1e9;
  EXPECT_EQ(localization_of(scene), Localization::Distributed);
}

TEST(BreakWatch, WithoutAHingeLengthTakesTheJointsOwn) {
  Scene scene = ideal_scene();
  scene.hinge_length = 0.0;
  BreakWatch watch = watch_of(scene, 20);
  EXPECT_NEAR(strain_of(watch, lone(20, 10, {0.04, 0.0, 0.0}), 10), kHeight / 2.0 * 0.04 / 0.05,
              1e-15);
  EXPECT_NEAR(strain_of(watch, lone(20, 0, {0.04, 0.0, 0.0}), 0), kHeight / 2.0 * 0.04 / 0.025,
              1e-15);
}

TEST(BreakWatch, TakesTheDepthForTheHingeLengthAndNoneWithTheReportsFormulas) {
  Scene scene = ideal_scene();
  EXPECT_EQ(watch_of(scene, 20).hinge_lengths(0)[0], kHeight);
  scene.hinge_length = 0.3;
  EXPECT_EQ(watch_of(scene, 20).hinge_lengths(0)[0], 0.3);
  scene.hinge_length.reset();
  scene.formulas = Formulas::Report;
  EXPECT_EQ(watch_of(scene, 20).hinge_lengths(0)[0], 0.0);
  scene.formulas = Formulas::Mechanics;
  // The depth of the section that owns the joint.
  std::vector<chain::JointModel> joints = joints_of(20, {0.1, kNone, kNone, kNone});
  joints[7].height = 0.06;
  const BreakWatch watch(scene, joints);
  EXPECT_EQ(watch.hinge_lengths(7)[0], 0.06);
  EXPECT_EQ(watch.hinge_lengths(8)[0], kHeight);
}

/// Joints whose windows hold a neighbour's hinge have its strain, but do not break for it.
TEST(BreakWatch, BreaksTheHingeAndNotTheJointsWhoseWindowsHoldIt) {
  for (const int segments : {20, 80, 320}) {
    BreakWatch watch = watch_of(ideal_scene(), segments, {0.01, kNone, kNone, kNone});
    for (const int at : {0, 1, segments / 2, segments - 1}) {
      const auto joint = static_cast<std::size_t>(at);
      const auto joints = watch.broken(lone(segments, joint, {0.03, 0.0, 0.0}));
      ASSERT_EQ(joints.size(), 1U) << segments << ' ' << at;
      EXPECT_EQ(joints[0].joint, at) << segments;
      EXPECT_NEAR(joints[0].strain, 0.015, 1e-15);
      EXPECT_NEAR(joints[0].angle[0], 0.03, 1e-15);
    }
    // Two hinges, further apart than a window is long.
    auto two = lone(segments, 0, {0.03, 0.0, 0.0});
    two[static_cast<std::size_t>(segments / 2)] = {0.03, 0.0, 0.0};
    EXPECT_EQ(watch.broken(two).size(), 2U) << segments;
    // Bent evenly, all break but the half joints at the ends, or these, too.
    EXPECT_GE(watch.broken(uniform(segments, 1.0)).size(), static_cast<std::size_t>(segments - 1));
  }
}

/// Nor do they where they have a limit and the hinge has none, or are deeper.
TEST(BreakWatch, BreaksNoElasticJointForANeighboursHinge) {
  auto joints = joints_of(80, {0.01, kNone, kNone, kNone});
  for (std::size_t j = 40; j < joints.size(); ++j) joints[j].limit[0] = kNone;
  BreakWatch watch(ideal_scene(), joints);
  EXPECT_LT(watch.excess(lone(80, 40, {0.9, 0.0, 0.0})), 0.0);
  EXPECT_TRUE(watch.broken(lone(80, 40, {0.9, 0.0, 0.0})).empty());
  EXPECT_GT(watch.excess(lone(80, 39, {0.9, 0.0, 0.0})), 0.0);
}

/// A joint that is far longer than its hinge holds it by itself.
TEST(BreakWatch, BreaksAJointOfManyHingeLengths) {
  Scene scene = ideal_scene();
  scene.hinge_length = 2e-4;
  BreakWatch watch = watch_of(scene, 20, {0.01, kNone, kNone, kNone});
  const auto angles = lone(20, 10, {1e-4, 0.0, 0.0});  // h/2 theta/L_p = 0.05
  EXPECT_GT(watch.excess(angles), 0.0);
  ASSERT_EQ(watch.broken(angles).size(), 1U);
  EXPECT_EQ(watch.broken(angles)[0].joint, 10);
}

/// A limit of torsion does not break what only bends, beside a hinge that is twisted.
TEST(BreakWatch, HoldsEachLimitAgainstItsOwnStrain) {
  BreakWatch watch = watch_of(ideal_scene(), 80, {kNone, kNone, 0.01, kNone});
  auto angles = lone(80, 40, {0.0, 0.0, 0.05});
  angles[41] = {0.5, 0.0, 0.0};
  const auto joints = watch.broken(angles);
  ASSERT_EQ(joints.size(), 1U);
  EXPECT_EQ(joints[0].joint, 40);
  EXPECT_TRUE(joints[0].cut);
}

/// What counts of a neighbour's hinge grows with the joint's own strain, without a jump that steps
/// would have to meet.
TEST(BreakWatch, CountsANeighboursHingeByWhatTheJointHasYieldedItself) {
  auto joints = joints_of(80, {0.01, kNone, kNone, kNone});
  for (std::size_t j = 40; j < joints.size(); ++j) joints[j].limit[0] = kNone;
  BreakWatch watch(ideal_scene(), joints);
  auto angles = lone(80, 40, {0.5, 0.0, 0.0});
  double before = watch.excess(angles);
  EXPECT_EQ(before, -1.0);
  for (double own = 0.0; own < 2e-5; own += 1e-6) {
    angles[39] = {own, 0.0, 0.0};
    const double now = watch.excess(angles);
    EXPECT_LT(now - before, 0.1) << own;
    before = now;
  }
  EXPECT_GT(before, -1.0);
}

/// Of a hinge that spreads the middle is cut, though all that yield are over their limits.
TEST(BreakWatch, CutsTheMiddleOfAHingeThatSpreads) {
  BreakWatch watch = watch_of(ideal_scene(), 80, {0.01, kNone, kNone, kNone});
  auto angles = lone(80, 40, {0.02, 0.0, 0.0});
  angles[39] = angles[41] = {0.01, 0.0, 0.0};
  const auto joints = watch.broken(angles);
  ASSERT_EQ(joints.size(), 3U);
  for (const BrokenJoint& joint : joints) EXPECT_EQ(joint.cut, joint.joint == 40);
}

/// One that was told of is not told of again by its neighbours.
TEST(BreakWatch, LeavesOutWhatBreaksForOthers) {
  BreakWatch watch = watch_of(ideal_scene(), 80, {0.01, kNone, kNone, kNone});
  const auto angles = lone(80, 40, {0.03, 0.0, 0.0});
  std::vector<bool> known(81, false);
  EXPECT_GT(watch.excess(angles, known), 0.0);
  known[40] = true;
  EXPECT_LT(watch.excess(angles, known), 0.0);
}

}  // namespace
}  // namespace plastica
