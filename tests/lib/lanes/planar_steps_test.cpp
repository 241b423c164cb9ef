#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/lib/lanes/planar_fixture.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::lanes {
namespace {

using testing::levels;
using testing::RandomBeams;
using testing::solved;

using Plane = std::array<double, 2>;
using Matrix = std::vector<std::vector<double>>;

double dot(const Plane& a, const Plane& b) { return a[0] * b[0] + a[1] * b[1]; }
Plane across(const Plane& from, const Plane& to) { return {from[1] - to[1], to[0] - from[0]}; }
void add(double factor, const Plane& v, Plane& sum) {
  for (std::size_t k = 0; k < 2; ++k) sum[k] += factor * v[k];
}

/// Accelerations of the joints by the whole mass matrix, where the recursion never has one.
std::vector<double> accelerations(const RandomBeams<double>& b, int order, double h) {
  const std::size_t n = b.segments;
  const double ahead = order == 2 ? 0.5 * h : 0.0;
  const double fraction = order == 2 ? 0.5 * h : h;
  std::vector<Plane> joint(n), direction(n), center(n), centripetal(n);
  Plane end{}, end_centripetal{};
  double angle = 0.0, spin = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    angle += b.kind(i, PlanarKind::Rest) + b.at(i, PlanarState::Angle);
    spin += b.at(i, PlanarState::Rate);
    const double at = angle + ahead * spin;
    const double there = spin + ahead * b.at(i, PlanarState::AngularAcceleration);
    direction[i] = {std::cos(at), std::sin(at)};
    joint[i] = center[i] = end;
    centripetal[i] = end_centripetal;
    const double distance = b.kind(i, PlanarKind::FirstMoment) / b.kind(i, PlanarKind::Mass);
    add(distance, direction[i], center[i]);
    add(-distance * there * there, direction[i], centripetal[i]);
    const double length = b.kind(i, PlanarKind::Length);
    add(length, direction[i], end);
    add(-length * there * there, direction[i], end_centripetal);
  }
  Matrix mass(n, std::vector<double>(n, 0.0));
  std::vector<double> force(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double m = b.kind(i, PlanarKind::Mass);
    const double distance = b.kind(i, PlanarKind::FirstMoment) / m;
    const double inertia = b.kind(i, PlanarKind::Inertia) - m * distance * distance;
    const Plane load{b.load(i, PlanarLoad::ForceX), b.load(i, PlanarLoad::ForceY)};
    const double moment = direction[i][0] * b.load(i, PlanarLoad::LeverY) -
                          direction[i][1] * b.load(i, PlanarLoad::LeverX) +
                          b.load(i, PlanarLoad::Moment);
    for (std::size_t k = 0; k <= i; ++k) {
      const Plane by_k = across(joint[k], center[i]);
      force[k] += moment + dot(load, across(joint[k], joint[i])) - m * dot(by_k, centripetal[i]);
      for (std::size_t j = 0; j <= i; ++j) {
        mass[k][j] += inertia + m * dot(by_k, across(joint[j], center[i]));
      }
    }
    const double k = b.kind(i, PlanarKind::Stiffness);
    const double d = b.kind(i, PlanarKind::Damping);
    const double rate = b.at(i, PlanarState::Rate);
    force[i] -= k * (b.at(i, PlanarState::Angle) + fraction * rate) + d * rate;
    mass[i][i] += fraction * (fraction * k + d);
  }
  return solved(std::move(mass), std::move(force));
}

TEST(PlanarSteps, SolveTheEquationsOfMotionOfTheWholeChain) {
  for (const int order : {1, 2}) {
    for (const double h : {1e-4, 1e-2}) {
      const RandomBeams<double> before(6, 1, 7);
      const RandomBeams<double> after(6, 1, 7);
      const std::vector<double> expected = accelerations(before, order, h);
      const auto& kernel = kBaselineKernels.in_double.planar[order - 1][0];
      kernel.one(after.beam(), h, 1, false);
      for (std::size_t i = 0; i < 6; ++i) {
        const double rate = before.at(i, PlanarState::Rate);
        const double acceleration = expected[i];
        const double now = rate + h * acceleration;
        const double mean = order == 2 ? 0.5 * (rate + now) : now;
        EXPECT_NEAR(after.at(i, PlanarState::Rate), now, 1e-12 * (1.0 + std::fabs(acceleration)));
        EXPECT_NEAR(after.at(i, PlanarState::Angle), before.at(i, PlanarState::Angle) + h * mean,
                    1e-13 * (1.0 + std::fabs(acceleration)));
      }
    }
  }
}

TEST(PlanarSteps, DoNotTurnAClampedJoint) {
  const RandomBeams<double> b(4, 1, 3);
  b.kind(0, PlanarKind::Hold) = std::numeric_limits<double>::infinity();
  b.at(0, PlanarState::Rate) = 0.0;
  const double angle = b.at(0, PlanarState::Angle);
  kBaselineKernels.in_double.planar[1][0].one(b.beam(), 1e-3, 50, false);
  EXPECT_EQ(b.at(0, PlanarState::Angle), angle);
  EXPECT_NE(b.at(1, PlanarState::Rate), 0.0);
  EXPECT_TRUE(std::isfinite(b.at(3, PlanarState::Angle)));
}

