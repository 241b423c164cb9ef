#include "calibrate/inference/scene_segments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "plastica/theory/lumped_chain.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/calibrate/inference/elastic_cantilever.hpp"

// What the number of segments does to the parameters of a fit.

namespace plastica::calibrate {
namespace {

using testing::all_three;
using testing::bend_test;
using testing::cantilever;
using testing::continuous;
using testing::coverage;
using testing::kModulus;
using testing::measured;
using testing::stiffness;
using testing::stiffness_and_yield;

TEST(SceneSegments, ExtrapolateTheStiffnessThatALumpedCantileverMakesUpFor) {
  // The chain's tip gives way by 1 + 1/(2 N^2) too much, so the fitted modulus is too large by it.
  constexpr int kSegments = 8;
  const SceneFitResult fit = fit_scene(cantilever(kSegments), continuous(), stiffness());
  ASSERT_TRUE(fit.segments);
  EXPECT_EQ(fit.segments->segments, kSegments);
  EXPECT_EQ(fit.segments->note, "");
  const SegmentsError& error = fit.segments->parameters.at(0);
  const auto expected = [](int count) {
    return kModulus * theory::tip_force_ratio(theory::ChainConvention::HalfJoint, count);
  };
  // Finite rotations and the end of the search.
  constexpr double kSame = 1e-8;
  EXPECT_NEAR(error.at_half / expected(kSegments / 2), 1.0, kSame);
  EXPECT_NEAR(error.at_own / expected(kSegments), 1.0, kSame);
  EXPECT_NEAR(error.at_twice / expected(2 * kSegments), 1.0, kSame);
  EXPECT_EQ(error.at_own, fit.parameters[0].value);
  EXPECT_EQ(error.trend, SegmentsTrend::Monotone);
  EXPECT_NEAR(error.observed_order, 2.0, 1e-4);
  EXPECT_NEAR(error.extrapolated / kModulus, 1.0, 1e-7);
  EXPECT_NEAR(error.error / (expected(kSegments) - kModulus), 1.25, 1e-4);
  // Without noise this is all that is wrong with it.
  EXPECT_EQ(fit.parameters[0].verdict(), Verdict::LimitedBySegments);
  EXPECT_DOUBLE_EQ(fit.parameters[0].verdict_number(), error.error / fit.parameters[0].value);
}

TEST(SceneSegments, ObserveTheFirstOrderOfAClampedEnd) {
  plastica::Setup setup = cantilever(16);
  setup.scene.end_rule = EndRule::Equal;
  const SceneFitResult fit = fit_scene(setup, continuous(), stiffness());
  const SegmentsError& error = fit.segments.value().parameters.at(0);
  // (N-1)(2N-1)/(2N^2): 1 - 3/(2N) + 1/(2N^2).
  EXPECT_NEAR(error.observed_order, 1.0, 0.1);
  EXPECT_LT(std::abs(error.extrapolated - kModulus), error.extrapolated_error);
  EXPECT_LT(std::abs(error.at_own - kModulus), error.error);
}

TEST(SceneSegments, AreComparedWithTheNoise) {
  // Standard error of E: s E/sqrt(sum w^2), as of a straight line.
  SceneTarget target = continuous();
  double squares = 0.0;
  for (const double w : target.ordinate) squares += w * w;
  const double off = 1.25 / (2.0 * 64.0);
  const double limit = off * std::sqrt(squares) / std::sqrt(3.0);  // both are alike
  target.noise = 0.25 * limit;
  const SceneFitResult sharp = fit_scene(cantilever(8), target, stiffness());
  EXPECT_EQ(sharp.parameters[0].verdict(), Verdict::LimitedBySegments);
  ASSERT_FALSE(sharp.warnings.empty());
  EXPECT_EQ(sharp.warnings.back(),
            "youngs_modulus is limited by segments: what they do to it, 0.97 % of it, is more than "
            "the noise does, 0.14 %; about 2.0 times as many segments would make both alike");
  target.noise = 1.1 * limit;
  const SceneFitResult blurred = fit_scene(cantilever(8), target, stiffness());
  EXPECT_EQ(blurred.parameters[0].verdict(), Verdict::Identified);
  const double of_segments = blurred.segments.value().parameters[0].error / std::sqrt(3.0);
  EXPECT_DOUBLE_EQ(blurred.parameters[0].standard_error,
                   std::hypot(blurred.parameters[0].noise_error, of_segments));
}

TEST(SceneSegments, AssumeAnOrderWhereTheSegmentsCannotBeHalved) {
  const SceneFitResult fit = fit_scene(cantilever(7), continuous(), stiffness());
  ASSERT_TRUE(fit.segments);
  EXPECT_EQ(fit.segments->note,
            "no fit with half the segments: beam.segments = 7: cannot be halved: it is no even "
            "number");
  const SegmentsError& error = fit.segments->parameters.at(0);
  EXPECT_TRUE(std::isnan(error.at_half));
  EXPECT_EQ(error.trend, SegmentsTrend::Assumed);
  EXPECT_EQ(error.safety_factor, 3.0);
  EXPECT_NEAR(error.extrapolated / kModulus, 1.0, 1e-7);
}

TEST(SceneSegments, SayWhyTheirErrorIsNotKnown) {
  plastica::Setup setup = cantilever(5);
  setup.scene.beam.joint_lengths = {0.2, 0.2, 0.2, 0.2};
  const SceneFitResult fit = fit_scene(setup, continuous(), stiffness());
  EXPECT_EQ(fit.status, FitStatus::Fitted);
  EXPECT_EQ(fit.segments.value().parameters.at(0).trend, SegmentsTrend::Unknown);
  ASSERT_EQ(fit.warnings.size(), 1U);
  EXPECT_EQ(fit.warnings[0],
            "the error of the segments is not known: no fit with half the segments: "
            "beam.joint_lengths: are given for each joint; no fit with twice the segments: "
            "beam.joint_lengths: are given for each joint");
  EXPECT_EQ(fit.parameters[0].verdict(), Verdict::Identified);
  // The angle of one joint follows its length; that nobody asks for it does no harm.
  plastica::Setup hinge = cantilever(8);
  hinge.scene.probes.push_back({"hinge", ProbeQuantity::Angle, Place::start()});
  EXPECT_EQ(fit_scene(hinge, continuous(), stiffness()).segments.value().note, "");
  SceneTarget turned = continuous();
  turned.ordinate_probe = "hinge";
  for (double& angle : turned.ordinate) angle *= 0.1;
  EXPECT_EQ(fit_scene(hinge, turned, stiffness()).segments.value().note,
            "no fit with half the segments: probe = hinge: is the angle of one joint, which "
            "follows its length; no fit with twice the segments: probe = hinge: is the angle of "
            "one joint, which follows its length");
}

TEST(SceneSegments, AreNoneOfCouponsAndWhereSwitchedOff) {
  SceneFitOptions options = stiffness();
  const SceneFitResult on = fit_scene(cantilever(8), continuous(), options);
  options.segments_error = false;
  const SceneFitResult off = fit_scene(cantilever(8), continuous(), options);
  EXPECT_FALSE(off.segments);
  EXPECT_EQ(off.parameters[0].value, on.parameters[0].value);
  EXPECT_EQ(off.parameters[0].verdict(), Verdict::Identified);
  EXPECT_LT(off.runs, on.runs);
  EXPECT_LT(off.segment_iterations, on.segment_iterations);
  // A coupon in tension.
  plastica::Setup coupon;
  coupon.scene.drive.strain = {0.0};
  SceneTarget pulled;
  pulled.name = "pulled";
  pulled.kind = Abscissa::Strain;
  pulled.abscissa = {0.0, 0.0005, 0.001};
  pulled.ordinate = {0.0, 0.0005 * kModulus, 0.001 * kModulus};
  pulled.ordinate_probe = "stress";
  options.segments_error = true;
  EXPECT_FALSE(fit_scene(coupon, pulled, options).segments);
  // Beside a beam it has no segments, and counts all the same.
  const SceneFitResult both =
      fit(std::vector<WeightedTarget>{{coupon, pulled}, {cantilever(8), continuous()}}, options);
  EXPECT_EQ(both.segments.value().segments, 8);
}

TEST(SceneSegments, ExtrapolateWhatABendTestBreaksAt) {
  // Measured of 640 segments; breaks with 10 are 1.7 % off.
  const SceneTarget target = measured(bend_test(640));
  const SceneFitOptions options{.parameters = all_three(), .starts = 1};
  SceneFitOptions alone = options;
  alone.segments_error = false;
  const SceneFitResult truth = fit_scene(bend_test(640), target, alone);
  const SceneFitResult fit = fit_scene(bend_test(10), target, options);
  for (std::size_t i = 0; i < 3; ++i) {
    const SegmentsError& error = fit.segments.value().parameters[i];
    const double exact = truth.parameters[i].value;
    EXPECT_EQ(error.trend, SegmentsTrend::Monotone) << i;
    EXPECT_LT(std::abs(error.extrapolated - exact), error.extrapolated_error) << i;
    EXPECT_LT(std::abs(error.at_own - exact), error.error) << i;
    EXPECT_LT(std::abs(error.extrapolated - exact), 0.2 * std::abs(error.at_own - exact)) << i;
  }
}

TEST(SceneSegments, LeaveOutParametersThatAreNotDetermined) {
  auto parameters = stiffness_and_yield();
  parameters[1].upper = 370e6;
  const SceneFitResult fit =
      fit_scene(bend_test(10), measured(bend_test(10)), {.parameters = parameters});
  EXPECT_EQ(fit.segments.value().parameters[1].trend, SegmentsTrend::Unknown);
  EXPECT_NE(fit.segments.value().parameters[0].trend, SegmentsTrend::Unknown);
  EXPECT_EQ(fit.parameters[1].verdict(), Verdict::AtBound);
}

TEST(SceneSegments, LeaveTheTruthInTheIntervalWhateverTheirNumber) {
  // Three standard deviations of 300 seeds about 95 %.
  constexpr int kSeeds = 300;
  const double within = 3.0 * std::sqrt(0.95 * 0.05 / kSeeds);
  EXPECT_NEAR(coverage(4, 0.05, kSeeds), 0.95, within);
  EXPECT_NEAR(coverage(8, 0.01, kSeeds), 0.95, within);
  EXPECT_NEAR(coverage(32, 0.002, kSeeds), 0.95, within);
  // Without the segments in it the interval does not.
  SceneFitOptions alone = stiffness();
  alone.segments_error = false;
  EXPECT_LT(coverage(8, 0.01, kSeeds, alone), 0.95 - within);
  // Without noise to speak of what is left is a bound.
  EXPECT_EQ(coverage(2, 0.002, 50), 1.0);
}

}  // namespace
}  // namespace plastica::calibrate
