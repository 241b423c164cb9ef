#include "plastica/report/beam_pose.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/motion_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::motion_record;

double distance(const Point3& a, const Point3& b) {
  const Point3 displacement = sum(a, -1.0, b);
  return std::sqrt(dot(displacement, displacement));
}

TEST(BeamPose, OfAWholeBeamJoinsEachSegmentToTheNext) {
  const io::SceneRecord record = motion_record({.segments = 8});
  for (const std::size_t frame : {kUndeformed, std::size_t{0}, std::size_t{7}}) {
    const BeamPose pose(record, frame);
    ASSERT_EQ(pose.segments(), 8U);
    EXPECT_EQ(pose.fragments(), (std::vector<Fragment>{{0, 7}}));
    for (std::size_t i = 0; i + 1 < 8; ++i) EXPECT_EQ(pose.outer(i), pose.inner(i + 1)) << i;
  }
}

TEST(BeamPose, GivesASegmentBeforeACutTheEndToWhichItsRotationTakesIt) {
  const io::SceneRecord record = motion_record({.segments = 8});
  const BeamPose pose(record, 20);
  EXPECT_DOUBLE_EQ(pose.time(), 0.2);
  EXPECT_EQ(pose.fragments(), (std::vector<Fragment>{{0, 3}, {4, 5}, {6, 7}}));
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(distance(pose.inner(i), pose.outer(i)), 0.125, 1e-12) << i;
  }
  // The motion moves the outer fragment down by 5 g t^2 and away.
  EXPECT_TRUE(pose.is_cut(4) && pose.is_cut(6) && !pose.is_cut(5));
  EXPECT_NEAR(pose.outer(3)[1] - pose.inner(4)[1], 5.0 * 9.81 * 0.12 * 0.12, 1e-12);
  EXPECT_NEAR(pose.inner(4)[2] - pose.outer(3)[2], 0.8 * 0.12, 1e-12);
  EXPECT_EQ(pose.outer(4), pose.inner(5));
}

TEST(BeamPose, PutsAPlaceAtACutOnTheSegmentBeforeIt) {
  const io::SceneRecord record = motion_record({.segments = 8});
  const BeamPose pose(record, 20);
  EXPECT_EQ(pose.segment_at(0.5), 3U);
  EXPECT_LT(distance(pose.point_at(0.5), pose.outer(3)), 1e-12);
  EXPECT_LT(distance(pose.point_at(0.0), pose.inner(0)), 1e-12);
  EXPECT_LT(distance(pose.point_at(1.0), pose.outer(7)), 1e-12);
  const Point3 middle = sum(sum({}, 0.5, pose.inner(4)), 0.5, pose.outer(4));
  EXPECT_LT(distance(pose.point_at(0.5625), middle), 1e-12);
}

TEST(BeamPose, HasAnAxisForEachFragment) {
  const io::SceneRecord record = motion_record({.segments = 8});
  const Eye side{{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
  const auto axes = BeamPose(record, 20).axes(side);
  ASSERT_EQ(axes.size(), 3U);
  EXPECT_EQ(axes[0].size(), 5U);
  EXPECT_EQ(axes[1].size(), 3U);
  EXPECT_NE(axes[0].back(), axes[1].front());
}

}  // namespace
}  // namespace plastica::report