/// Whether lane by lane the states are the same to the last bit.
template <class Real>
void expect_lanes_as_alone(const StepKernels<PlanarBeam<Real>>& kernel, const std::string& what) {
  constexpr std::size_t kWidth = kManyLanes<Real>;
  const RandomBeams<Real> all(9, kWidth);
  const std::size_t steps = plastica::testing::kSanitized ? 8 : 40;
  kernel.many(all.beam(), 2e-3, steps, false);
  for (std::size_t lane = 0; lane < kWidth; ++lane) {
    const RandomBeams<Real> alone(9, 1, static_cast<unsigned>(lane));
    kernel.one(alone.beam(), 2e-3, steps, false);
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t field = 0; field < PlanarState::kCount; ++field) {
        ASSERT_EQ(all.at(i, field, lane), alone.at(i, field))
            << what << ", lane " << lane << ", segment " << i << ", field " << field;
      }
    }
    for (std::size_t field = 0; field < PlanarSums::kCount; ++field) {
      ASSERT_EQ(all.sum(field, lane), alone.sum(field)) << what << ", sum " << field;
    }
  }
}

TEST(PlanarSteps, GiveALaneTheBitsOfALoneBeamOnEveryInstructionSet) {
  for (const InstructionSet level : levels()) {
    for (int order = 0; order < 2; ++order) {
      for (int yields = 0; yields < 2; ++yields) {
        const std::string what = std::string(name_of(level)) + ", order " +
                                 std::to_string(order + 1) + (yields != 0 ? ", yielding" : "");
        expect_lanes_as_alone(kernels(level).in_double.planar[order][yields], what);
        expect_lanes_as_alone(kernels(level).in_float.planar[order][yields], what + ", float");
      }
    }
  }
}

TEST(PlanarSteps, AgreeBetweenInstructionSetsToRounding) {
  const RandomBeams<double> base(9, 1);
  kBaselineKernels.in_double.planar[1][0].one(base.beam(), 1e-3, 20, false);
  for (const InstructionSet level : levels()) {
    const RandomBeams<double> other(9, 1);
    kernels(level).in_double.planar[1][0].one(other.beam(), 1e-3, 20, false);
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_NEAR(other.at(i, PlanarState::Angle), base.at(i, PlanarState::Angle), 1e-11);
    }
  }
}

TEST(PlanarSteps, LeaveLanesAloneWhereAnotherFails) {
  const RandomBeams<double> all(5, 8);
  const RandomBeams<double> healthy(5, 8);
  all.at(2, PlanarState::Rate, 3) = std::numeric_limits<double>::quiet_NaN();
  const auto& kernel = kernels(resolved(InstructionSet::Auto)).in_double.planar[1][1];
  kernel.many(all.beam(), 1e-3, 10, false);
  kernel.many(healthy.beam(), 1e-3, 10, false);
  for (std::size_t lane = 0; lane < 8; ++lane) {
    if (lane == 3) continue;
    EXPECT_EQ(all.at(4, PlanarState::Angle, lane), healthy.at(4, PlanarState::Angle, lane));
  }
  EXPECT_TRUE(std::isnan(all.at(4, PlanarState::Angle, 3)));
}

TEST(PlanarSteps, KeepTheirEnergyBalanced) {
  // Euler's losses are counted on their own: they are what is missing of the energy.
  for (const int yields : {0, 1}) {
    const RandomBeams<double> b(5, 1, 11);
    for (std::size_t i = 0; i < 5; ++i) {
      for (std::size_t field = 0; field < PlanarLoad::kCount; ++field) b.load(i, field) = 0.0;
      b.kind(i, PlanarKind::Damping) = 0.0;
      b.at(i, PlanarState::Rate) *= 0.01;
      b.at(i, PlanarState::Angle) = 0.0;
      b.at(i, PlanarState::AngularAcceleration) = 0.0;
      b.kind(i, PlanarKind::Cap) *= 1e-5;
    }
    const auto energy = [&] {
      double sum = 0.0, angle = 0.0, spin = 0.0, vx = 0.0, vy = 0.0;
      for (std::size_t i = 0; i < 5; ++i) {
        angle += b.kind(i, PlanarKind::Rest) + b.at(i, PlanarState::Angle);
        spin += b.at(i, PlanarState::Rate);
        const double c = std::cos(angle), s = std::sin(angle);
        const double m = b.kind(i, PlanarKind::Mass), f = b.kind(i, PlanarKind::FirstMoment);
        sum += 0.5 * m * (vx * vx + vy * vy) + f * spin * (c * vy - s * vx) +
               0.5 * b.kind(i, PlanarKind::Inertia) * spin * spin;
        vx -= b.kind(i, PlanarKind::Length) * s * spin;
        vy += b.kind(i, PlanarKind::Length) * c * spin;
        const double k = b.kind(i, PlanarKind::Stiffness);
        const double elastic = b.at(i, PlanarState::Angle) - b.at(i, PlanarState::Plastic);
        sum += 0.5 * k * elastic * elastic +
               b.kind(i, PlanarKind::Cap) * b.at(i, PlanarState::Accumulated);
      }
      return sum;
    };
    const double begin = energy();
    kBaselineKernels.in_double.planar[0][yields].one(b.beam(), 1e-4, 2000, false);
    const double lost = begin - energy();
    EXPECT_GT(lost, 1e-5 * begin);
    EXPECT_NEAR(b.sum(PlanarSums::NumericalDissipation) / lost, 1.0, 2e-3) << yields;
    const double flowed = b.at(0, PlanarState::Accumulated);
    EXPECT_EQ(flowed > 0.0, yields == 1);
  }
}

}  // namespace
}  // namespace plastica::lanes
