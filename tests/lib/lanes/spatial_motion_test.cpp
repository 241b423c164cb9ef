#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "plastica/chain/rotation.hpp"
#include "tests/lib/lanes/spatial_fixture.hpp"

namespace plastica::lanes {
namespace {

using Vector = Vec<double, 3>;
using Square = Mat<double, 3, 3>;
using Beams = testing::RandomSpatialBeams<double>;

Vector state(const Beams& b, std::size_t i, std::size_t field) {
  return {{b.at(i, field), b.at(i, field + 1), b.at(i, field + 2)}};
}

/// Kinetic and elastic energy, and what the joints have dissipated by yielding.
double energy(const Beams& b) {
  double sum = 0.0;
  Square frame = identity<double, 3>();
  Vector spin, velocity;
  for (std::size_t i = 0; i < b.segments; ++i) {
    frame = frame * chain::rotation_matrix(state(b, i, SpatialState::Angle));
    spin += state(b, i, SpatialState::Rate);
    const Vector axis{{frame(0, 2), frame(1, 2), frame(2, 2)}};
    const Vector local = transposed_times(frame, spin);
    sum += 0.5 * b.kind(i, SpatialKind::Mass) * dot(velocity, velocity) +
           b.kind(i, SpatialKind::FirstMoment) * dot(velocity, cross(spin, axis));
    for (std::size_t k = 0; k < 3; ++k) {
      sum += 0.5 * b.kind(i, SpatialKind::Inertia + k) * local[k] * local[k];
      const double elastic = b.at(i, SpatialState::Angle + k) - b.at(i, SpatialState::Plastic + k);
      sum += 0.5 * b.kind(i, SpatialKind::Stiffness + k) * elastic * elastic +
             b.kind(i, SpatialKind::Cap + k) * b.at(i, SpatialState::Accumulated + k);
    }
    velocity += b.kind(i, SpatialKind::Length) * cross(spin, axis);
  }
  return sum;
}

/// A soft chain in lively motion: bent, twisted, loaded, damped.
Beams lively() {
  Beams b(4, 1, 21);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t f = 0; f < SpatialLoad::kCount; ++f) b.load(i, f) *= 0.5;
    for (std::size_t k = 0; k < 3; ++k) {
      b.kind(i, SpatialKind::Stiffness + k) *= 0.05;
      b.kind(i, SpatialKind::Compliance + k) *= 20.0;
      b.kind(i, SpatialKind::Cap + k) *= 0.05;
      b.kind(i, SpatialKind::Damping + k) *= 0.02;
      b.at(i, SpatialState::Rate + k) *= 2.0;
      b.at(i, SpatialState::AngularAcceleration + k) = 0.0;
      b.at(i, SpatialState::AngleRate + k) = b.at(i, SpatialState::Rate + k);
    }
  }
  return b;
}

/// The same, free of loads and damping.
Beams conservative() {
  Beams b = lively();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t f = 0; f < SpatialLoad::kCount; ++f) b.load(i, f) = 0.0;
    for (std::size_t k = 0; k < 3; ++k) b.kind(i, SpatialKind::Damping + k) = 0.0;
  }
  return b;
}

/// On a ball joint without stiffness, and fast enough for it to turn by more than 1 rad.
Beams pinned() {
  Beams b = lively();
  for (std::size_t k = 0; k < 3; ++k) b.kind(0, SpatialKind::Stiffness + k) = 0.0;
  b.at(0, SpatialState::Angle) = 0.9;
  b.at(0, SpatialState::Rate) = 6.0;
  b.at(0, SpatialState::Rate + 1) = -4.0;
  return b;
}

