#include "plastica/theory/beam_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace plastica::theory {
namespace {

constexpr double kL = 2.5;
constexpr double kEI = 3.0;

/// Twenty elementary cases: force, moment and even load on four pairs of ends, each point load at
/// the middle, off the middle, and at the end where that is free to move or turn.
std::vector<BeamCase> elementary_cases() {
  std::vector<BeamCase> cases;
  for (const BeamEnds ends : {BeamEnds::ClampedFree, BeamEnds::PinnedPinned,
                              BeamEnds::ClampedPinned, BeamEnds::ClampedClamped}) {
    for (const BeamLoad& load :
         {BeamLoad{.position = 0.5 * kL, .force = 1.7},
          BeamLoad{.position = 0.3 * kL, .force = 1.7},
          BeamLoad{.position = 0.7 * kL, .moment = 0.9}, BeamLoad{.position = kL, .moment = 0.9},
          BeamLoad{.distributed = 1.1}}) {
      cases.push_back({.ends = ends, .length = kL, .bending_stiffness = kEI, .load = load});
    }
  }
  cases.push_back({.ends = BeamEnds::ClampedFree,
                   .length = kL,
                   .bending_stiffness = kEI,
                   .load = {.position = kL, .force = 1.7}});
  return cases;
}

/// What M/(E I) between two ends does: the turn, and the offset from the tangent of the first.
struct Bend {
  double rotation = 0.0;
  double offset = 0.0;
};

/// Two-point Gauss in parts that end at the load, exact for M up to x^2 and M (L - x) up to x^3.
Bend integrate(const BeamCase& beam, double from, double to) {
  Bend bend;
  const double half = 0.5 * (to - from);
  for (const double side : {-1.0, 1.0}) {
    const double x = from + half + side * half / std::sqrt(3.0);
    const double curvature = beam_moment(beam, x) / beam.bending_stiffness;
    bend.rotation += half * curvature;
    bend.offset += half * curvature * (to - x);
  }
  return bend;
}

TEST(BeamCases, ReactionsBalanceTheLoad) {
  for (const BeamCase& beam : elementary_cases()) {
    const BeamReactions r = beam_reactions(beam);
    const BeamLoad& q = beam.load;
    EXPECT_NEAR(r.start_force + r.end_force + q.force + q.distributed * kL, 0.0, 1e-14);
    EXPECT_NEAR(r.start_moment + r.end_moment + r.end_force * kL + q.force * q.position + q.moment +
                    q.distributed * kL * kL / 2.0,
                0.0, 1e-13);
  }
}

TEST(BeamCases, NoMomentOfASupportWhereTheBeamIsFreeToTurn) {
  for (const BeamCase& beam : elementary_cases()) {
    const BeamReactions r = beam_reactions(beam);
    if (beam.ends == BeamEnds::PinnedPinned) {
      EXPECT_EQ(r.start_moment, 0.0);
    }
    if (beam.ends != BeamEnds::ClampedClamped) {
      EXPECT_EQ(r.end_moment, 0.0);
    }
    if (beam.ends == BeamEnds::ClampedFree) {
      EXPECT_EQ(r.end_force, 0.0);
    }
    // The section at the very end carries what the support there gives.
    EXPECT_NEAR(beam_moment(beam, kL), r.end_moment, 1e-13);
  }
}

TEST(BeamCases, SupportsHoldTheBeam) {
  for (const BeamCase& beam : elementary_cases()) {
    SCOPED_TRACE(static_cast<int>(beam.ends));
    EXPECT_EQ(beam_deflection(beam, 0.0), 0.0);
    if (beam.ends != BeamEnds::PinnedPinned) {
      EXPECT_EQ(beam_slope(beam, 0.0), 0.0);
    }
    if (beam.ends != BeamEnds::ClampedFree) {
      EXPECT_NEAR(beam_deflection(beam, kL), 0.0, 1e-14);
    }
    if (beam.ends == BeamEnds::ClampedClamped) {
      EXPECT_NEAR(beam_slope(beam, kL), 0.0, 1e-14);
    }
  }
}

TEST(BeamCases, DeflectionsAreTheMomentIntegratedTwice) {
  for (const BeamCase& beam : elementary_cases()) {
    SCOPED_TRACE(std::to_string(static_cast<int>(beam.ends)) + " at " +
                 std::to_string(beam.load.position));
    double slope = beam_slope(beam, 0.0), deflection = 0.0;
    double from = 0.0;
    for (const double to : {0.2 * kL, 0.3 * kL, 0.5 * kL, 0.7 * kL, kL}) {
      const Bend bend = integrate(beam, from, to);
      deflection += slope * (to - from) + bend.offset;
      slope += bend.rotation;
      EXPECT_NEAR(beam_slope(beam, to), slope, 1e-13);
      EXPECT_NEAR(beam_deflection(beam, to), deflection, 1e-13);
      from = to;
    }
  }
}

TEST(BeamCases, HaveTheWellKnownLargestDeflections) {
  const auto at = [](BeamEnds ends, double x, const BeamLoad& load) {
    return beam_deflection({.ends = ends, .load = load}, x);
  };
  const BeamLoad middle{.position = 0.5, .force = 1.0}, even{.distributed = 1.0};
  EXPECT_NEAR(at(BeamEnds::ClampedFree, 1.0, {.position = 1.0, .force = 1.0}), 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(at(BeamEnds::ClampedFree, 1.0, {.position = 1.0, .moment = 1.0}), 1.0 / 2.0, 1e-15);
  EXPECT_NEAR(at(BeamEnds::ClampedFree, 1.0, even), 1.0 / 8.0, 1e-15);
  EXPECT_NEAR(at(BeamEnds::PinnedPinned, 0.5, middle), 1.0 / 48.0, 1e-15);
  EXPECT_NEAR(at(BeamEnds::PinnedPinned, 0.5, even), 5.0 / 384.0, 1e-15);
  EXPECT_NEAR(at(BeamEnds::ClampedPinned, 0.5, middle), 7.0 / 768.0, 1e-15);
  EXPECT_NEAR(at(BeamEnds::ClampedPinned, 0.5, even), 1.0 / 192.0, 1e-15);
  EXPECT_NEAR(at(BeamEnds::ClampedClamped, 0.5, middle), 1.0 / 192.0, 1e-15);
  EXPECT_NEAR(at(BeamEnds::ClampedClamped, 0.5, even), 1.0 / 384.0, 1e-15);
}

TEST(BeamCases, LoadsAddUp) {
  const BeamLoad both{.position = 0.4, .force = 2.0, .moment = -1.0, .distributed = 3.0};
  const BeamEnds ends = BeamEnds::ClampedPinned;
  double sum = 0.0;
  for (const BeamLoad& load :
       {BeamLoad{.position = 0.4, .force = 2.0}, BeamLoad{.position = 0.4, .moment = -1.0},
        BeamLoad{.distributed = 3.0}}) {
    sum += beam_deflection({.ends = ends, .load = load}, 0.6);
  }
  EXPECT_NEAR(beam_deflection({.ends = ends, .load = both}, 0.6), sum, 1e-15);
}

TEST(BeamCases, ShearAddsItsForceOverTheStiffness) {
  EXPECT_NEAR(cantilever_shear_deflection(3.0, 0.0, 2.0, 5.0), 1.2, 1e-15);
  EXPECT_NEAR(cantilever_shear_deflection(0.0, 3.0, 2.0, 5.0), 1.2, 1e-15);
}

}  // namespace
}  // namespace plastica::theory
