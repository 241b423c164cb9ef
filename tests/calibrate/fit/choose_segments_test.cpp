#include "calibrate/fit/choose_segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/support/message.hpp"

// Against a curve of so many segments that it counts as that of a continuous beam.

namespace plastica::calibrate {
namespace {

using testing::all_three;
using testing::bend_test;
using testing::measured;
using testing::Truth;

constexpr int kContinuous = 640;

SceneFitOptions options_of_a_trial() { return {.parameters = all_three(), .starts = 1}; }

/// The largest error of the values that a number of segments gives, over the truth.
double true_error(int segments, const SceneTarget& target) {
  SceneFitOptions options = options_of_a_trial();
  options.segments_error = false;
  const double strain =
      fit_scene(bend_test(kContinuous), target, options).parameter("break_strain").value;
  const SceneFitResult fit = fit_scene(bend_test(segments), target, options);
  const auto off = [&](const char* name, double truth) {
    return std::abs(fit.parameter(name).value / truth - 1.0);
  };
  return std::max({off("youngs_modulus", Truth{}.youngs_modulus),
                   off("yield_stress", Truth{}.yield_stress), off("break_strain", strain)});
}

TEST(ChooseSegments, FindsTheFewestThatKeepEachValueWithinWhatIsAsked) {
  const SceneTarget target = measured(bend_test(kContinuous));
  constexpr double kWithin = 0.005;
  const std::vector<WeightedTarget> targets{{bend_test(32), target}};
  const std::vector<SegmentsTrial> trials = choose_segments(targets, options_of_a_trial(), kWithin);
  ASSERT_GT(trials.size(), 1U);
  EXPECT_LE(trials.size(), 4U);
  const SegmentsTrial& chosen = trials.back();
  EXPECT_LE(chosen.moved, kWithin);
  EXPECT_LE(true_error(chosen.segments, target), kWithin) << chosen.segments;
  // Not many more than are needed: with half as many the values are off by more.
  EXPECT_GT(true_error(chosen.segments / 2, target), kWithin);
}

TEST(ChooseSegments, SaysWhereNoNumberDoes) {
  const SceneTarget target = measured(bend_test(40));
  const std::vector<WeightedTarget> targets{{bend_test(40), target}};
  SceneFitOptions options = options_of_a_trial();
  options.parameters.resize(1);  // a yield stress that is fixed is the scene's own
  const std::vector<SegmentsTrial> trials = choose_segments(targets, options, 1e-9);
  ASSERT_FALSE(trials.empty());
  EXPECT_GT(trials.back().moved, 1e-9);
}

TEST(ChooseSegments, RefusesWhatHasNoNumberToChoose) {
  const SceneTarget target = measured(bend_test(8));
  std::vector<WeightedTarget> targets{{bend_test(8), target}};
  targets[0].setup.scene.beam.segment_fractions.assign(8, 0.125);
  EXPECT_EQ(
      testing::message_of([&] { (void)choose_segments(targets, options_of_a_trial(), 0.01); }),
      "fit.segments = 8: is not for a scene that gives the lengths of its segments or joints "
      "(bar)");
}

// The end of segment 4 of 8 is another place among 16.
TEST(ChooseSegments, RefusesToMoveWhatStandsAtASegmentByItsNumber) {
  const SceneTarget target = measured(bend_test(8));
  std::vector<WeightedTarget> targets{{bend_test(8), target}};
  targets[0].setup.scene.probes[0].at = {0.0, 4};
  set_segments(8, targets);
  EXPECT_EQ(
      testing::message_of([&] { set_segments(16, targets); }),
      "fit.segments = 16: moves the scene's probe.at, the end of a segment by its number: give "
      "it as a fraction (bar)");
}

}  // namespace
}  // namespace plastica::calibrate