/// All angles at a time, in steps of time/count.
std::vector<double> angles_at(const Beams& b, int order, double time, std::size_t count) {
  kBaselineKernels.in_double.spatial[order - 1][0].one(b.beam(), time / static_cast<double>(count),
                                                       count, false);
  std::vector<double> all;
  for (std::size_t i = 0; i < b.segments; ++i) {
    for (std::size_t k = 0; k < 3; ++k) all.push_back(b.at(i, SpatialState::Angle + k));
  }
  return all;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

TEST(SpatialMotion, HasTheOrderOfItsScheme) {
  for (const auto& make : {lively, pinned}) {
    for (const int order : {1, 2}) {
      const std::size_t coarse = order == 1 ? 3200 : 400;
      const auto a = angles_at(make(), order, 0.1, coarse);
      const auto b = angles_at(make(), order, 0.1, 2 * coarse);
      const Beams last = make();
      const auto c = angles_at(last, order, 0.1, 4 * coarse);
      const double observed = std::log2(distance(a, b) / distance(b, c));
      EXPECT_NEAR(observed, order, 0.1);
      EXPECT_LT(distance(b, c), 2e-3);
      EXPECT_EQ(last.sum(SpatialSums::LargestAngle) > 1.0, make == pinned);
    }
  }
}

TEST(SpatialMotion, KeepsItsEnergyToTheOrderOfTheScheme) {
  std::vector<double> drift;
  for (const std::size_t count : {500U, 1000U, 2000U}) {
    const Beams b = conservative();
    const double begin = energy(b);
    angles_at(b, 2, 0.5, count);
    drift.push_back(std::fabs(energy(b) / begin - 1.0));
  }
  EXPECT_LT(drift[2], 1e-4);
  EXPECT_GT(drift[0] / drift[1], 3.5);
  EXPECT_GT(drift[1] / drift[2], 3.5);
}

TEST(SpatialMotion, CountsWhatDampingAndEulersRuleDissipate) {
  for (const bool damped : {false, true}) {
    const Beams b = conservative();
    // Small motions: else what is explicit counts as much.
    for (std::size_t i = 0; i < 4; ++i) {
      if (damped) b.kind(i, SpatialKind::Damping + 1) = 2e-3;
      for (std::size_t k = 0; k < 3; ++k) {
        b.at(i, SpatialState::Angle + k) = 0.0;
        b.at(i, SpatialState::Rate + k) *= 0.01;
      }
    }
    const double begin = energy(b);
    angles_at(b, 1, 0.2, 4000);
    const double lost = begin - energy(b);
    EXPECT_GT(lost, 1e-4 * begin);
    EXPECT_NEAR((b.sum(SpatialSums::NumericalDissipation) + b.sum(SpatialSums::Damping)) / lost,
                1.0, 5e-3);
    EXPECT_EQ(b.sum(SpatialSums::Damping) > 0.2 * lost, damped);
  }
}

TEST(SpatialMotion, CountsTheWorkOfItsLoads) {
  const Beams b = lively();
  const double begin = energy(b);
  angles_at(b, 2, 0.2, 2000);
  EXPECT_NEAR(energy(b) - begin + b.sum(SpatialSums::Damping), b.sum(SpatialSums::Loads),
              1e-4 * begin);
  EXPECT_GT(std::fabs(b.sum(SpatialSums::Loads)), 0.05 * begin);
}

TEST(SpatialMotion, YieldsComponentByComponent) {
  const Beams b = conservative();
  const double begin = energy(b);
  kBaselineKernels.in_double.spatial[1][1].one(b.beam(), 1e-4, 4000, false);
  int yielded = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double cap = b.kind(i, SpatialKind::Cap + k);
      const double moment = b.kind(i, SpatialKind::Stiffness + k) *
                            (b.at(i, SpatialState::Angle + k) - b.at(i, SpatialState::Plastic + k));
      EXPECT_LE(std::fabs(moment), cap * (1.0 + 1e-12));
      EXPECT_LE(std::fabs(b.at(i, SpatialState::Plastic + k)),
                b.at(i, SpatialState::Accumulated + k) + 1e-15);
      if (b.at(i, SpatialState::Accumulated + k) > 0.0) ++yielded;
    }
  }
  EXPECT_GE(yielded, 3);
  EXPECT_LT(yielded, 12);
  EXPECT_NEAR(energy(b) + b.sum(SpatialSums::NumericalDissipation), begin, 1e-4 * begin);
}

TEST(SpatialMotion, LetsRingingDieOutWhereBendingMeetsTwist) {
  // A slender cantilever, loaded of a sudden, whose joints ring 50 times faster than the step.
  // Without its numerical dissipation the midpoint breaks down in 2.5 s: the fastest spin, 31
  // rad/s, becomes 1e12.
  const Beams b(64, 1);
  const double length = 1.0 / 64, mass = 0.48 / 64;
  for (std::size_t i = 0; i < 64; ++i) {
    b.kind(i, SpatialKind::Length) = length;
    b.kind(i, SpatialKind::Mass) = mass;
    b.kind(i, SpatialKind::FirstMoment) = 0.5 * mass * length;
    const double ends = i == 0 ? 2.0 : 1.0;
    for (std::size_t k = 0; k < 3; ++k) {
      b.kind(i, SpatialKind::Inertia + k) =
          k == 2 ? 6.7e-5 * mass : mass * (length * length / 3 + 3.3e-5);
      b.kind(i, SpatialKind::Stiffness + k) = ends * (k == 2 ? 17.3 : 26.7) / length;
      b.kind(i, SpatialKind::Damping + k) = 0.0;
      b.load(i, SpatialLoad::Force + k) = mass * (k == 0 ? 30.0 : k == 1 ? -50.0 : 0.0);
      b.load(i, SpatialLoad::Lever + k) = 0.5 * length * b.load(i, SpatialLoad::Force + k);
      b.load(i, SpatialLoad::Moment + k) = k == 2 ? length : 0.0;
    }
    for (std::size_t f = 0; f < SpatialState::kCount; ++f) b.at(i, f) = 0.0;
  }
  kBaselineKernels.in_double.spatial[1][0].one(b.beam(), 1e-3, 2500, false);
  EXPECT_LT(b.sum(SpatialSums::FastestSpin), 40.0);
  EXPECT_LT(b.sum(SpatialSums::LargestAngle), 0.2);
  EXPECT_TRUE(std::isfinite(b.at(63, SpatialState::Angle)));
}

}  // namespace
}  // namespace plastica::lanes
