#include "sweeps/advise/grading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "plastica/model/beam_axis.hpp"

namespace plastica::sweeps {
namespace {

Scene straight(int segments) {
  Scene scene;
  scene.beam.segments = segments;
  scene.supports = {{}};
  return scene;
}

/// Rotations of the joints of a beam with some curvature over its length.
std::vector<double> bent_by(const Scene& scene, const std::function<double(double)>& curvature) {
  const std::vector<double> ends = segment_ends(scene);
  std::vector<double> bent;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double before = i > 0 ? ends[i] - ends[i - 1] : 0.0;
    const double after = i + 1 < ends.size() ? ends[i + 1] - ends[i] : 0.0;
    bent.push_back(curvature(ends[i]) * 0.5 * (before + after));
  }
  return bent;
}

TEST(Grading, HasTheLengthsWhoseSumOfCubesTimesTheChangeIsLeast) {
  // k = exp(-s/a): |k'| over its mean is exp(-s/a)/a, but for exp(-10); lengths go with the inverse
  // cube root of that and 0.03.
  constexpr double kDecay = 0.1;
  const Scene scene = straight(400);
  const auto bent = bent_by(scene, [&](double s) { return std::exp(-s / kDecay); });
  const std::vector<double> lengths = graded_fractions(scene, bent, 50);
  ASSERT_EQ(lengths.size(), 50u);
  EXPECT_NEAR(std::accumulate(lengths.begin(), lengths.end(), 0.0), 1.0, 1e-12);
  const auto density = [&](double s) { return std::cbrt(std::exp(-s / kDecay) / kDecay + 0.03); };
  double end = 0.0;
  const double first = lengths.front() * density(0.5 * lengths.front());
  for (const double length : lengths) {
    EXPECT_NEAR(length * density(end + 0.5 * length), first, 0.03 * first) << "at " << end;
    end += length;
  }
}

TEST(Grading, LeavesEvenWhatChangesEvenly) {
  const Scene scene = straight(40);
  const auto bent = bent_by(scene, [](double s) { return 1.0 - s; });
  for (const double length : graded_fractions(scene, bent, 16)) {
    EXPECT_NEAR(length, 1.0 / 16.0, 1e-4);
  }
}

TEST(Grading, HasNothingToGradeWhereTheCurvatureDoesNotChange) {
  const Scene scene = straight(40);
  EXPECT_TRUE(graded_fractions(scene, std::vector<double>(41, 0.0), 16).empty());
}

TEST(Grading, EndsSegmentsWhereTheSceneNeedsIt) {
  Scene scene = straight(40);
  scene.loads = {{.at = {0.37, {}}}, {.at = {1.0 / 3.0, {}}}};
  Probe probe;
  probe.at = {0.41, {}};
  scene.probes = {probe, probe};
  const auto bent = bent_by(scene, [](double s) { return std::exp(-20.0 * std::abs(s - 0.37)); });
  for (const int segments : {4, 7, 24}) {
    const std::vector<double> lengths = graded_fractions(scene, bent, segments);
    ASSERT_EQ(lengths.size(), static_cast<std::size_t>(segments));
    Scene graded = scene;
    graded.beam.segments = segments;
    graded.beam.segment_fractions = lengths;
    const std::vector<double> ends = segment_ends(graded);
    for (const Load& load : scene.loads) EXPECT_TRUE(segment_end_at(load.at, ends)) << segments;
    EXPECT_TRUE(segment_end_at(probe.at, ends)) << segments;
  }
  EXPECT_TRUE(graded_fractions(scene, bent, 3).empty());
}

TEST(Grading, DoesNotTakeAHingesTurnForBending) {
  Scene scene = straight(40);
  scene.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Hinge});
  std::vector<double> bent = bent_by(scene, [](double s) { return 1.0 - s; });
  bent[20] = 1.0;
  for (const double length : graded_fractions(scene, bent, 16)) {
    EXPECT_NEAR(length, 1.0 / 16.0, 1e-4);
  }
}

TEST(Grading, DoesNotRefineWhereTheSectionChanges) {
  Scene scene = straight(40);
  scene.regions.push_back({.from = {0.5, {}}});
  const auto bent = bent_by(scene, [](double s) { return (s < 0.5 ? 1.0 : 5.0) * (2.0 - s); });
  const std::vector<double> lengths = graded_fractions(scene, bent, 16);
  ASSERT_EQ(lengths.size(), 16u);
  // Five times the change takes 5^(1/3) of the length; nothing is shorter at the edge.
  const auto [least, most] = std::ranges::minmax(lengths);
  EXPECT_LT(most / least, 1.25 * std::cbrt(5.0));
}

TEST(Grading, EndsEvenSegmentsAtProbesOfAPlaceWhereNoneDo) {
  Scene scene = straight(8);
  Probe probe;
  probe.quantity = ProbeQuantity::Moment;
  probe.at = {0.25, {}};
  scene.probes = {probe};
  EXPECT_TRUE(ends_at_probes(scene));
  EXPECT_TRUE(fractions_that_end_at_probes(scene).empty());
  scene.probes[0].at = {0.37, {}};
  EXPECT_FALSE(ends_at_probes(scene));
  const std::vector<double> lengths = fractions_that_end_at_probes(scene);
  ASSERT_EQ(lengths.size(), 8u);
  scene.beam.segment_fractions = lengths;
  EXPECT_TRUE(ends_at_probes(scene));
  EXPECT_NEAR(lengths[0], 0.37 / 3.0, 1e-12);
  EXPECT_NEAR(lengths[7], 0.63 / 5.0, 1e-12);
  scene.beam.segment_fractions.clear();
  for (const auto quantity : {ProbeQuantity::Displacement, ProbeQuantity::Spin}) {
    scene.probes[0].quantity = quantity;
    EXPECT_FALSE(ends_at_probes(scene));
  }
  scene.probes[0].quantity = ProbeQuantity::Energy;  // of the whole beam
  EXPECT_TRUE(ends_at_probes(scene));
}

TEST(Grading, DividesTheSegmentsOfShortStretches) {
  Scene scene = straight(4);
  scene.loads = {{.at = {0.03, {}}}};
  ASSERT_EQ(segment_ends(scene)[1], 0.03);
  scene.beam.segments = 8;
  ASSERT_EQ(segment_ends(scene)[1], 0.03);  // more segments alone leave it whole
  scene.beam.segments = 4;
  Scene fine = with_divided_segments(scene, 2);
  EXPECT_EQ(fine.beam.segments, 8);
  EXPECT_NEAR(segment_ends(fine)[1], 0.015, 1e-15);
  scene.loads[0].at = {0.25, {}};
  fine = with_divided_segments(scene, 4);
  EXPECT_EQ(fine.beam.segments, 16);
  EXPECT_TRUE(fine.beam.segment_fractions.empty());
  scene.end_rule = EndRule::Half;
  EXPECT_TRUE(with_divided_segments(scene, 4).beam.segment_fractions.empty());
  Probe probe;
  probe.quantity = ProbeQuantity::Stress;
  probe.at = {0.9, {}};
  scene.probes = {probe};
  scene.end_rule = EndRule::Auto;
  fine = with_divided_segments(scene, 4);
  EXPECT_EQ(fine.beam.segments, 17);
  EXPECT_TRUE(ends_at_probes(fine));
}

TEST(Grading, DividesEachSegment) {
  EXPECT_EQ(divided_evenly({0.25, 0.75}, 2), (std::vector<double>{0.125, 0.125, 0.375, 0.375}));
}

}  // namespace
}  // namespace plastica::sweeps
