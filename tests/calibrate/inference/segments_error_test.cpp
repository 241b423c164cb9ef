#include "calibrate/inference/segments_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "calibrate/inference/not_a_number.hpp"

namespace plastica::calibrate {
namespace {

/// f(N) = 100 + C h^p with N/2, N and 2N segments.
SegmentsError of_power(double constant, double p, double joints_order = 2.0) {
  const auto value = [&](double h) { return 100.0 + constant * std::pow(h, p); };
  return segments_error(value(2.0), value(1.0), value(0.5), joints_order);
}

TEST(SegmentsError, FindsTheOrderAndTheLimitOfAPower) {
  for (const double p : {1.0, 1.5, 2.0}) {
    for (const double constant : {3.0, -3.0}) {
      const SegmentsError error = of_power(constant, p);
      EXPECT_EQ(error.trend, SegmentsTrend::Monotone);
      EXPECT_NEAR(error.observed_order, p, 1e-12);
      EXPECT_NEAR(error.extrapolated, 100.0, 1e-11);
      EXPECT_EQ(error.safety_factor, 1.25);
      // Of an order between both it may be one of each: the parabola's limit is further off.
      const double apart = p == 1.5 ? 1.25 * (6.0 - 4.0 * std::sqrt(2.0)) : 0.0;
      EXPECT_NEAR(error.error, 1.25 * 3.0 + apart, 1e-11) << "about the value with N";
      EXPECT_NEAR(error.extrapolated_error, 1.25 * 3.0 * std::pow(0.5, p) + apart, 1e-11);
    }
  }
}

TEST(SegmentsError, TrustsNoOrderBeyondThatOfTheJoints) {
  // Of order 2.5 at most a part: (f(N) - f(2N))/3 in place of /(2^2.5 - 1).
  const SegmentsError near = of_power(3.0, 2.5);
  EXPECT_NEAR(near.observed_order, 2.5, 1e-12);
  EXPECT_EQ(near.order, 2.0);
  EXPECT_EQ(near.safety_factor, 1.25);
  const double fine = 100.0 + 3.0 * std::pow(0.5, 2.5);
  EXPECT_NEAR(near.extrapolated, fine - (103.0 - fine) / 3.0, 1e-12);
  EXPECT_LT(std::abs(near.extrapolated - 100.0), near.extrapolated_error);
  const SegmentsError far = of_power(3.0, 3.5);
  EXPECT_EQ(far.safety_factor, 3.0);
  EXPECT_EQ(of_power(3.0, 1.9, 1.0).order, 1.0);
}

TEST(SegmentsError, StatesThreeSpreadsWhereNoOrderIsObserved) {
  const SegmentsError to_and_fro = segments_error(102.0, 99.0, 100.0, 2.0);
  EXPECT_EQ(to_and_fro.trend, SegmentsTrend::Oscillates);
  EXPECT_TRUE(std::isnan(to_and_fro.order));
  EXPECT_EQ(to_and_fro.error, 9.0);
  EXPECT_EQ(to_and_fro.extrapolated, 100.0);
  EXPECT_EQ(to_and_fro.extrapolated_error, 9.0);
  // Differences that grow, and those that fall too slowly.
  for (const double last : {4.0, 2.8}) {
    const SegmentsError apart = segments_error(1.0, 2.0, last, 2.0);
    EXPECT_EQ(apart.trend, SegmentsTrend::Diverges);
    EXPECT_DOUBLE_EQ(apart.error, 3.0 * (last - 1.0));
    EXPECT_EQ(apart.extrapolated, last);
  }
  EXPECT_EQ(segments_error(100.0, 100.0, 101.0, 2.0).trend, SegmentsTrend::Diverges);
}

TEST(SegmentsError, CallsAMillionthSettled) {
  const SegmentsError error = segments_error(100.0, 100.00005, 100.0, 2.0);
  EXPECT_EQ(error.trend, SegmentsTrend::Settled);
  EXPECT_NEAR(error.error, 1.5e-4, 1e-12);
  EXPECT_DOUBLE_EQ(segments_error(5.0, 5.0, 5.0, 2.0).error, 5e-6);
}

TEST(SegmentsError, AssumesTheOrderOfTheJointsOfTwoValues) {
  const SegmentsError finer = segments_error(kNan, 103.0, 100.75, 2.0);
  EXPECT_EQ(finer.trend, SegmentsTrend::Assumed);
  EXPECT_TRUE(std::isnan(finer.observed_order));
  EXPECT_NEAR(finer.extrapolated, 100.0, 1e-12);
  EXPECT_EQ(finer.safety_factor, 3.0);
  EXPECT_NEAR(finer.error, 9.0, 1e-12);
  EXPECT_NEAR(finer.extrapolated_error, 2.25, 1e-12);
  // Of the coarser one the value itself is the finest.
  const SegmentsError coarser = segments_error(112.0, 103.0, kNan, 2.0);
  EXPECT_NEAR(coarser.extrapolated, 100.0, 1e-12);
  EXPECT_NEAR(coarser.error, 9.0, 1e-12);
  EXPECT_NEAR(segments_error(kNan, 102.0, 101.0, 1.0).extrapolated, 100.0, 1e-12);
}

TEST(SegmentsError, KnowsNothingOfOneValue) {
  for (const SegmentsError& error : {segments_error(kNan, 1.0, kNan, 2.0),
                                     segments_error(1.0, kNan, 2.0, 2.0), SegmentsError{}}) {
    EXPECT_EQ(error.trend, SegmentsTrend::Unknown);
    EXPECT_TRUE(std::isnan(error.error));
    EXPECT_TRUE(std::isnan(error.extrapolated));
  }
}

}  // namespace
}  // namespace plastica::calibrate
