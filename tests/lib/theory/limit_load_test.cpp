#include "plastica/theory/limit_load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plastica/theory/beam_cases.hpp"

namespace plastica::theory {
namespace {

constexpr double kLimitL = 2.0;
constexpr double kMp = 5.0;

/// The static theorem: the largest load for which some moments of the supports leave |M| <= M_p
/// everywhere. Best for the beam is that its clamps carry M_p against the moment of the span.
/// @param unit  a load that is scaled up, pushing one way
double static_limit(BeamEnds ends, const BeamLoad& unit) {
  const double start_most = ends == BeamEnds::PinnedPinned ? 0.0 : kMp;
  const double end_most = ends == BeamEnds::ClampedClamped ? kMp : 0.0;
  double low = 0.0, high = 1e3;
  for (int i = 0; i < 60; ++i) {
    const double load = 0.5 * (low + high);
    BeamLoad scaled = unit;
    scaled.force *= load;
    scaled.distributed *= load;
    const BeamCase simple{.ends = BeamEnds::PinnedPinned, .length = kLimitL, .load = scaled};
    double worst = 0.0;
    for (int k = 0; k <= 2000; ++k) {
      const double x = kLimitL * k / 2000.0;
      const double lift = start_most * (1.0 - x / kLimitL) + end_most * x / kLimitL;
      worst = std::max(worst, -beam_moment(simple, x) - lift);
    }
    (worst <= kMp ? low : high) = load;
  }
  return low;
}

TEST(LimitLoad, OfTheFiveFramesOfSupport) {
  EXPECT_NEAR(limit_force(BeamEnds::ClampedFree, kMp, kLimitL, kLimitL), kMp / kLimitL, 1e-14);
  EXPECT_NEAR(limit_force(BeamEnds::PinnedPinned, kMp, kLimitL, kLimitL / 2.0), 4.0 * kMp / kLimitL,
              1e-14);
  EXPECT_NEAR(limit_force(BeamEnds::ClampedPinned, kMp, kLimitL, kLimitL / 2.0),
              6.0 * kMp / kLimitL, 1e-14);
  EXPECT_NEAR(limit_force(BeamEnds::ClampedClamped, kMp, kLimitL, kLimitL / 2.0),
              8.0 * kMp / kLimitL, 1e-14);
  EXPECT_NEAR(limit_distributed(BeamEnds::ClampedClamped, kMp, kLimitL),
              16.0 * kMp / (kLimitL * kLimitL), 1e-13);
}

TEST(LimitLoad, OfAForceMeetsTheStaticTheorem) {
  for (const BeamEnds ends :
       {BeamEnds::PinnedPinned, BeamEnds::ClampedPinned, BeamEnds::ClampedClamped}) {
    for (const double fraction : {0.2, 0.5, 0.7}) {
      EXPECT_NEAR(static_limit(ends, {.position = fraction * kLimitL, .force = 1.0}),
                  limit_force(ends, kMp, kLimitL, fraction * kLimitL), 1e-9);
    }
  }
}

TEST(LimitLoad, OfAnEvenLoadMeetsTheStaticTheorem) {
  for (const BeamEnds ends :
       {BeamEnds::PinnedPinned, BeamEnds::ClampedPinned, BeamEnds::ClampedClamped}) {
    const double expected = limit_distributed(ends, kMp, kLimitL);
    // The hinge of the propped beam lies between two sections: second order in 1/2000.
    EXPECT_NEAR(static_limit(ends, {.distributed = 1.0}) / expected, 1.0, 1e-6);
  }
  EXPECT_NEAR(limit_distributed(BeamEnds::ClampedPinned, 1.0, 1.0), 6.0 + 4.0 * std::sqrt(2.0),
              1e-14);
}

TEST(LimitLoad, OfTheCantileverIsThatOfItsClamp) {
  const BeamCase beam{
      .ends = BeamEnds::ClampedFree,
      .length = kLimitL,
      .load = {.distributed = limit_distributed(BeamEnds::ClampedFree, kMp, kLimitL)}};
  EXPECT_NEAR(beam_moment(beam, 0.0), kMp, 1e-14);
}

}  // namespace
}  // namespace plastica::theory
