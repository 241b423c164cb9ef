#include "plastica/report/beam_solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/motion_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::cantilever_text;
using plastica::testing::motion_record;
using plastica::testing::record_of;

/// From the side: z to the right, y up, x away.
constexpr Eye kSide{{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};

double area(const std::vector<Point2>& corners) {
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2& a = corners[i];
    const Point2& b = corners[(i + 1) % corners.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * std::fabs(twice);
}

TEST(BeamSolid, OfAnUndeformedBeamIsItsSideView) {
  const io::SceneRecord record = record_of(cantilever_text());
  const BeamSolid solid = beam_solid(BeamPose(record, kUndeformed), kSide, 1.0);
  ASSERT_EQ(solid.faces.size(), 8U);  // two halves a segment, the ends are seen edge-on
  double sum = 0.0;
  for (const Face& face : solid.faces) sum += area(face.corners);
  EXPECT_NEAR(sum, 1.0 * 0.02, 1e-12);
}

TEST(BeamSolid, GivesEachHalfSegmentToTheJointAtItsEnd) {
  const io::SceneRecord record = record_of(cantilever_text());
  const BeamSolid solid = beam_solid(BeamPose(record, kUndeformed), kSide, 1.0);
  std::vector<std::size_t> joints;
  for (const Face& face : solid.faces) joints.push_back(face.joint);
  std::sort(joints.begin(), joints.end());
  EXPECT_EQ(joints, (std::vector<std::size_t>{0, 1, 1, 2, 2, 3, 3, 4}));
}

TEST(BeamSolid, IsDrawnThickerWhereAsked) {
  const io::SceneRecord record = record_of(cantilever_text());
  double sum = 0.0;
  for (const Face& face : beam_solid(BeamPose(record, kUndeformed), kSide, 5.0).faces) {
    sum += area(face.corners);
  }
  EXPECT_NEAR(sum, 5.0 * 0.02, 1e-12);
}

TEST(BeamSolid, TurnsASectionWithItsSegment) {
  io::SceneRecord record = record_of(cantilever_text());
  // The last sample: all segments turned about the beam by an eighth of a circle, otherwise still.
  auto& chain = record.response.chain;
  const std::size_t last = chain.time.size() - 1;
  for (std::size_t i = 0; i < 4; ++i) {
    chain.rotation[(last * 4 + i) * 3] = 0.0;
    chain.rotation[(last * 4 + i) * 3 + 2] = std::numbers::pi / 4.0;
  }
  std::copy(record.outline.node.begin(), record.outline.node.end(),
            chain.position.begin() + static_cast<std::ptrdiff_t>(last * 5 * 3));
  const BeamSolid solid = beam_solid(BeamPose(record, last), kSide, 1.0);
  EXPECT_EQ(solid.faces.size(), 16U);  // now two sides are seen
  double most = 0.0;
  for (const Face& face : solid.faces) {
    for (const Point2& corner : face.corners) most = std::max(most, corner[1]);
  }
  EXPECT_NEAR(most, 0.01 * std::numbers::sqrt2, 1e-12);
}

TEST(BeamSolid, DrawsTheNearestFacesLast) {
  const double c = std::sqrt(0.5);
  const Eye from_above{{0.0, 0.0, 1.0}, {c, c, 0.0}, {c, -c, 0.0}};
  const io::SceneRecord record = record_of(cantilever_text());
  const BeamSolid solid = beam_solid(BeamPose(record, kUndeformed), from_above, 1.0);
  EXPECT_EQ(solid.faces.size(), 16U);
  EXPECT_TRUE(std::is_sorted(solid.faces.begin(), solid.faces.end(),
                             [](const Face& a, const Face& b) { return a.depth > b.depth; }));
}

TEST(BeamSolid, DrawsManySegmentsInGroups) {
  std::string text = cantilever_text();
  text.replace(text.find("segments = 4"), 12, "segments = 1000");
  text.replace(text.find("at = { segment = 4 }"), 20, "at = \"end\"");
  const io::SceneRecord record = record_of(text);
  const BeamSolid solid = beam_solid(BeamPose(record, kUndeformed), kSide, 1.0);
  EXPECT_LE(solid.faces.size(), 300U);
  double sum = 0.0;
  for (const Face& face : solid.faces) sum += area(face.corners);
  EXPECT_NEAR(sum, 0.02, 1e-9);
}

TEST(BeamSolid, OfFragmentsHasTheEndsThatCutsHaveMade) {
  const io::SceneRecord record = motion_record({.segments = 8});
  const BeamSolid whole = beam_solid(BeamPose(record, 0), kSide, 1.0);
  EXPECT_TRUE(whole.cuts.empty());
  EXPECT_EQ(whole.segments.size(), 2U * 7U);  // from both sides
  const BeamSolid fragments = beam_solid(BeamPose(record, 20), kSide, 1.0);
  EXPECT_EQ(fragments.cuts.size(), 4U);  // two cuts, two ends each, seen edge-on
  EXPECT_EQ(fragments.segments.size(), 2U * 5U);
  double sum = 0.0;
  for (const Face& face : fragments.faces) sum += area(face.corners);
  EXPECT_NEAR(sum, 0.02, 1e-9) << "no face spans a gap";
}

TEST(BeamSolid, GroupsNoSegmentsAcrossACut) {
  const io::SceneRecord record = motion_record({.segments = 500});
  const BeamSolid fragments = beam_solid(BeamPose(record, 20), kSide, 1.0);
  EXPECT_LE(fragments.faces.size(), 270U);
  EXPECT_EQ(fragments.cuts.size(), 4U);
}

}  // namespace
}  // namespace plastica::report
