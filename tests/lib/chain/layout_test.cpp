#include "plastica/chain/layout.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/chain.hpp"

namespace plastica::chain {
namespace {

using testing::cantilever;

Layout layout_of(const Scene& scene) { return make_layout(scene, segment_ends(scene)); }

TEST(Layout, GivesEachInnerJointHalfOfBothSegmentsAndTheEndsHalfOfOne) {
  Scene scene = cantilever(4, {});
  scene.beam.segment_fractions = {0.1, 0.2, 0.3, 0.4};
  const Layout layout = layout_of(scene);
  const std::vector<double> expected{0.05, 0.15, 0.25, 0.35, 0.2};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(layout.joint_length[i], expected[i], 1e-15) << i;
  }
}

TEST(Layout, GivesEndSegmentsWholeToTheirOnlyJoint) {
  Scene scene = cantilever(5, {});
  scene.end_rule = EndRule::Half;
  const Layout half = layout_of(scene);  // 1/8, 1/4, 1/4, 1/4, 1/8
  EXPECT_NEAR(half.segment_length[0], 0.125, 1e-15);
  EXPECT_NEAR(half.joint_length[1], 0.25, 1e-15);
  EXPECT_NEAR(half.joint_length[4], 0.25, 1e-15);
  scene.end_rule = EndRule::ThreeHalves;
  const Layout whole = layout_of(scene);
  EXPECT_NEAR(whole.joint_length[1], 0.3, 1e-15);
  EXPECT_NEAR(whole.joint_length[2], 0.2, 1e-15);
  EXPECT_NEAR(whole.joint_length[4], 0.3, 1e-15);
}

TEST(Layout, InscribesTheSegmentsOfAnArcAndPutsItsJointsAlongTheTangent) {
  Scene scene = cantilever(6, {});
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 1.2;
  const Layout layout = layout_of(scene);
  const double radius = 1.0 / 1.2;
  for (std::size_t i = 0; i <= 6; ++i) {
    const double turned = 0.2 * static_cast<double>(i);
    EXPECT_NEAR(layout.node[i][2], radius * std::sin(turned), 1e-14);
    EXPECT_NEAR(layout.node[i][1], radius * (1.0 - std::cos(turned)), 1e-14);
    // z of the joint's axes is the tangent (0, sin, cos).
    EXPECT_NEAR(layout.joint_frame[i](1, 2), std::sin(turned), 1e-14);
    EXPECT_NEAR(layout.joint_frame[i](2, 2), std::cos(turned), 1e-14);
  }
  // A segment's arm is its chord, along its own z.
  const SegmentPoint outer = segment_point(layout, 1.0 / 6.0);
  EXPECT_EQ(outer.segment, 0U);
  EXPECT_NEAR(outer.arm[2], 2.0 * radius * std::sin(0.1), 1e-14);
  EXPECT_NEAR(outer.arm[1], 0.0, 1e-15);
}

TEST(Layout, FindsTheSegmentOfAPoint) {
  const Layout layout = layout_of(cantilever(4, {}));
  EXPECT_EQ(segment_point(layout, 0.0).segment, 0U);
  EXPECT_EQ(segment_point(layout, 0.25).segment, 0U);  // a node belongs to the segment before it
  EXPECT_EQ(segment_point(layout, 0.26).segment, 1U);
  EXPECT_EQ(segment_point(layout, 1.0).segment, 3U);
  EXPECT_NEAR(segment_point(layout, 0.3).arm[2], 0.05, 1e-15);
}

TEST(Layout, LetsTheLastRegionThatHoldsAPointWin) {
  Scene scene = cantilever(4, {});
  scene.regions.push_back({{0.5, {}}, Place::end(), scene.section, scene.material});
  scene.regions.push_back({{0.75, {}}, Place::end(), scene.section, scene.material});
  const Layout layout = layout_of(scene);
  ASSERT_EQ(layout.regions.size(), 3U);
  const std::vector<std::size_t> expected{0, 0, 1, 2};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(layout.segment_regions[i].middle, expected[i]);
    EXPECT_EQ(layout.segment_regions[i].inner, expected[i]);
    EXPECT_EQ(layout.segment_regions[i].outer, expected[i]);
  }
}

TEST(Layout, GivesEachSegmentAndJointOfATaperItsOwnSection) {
  Scene scene = cantilever(4, {});
  scene.section.height = 0.1;
  scene.regions.push_back({{0.5, {}}, Place::end(), scene.section, scene.material});
  scene.regions[0].to_section = scene.section;
  scene.regions[0].to_section->height = 0.02;
  const Layout layout = layout_of(scene);
  const auto height = [&](std::size_t region) { return layout.regions[region].section.height; };
  EXPECT_EQ(layout.segment_regions[1].outer, 0U);
  EXPECT_DOUBLE_EQ(height(layout.segment_regions[2].inner), 0.1);
  EXPECT_DOUBLE_EQ(height(layout.segment_regions[2].middle), 0.08);
  EXPECT_DOUBLE_EQ(height(layout.segment_regions[2].outer), 0.06);
  EXPECT_EQ(layout.segment_regions[3].inner, layout.segment_regions[2].outer);
  EXPECT_DOUBLE_EQ(height(layout.segment_regions[3].outer), 0.02);
  for (std::size_t region = 1; region < layout.regions.size(); ++region) {
    EXPECT_EQ(layout.regions[region].scene_region, 1U);
  }
}

}  // namespace
}  // namespace plastica::chain
