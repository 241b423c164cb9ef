#include "plastica/model/beam_axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plastica {
namespace {

constexpr double kRounding = 1e-15;  // of a metre, a few units in the last place

Scene scene_of(int segments, EndRule rule = EndRule::Auto) {
  Scene scene;
  scene.beam.segments = segments;
  scene.end_rule = rule;
  return scene;
}

TEST(SegmentEnds, DivideABeamEvenly) {
  EXPECT_EQ(segment_ends(scene_of(4)), (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
  EXPECT_EQ(segment_ends(scene_of(1)), (std::vector<double>{0.0, 1.0}));
}

TEST(SegmentEnds, FollowTheFractionsOfTheSegments) {
  Scene scene = scene_of(3);
  scene.beam.segment_fractions = {0.5, 0.25, 0.25};
  EXPECT_EQ(segment_ends(scene), (std::vector<double>{0.0, 0.5, 0.75, 1.0}));
}

TEST(SegmentEnds, HalveTheEndSegmentsByTheRuleHalf) {
  EXPECT_EQ(segment_ends(scene_of(5, EndRule::Half)),
            (std::vector<double>{0.0, 0.125, 0.375, 0.625, 0.875, 1.0}));
  EXPECT_EQ(segment_ends(scene_of(2, EndRule::Half)), (std::vector<double>{0.0, 0.5, 1.0}));
}

TEST(SegmentEnds, AreEvenWhereThatEndsThemAtAllPlaces) {
  Scene scene = scene_of(10);
  scene.regions.push_back({.from = {0.3, {}}, .to = {0.7, {}}});
  scene.loads.push_back({.at = {1.0 / 2.0, {}}});
  scene.supports.push_back({.at = {0.1 + 0.2, {}}});
  EXPECT_EQ(segment_ends(scene), segment_ends(scene_of(10)));
  // A segment's number says where it is, whatever its length.
  scene.loads.push_back({.at = {0.0, 3}});
  EXPECT_EQ(segment_ends(scene), segment_ends(scene_of(10)));
}

void expect_ends(const Scene& scene, const std::vector<double>& expected) {
  const std::vector<double> ends = segment_ends(scene);
  ASSERT_EQ(ends.size(), expected.size());
  for (std::size_t i = 0; i < ends.size(); ++i) EXPECT_NEAR(ends[i], expected[i], kRounding) << i;
}

TEST(SegmentEnds, FallOnRegionsSupportsLoadsAndCorners) {
  Scene scene = scene_of(5);
  scene.regions.push_back({.from = {0.0, {}}, .to = {0.04, {}}});
  expect_ends(scene, {0.0, 0.04, 0.28, 0.52, 0.76, 1.0});
  scene.regions.clear();
  scene.supports.push_back({.at = {0.3, {}}});
  scene.loads.push_back({.at = {0.7, {}}, .to = Place{0.9, {}}});
  // Stretches of 0.3, 0.4, 0.2, 0.1: the fifth segment halves the longest.
  expect_ends(scene, {0.0, 0.3, 0.5, 0.7, 0.9, 1.0});
  EXPECT_EQ(segment_end_at({0.7, {}}, segment_ends(scene)), 3);
  Scene bent = scene_of(3);
  bent.beam.shape = BeamShape::Polyline;
  bent.beam.points = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.75}, {0.0, 0.25, 0.75}};
  expect_ends(bent, {0.0, 0.375, 0.75, 1.0});
}

TEST(SegmentEnds, FallOnPointMasses) {
  Scene scene = scene_of(3);
  scene.masses.push_back({{0.4, {}}, 1.0, {}});
  expect_ends(scene, {0.0, 0.4, 0.7, 1.0});
}

TEST(SegmentEnds, AreAsShortAtMostAsTheDealAllows) {
  // No other deal of N segments to three stretches has a shorter longest segment.
  for (const double a : {0.013, 0.211, 0.449, 0.62}) {
    for (int segments = 3; segments < 40; ++segments) {
      Scene scene = scene_of(segments);
      const double b = a + 0.31;
      scene.regions.push_back({.from = {a, {}}, .to = {b, {}}});
      const std::vector<double> ends = segment_ends(scene);
      ASSERT_EQ(ends.size(), static_cast<std::size_t>(segments) + 1);
      double longest = 0.0;
      for (std::size_t i = 1; i < ends.size(); ++i) {
        EXPECT_GT(ends[i], ends[i - 1]);
        longest = std::max(longest, ends[i] - ends[i - 1]);
      }
      double best = 1.0;
      for (int i = 1; i < segments; ++i) {
        for (int j = 1; i + j < segments; ++j) {
          best = std::min(best, std::max({a / i, (b - a) / j, (1.0 - b) / (segments - i - j)}));
        }
      }
      EXPECT_NEAR(longest, best, 4.0 * kRounding) << a << ' ' << segments;
    }
  }
}

TEST(SegmentEnds, HalveTheEndSegmentsOfUnevenOnesToo) {
  Scene scene = scene_of(6, EndRule::Half);
  scene.loads.push_back({.at = {0.3, {}}});
  // 2 and 4: 0.1, 0.2 | 0.2, 0.2, 0.2, 0.1.
  expect_ends(scene, {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0});
}

TEST(Places, AreFoundByNumberAndByFraction) {
  const std::vector<double> ends = segment_ends(scene_of(10));
  EXPECT_EQ(fraction_of({0.0, 3}, ends), ends[3]);
  EXPECT_EQ(fraction_of({0.31, {}}, ends), 0.31);
  EXPECT_EQ(fraction_of({0.3000000001, {}}, ends), ends[3]);
  EXPECT_EQ(fraction_of({1e-10, {}}, ends), 0.0);
  EXPECT_EQ(segment_end_at({0.1 + 0.2, {}}, ends), 3);
  EXPECT_EQ(segment_end_at({1.0, {}}, ends), 10);
  EXPECT_EQ(segment_end_at({0.0, {}}, ends), 0);
  EXPECT_EQ(segment_end_at({0.35, {}}, ends), std::nullopt);
  EXPECT_EQ(segment_end_at({0.300001, {}}, ends), std::nullopt);
}

TEST(Places, HaveANearestSegmentEnd) {
  const std::vector<double> ends = segment_ends(scene_of(4));
  EXPECT_EQ(nearest_segment_end({0.0, 3}, ends), 3);
  EXPECT_EQ(nearest_segment_end({0.38, {}}, ends), 2);
  EXPECT_EQ(nearest_segment_end({0.375, {}}, ends), 1);
  EXPECT_EQ(nearest_segment_end({1.0, {}}, ends), 4);
  EXPECT_EQ(nearest_segment_end({0.0, {}}, ends), 0);
}

TEST(AxisPoint, RunsAlongZWhereTheBeamIsStraight) {
  Beam beam;
  beam.length = 3.0;
  EXPECT_EQ(axis_point(beam, 0.5), (std::array<double, 3>{0.0, 0.0, 1.5}));
}

TEST(AxisPoint, TurnsTowardsTheSideOfAnArc) {
  Beam beam;
  beam.shape = BeamShape::Arc;
  beam.arc_angle = std::numbers::pi / 2.0;
  beam.length = 100.0 * beam.arc_angle;
  beam.arc_towards = {0.6, 0.8, 0.0};
  const auto end = axis_point(beam, 1.0);
  EXPECT_NEAR(end[0], 60.0, 100.0 * kRounding);
  EXPECT_NEAR(end[1], 80.0, 100.0 * kRounding);
  EXPECT_NEAR(end[2], 100.0, 100.0 * kRounding);
  const auto middle = axis_point(beam, 0.5);
  EXPECT_NEAR(middle[2], 100.0 * std::sqrt(0.5), 100.0 * kRounding);
  EXPECT_NEAR(middle[1], 80.0 * (1.0 - std::sqrt(0.5)), 100.0 * kRounding);
}

TEST(AxisPoint, FollowsAPolyline) {
  Beam beam;
  beam.shape = BeamShape::Polyline;
  beam.points = {{0.0, 0.0, 0.0}, {0.0, 3.0, 4.0}, {0.0, 3.0, 9.0}};
  beam.length = polyline_length(beam.points);
  EXPECT_EQ(beam.length, 10.0);
  EXPECT_EQ(axis_point(beam, 0.25), (std::array<double, 3>{0.0, 1.5, 2.0}));
  EXPECT_EQ(axis_point(beam, 0.5), (std::array<double, 3>{0.0, 3.0, 4.0}));
  EXPECT_EQ(axis_point(beam, 1.0), (std::array<double, 3>{0.0, 3.0, 9.0}));
}

}  // namespace
}  // namespace plastica
