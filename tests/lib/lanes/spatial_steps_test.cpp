#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "plastica/chain/rotation.hpp"
#include "tests/lib/lanes/planar_fixture.hpp"
#include "tests/lib/lanes/spatial_fixture.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::lanes {
namespace {

using testing::levels;
using testing::RandomBeams;
using testing::RandomSpatialBeams;

using Vector = Vec<double, 3>;
using Square = Mat<double, 3, 3>;
using Beams = RandomSpatialBeams<double>;

template <class Get>
Vector vector(const Get& get, std::size_t first) {
  return {{get(first), get(first + 1), get(first + 2)}};
}
Vector spatial_state(const Beams& b, std::size_t i, std::size_t field) {
  return vector([&](std::size_t f) { return b.at(i, f); }, field);
}
Vector kind(const Beams& b, std::size_t i, std::size_t field) {
  return vector([&](std::size_t f) { return b.kind(i, f); }, field);
}
Vector load(const Beams& b, std::size_t i, std::size_t field) {
  return vector([&](std::size_t f) { return b.load(i, f); }, field);
}
Square diagonal(const Vector& v) { return {{v[0], 0, 0, 0, v[1], 0, 0, 0, v[2]}}; }
Square angle_map(const Vector& theta) {
  return chain::inverse_tangent_map(theta, chain::RotationCoefficients<double>(dot(theta, theta)));
}
Vector spun(const Vector& w, const Vector& arm) { return cross(w, cross(w, arm)); }

/// Where a step of the scheme evaluates forces, worked out by the chain's own rotations.
struct Observed {
  std::vector<Square> frame, to_angle;
  std::vector<Vector> joint, spin, centripetal;  ///< of the inner joint
};
Observed observed(const Beams& b, double ahead) {
  Observed at;
  Square frame = identity<double, 3>();
  Vector spin, joint, centripetal;
  for (std::size_t i = 0; i < b.segments; ++i) {
    const Vector angle = spatial_state(b, i, SpatialState::Angle);
    const Vector rate = spatial_state(b, i, SpatialState::Rate);
    const Vector there = angle + ahead * spatial_state(b, i, SpatialState::AngleRate);
    at.to_angle.push_back(angle_map(there) * transpose(frame));
    frame = frame * chain::rotation_matrix(there);
    spin += rate;
    at.frame.push_back(frame);
    at.joint.push_back(joint);
    at.centripetal.push_back(centripetal);
    at.spin.push_back(spin + ahead * spatial_state(b, i, SpatialState::AngularAcceleration));
    const Vector arm = frame * Vector{{0, 0, b.kind(i, SpatialKind::Length)}};
    joint += arm;
    centripetal += spun(at.spin.back(), arm);
  }
  return at;
}

/// Changes of the joints' rates by the whole mass matrix, where the recursion never has one.
std::vector<Vector> accelerations(const Beams& b, int order, double h) {
  const std::size_t n = b.segments;
  const double fraction = order == 2 ? 0.5 * h : h;
  const Observed at = observed(b, order == 2 ? 0.5 * h : 0.0);
  std::vector<std::vector<double>> mass(3 * n, std::vector<double>(3 * n, 0.0));
  std::vector<double> force(3 * n, 0.0);
  const auto add = [&](std::size_t k, std::size_t j, const Square& m) {
    for (std::size_t r = 0; r < 9; ++r) mass[3 * k + r / 3][3 * j + r % 3] += m.at[r];
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double m = b.kind(i, SpatialKind::Mass);
    const double zeta = b.kind(i, SpatialKind::FirstMoment) / m;
    const Vector arm = at.frame[i] * Vector{{0, 0, zeta}};
    const Square inertia =
        at.frame[i] *
        diagonal(kind(b, i, SpatialKind::Inertia) - Vector{{m * zeta * zeta, m * zeta * zeta, 0}}) *
        transpose(at.frame[i]);
    const Vector loaded = load(b, i, SpatialLoad::Force);
    const Vector center = at.joint[i] + arm;
    const Vector thrust = loaded - m * (at.centripetal[i] + spun(at.spin[i], arm));
    const Vector moment = cross((1 / zeta) * arm, load(b, i, SpatialLoad::Lever)) +
                          load(b, i, SpatialLoad::Moment) - cross(arm, loaded) -
                          cross(at.spin[i], inertia * at.spin[i]);
    for (std::size_t k = 0; k <= i; ++k) {
      const Square by_k = skew(center - at.joint[k]);
      const Vector turned = moment + by_k * thrust;
      for (std::size_t c = 0; c < 3; ++c) force[3 * k + c] += turned[c];
      for (std::size_t j = 0; j <= i; ++j) {
        add(k, j, inertia - m * (by_k * skew(center - at.joint[j])));
      }
    }
    const Square& to_angle = at.to_angle[i];
    const Vector rate = to_angle * spatial_state(b, i, SpatialState::Rate);
    const Square k = diagonal(kind(b, i, SpatialKind::Stiffness));
    const Square d = diagonal(kind(b, i, SpatialKind::Damping));
    // Order 2 is damped by a tenth of the change of the angle's rate.
    const double damping = order == 2 ? 0.1 * fraction : 0.0;
    const Vector change = rate - spatial_state(b, i, SpatialState::AngleRate);
    const Vector spring = transposed_times(to_angle, k * (spatial_state(b, i, SpatialState::Angle) +
                                                          fraction * rate + damping * change) +
                                                         d * rate);
    for (std::size_t c = 0; c < 3; ++c) force[3 * i + c] -= spring[c];
    add(i, i, transpose(to_angle) * (fraction * ((fraction + damping) * k + d)) * to_angle);
  }
  const std::vector<double> all = testing::solved(std::move(mass), std::move(force));
  std::vector<Vector> joints;
  for (std::size_t i = 0; i < n; ++i) {
    joints.push_back({{all[3 * i], all[3 * i + 1], all[3 * i + 2]}});
  }
  return joints;
}

TEST(SpatialSteps, SolveTheEquationsOfMotionOfTheWholeChain) {
  for (const int order : {1, 2}) {
    for (const double h : {1e-4, 1e-2}) {
      const Beams before(6, 1, 7), after(6, 1, 7);
      for (const Beams* b : {&before, &after}) {
        b->at(2, SpatialState::Angle + 1) = 1.6;  // beyond the series
        b->at(4, SpatialState::Angle) = -0.9999;  // across their end
        b->at(4, SpatialState::Rate) = -9.0;
      }
      const std::vector<Vector> expected = accelerations(before, order, h);
      const Observed at = observed(before, order == 2 ? 0.5 * h : 0.0);
      kBaselineKernels.in_double.spatial[order - 1][0].one(after.beam(), h, 1, false);
      for (std::size_t i = 0; i < 6; ++i) {
        const Vector rate = spatial_state(before, i, SpatialState::Rate);
        const Vector now = rate + h * expected[i];
        const Vector mean = order == 2 ? 0.5 * (rate + now) : now;
        const Vector angle =
            spatial_state(before, i, SpatialState::Angle) + h * (at.to_angle[i] * mean);
        const double scale = 1.0 + size_of(expected[i]);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(after.at(i, SpatialState::Rate + k), now[k], 1e-12 * scale);
          EXPECT_NEAR(after.at(i, SpatialState::Angle + k), angle[k], 1e-13 * scale);
        }
      }
    }
  }
}

/// A planar beam and the same in space: about x, which turns z to -y.
struct Pair {
  RandomBeams<double> plane{6, 1, 5};
  Beams space{6, 1, 5};

  Pair() {
    const std::vector<std::pair<std::size_t, std::size_t>> kinds{
        {PlanarKind::Length, SpatialKind::Length},
        {PlanarKind::Mass, SpatialKind::Mass},
        {PlanarKind::FirstMoment, SpatialKind::FirstMoment},
        {PlanarKind::Inertia, SpatialKind::Inertia},
        {PlanarKind::Stiffness, SpatialKind::Stiffness},
        {PlanarKind::Compliance, SpatialKind::Compliance},
        {PlanarKind::Damping, SpatialKind::Damping},
        {PlanarKind::Cap, SpatialKind::Cap}};
    for (std::size_t i = 0; i < 6; ++i) {
      plane.kind(i, PlanarKind::Rest) = 0.0;
      plane.kind(i, PlanarKind::Cap) *= 0.2;
      for (const auto& [from, to] : kinds) space.kind(i, to) = plane.kind(i, from);
      for (std::size_t f = 0; f < SpatialLoad::kCount; ++f) space.load(i, f) = 0.0;
      for (std::size_t f = 0; f < SpatialState::kCount; ++f) space.at(i, f) = 0.0;
      space.load(i, SpatialLoad::Force + 2) = plane.load(i, PlanarLoad::ForceX);
      space.load(i, SpatialLoad::Force + 1) = -plane.load(i, PlanarLoad::ForceY);
      space.load(i, SpatialLoad::Lever + 2) = plane.load(i, PlanarLoad::LeverX);
      space.load(i, SpatialLoad::Lever + 1) = -plane.load(i, PlanarLoad::LeverY);
      space.load(i, SpatialLoad::Moment) = plane.load(i, PlanarLoad::Moment);
      space.at(i, SpatialState::Angle) = plane.at(i, PlanarState::Angle);
      space.at(i, SpatialState::Rate) = plane.at(i, PlanarState::Rate);
      space.at(i, SpatialState::AngleRate) = plane.at(i, PlanarState::Rate);
      space.at(i, SpatialState::AngularAcceleration) =
          plane.at(i, PlanarState::AngularAcceleration);
    }
  }
  void step(int order, int yields, double time, std::size_t count) const {
    const double h = time / static_cast<double>(count);
    kBaselineKernels.in_double.planar[order - 1][yields].one(plane.beam(), h, count, false);
    kBaselineKernels.in_double.spatial[order - 1][yields].one(space.beam(), h, count, false);
  }
  double apart() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(space.at(i, SpatialState::Angle + 1), 0.0);
      EXPECT_EQ(space.at(i, SpatialState::Angle + 2), 0.0);
      for (const auto& [in_plane, in_space] :
           {std::pair{PlanarState::Angle, SpatialState::Angle},
            std::pair{PlanarState::Plastic, SpatialState::Plastic}}) {
        largest = std::max(largest, std::fabs(space.at(i, in_space) - plane.at(i, in_plane)));
      }
    }
    return largest;
  }
};

TEST(SpatialSteps, MoveInAPlaneAsPlanarOnes) {
  // Euler's the same to rounding.
  for (int yields = 0; yields < 2; ++yields) {
    const Pair pair;
    pair.step(1, yields, 0.1, 100);
    EXPECT_LT(pair.apart(), 1e-11);
    EXPECT_EQ(pair.space.at(1, SpatialState::Accumulated) > 0.0, yields == 1);
    for (std::size_t f = 0; f <= SpatialSums::FastestSpin; ++f) {
      EXPECT_NEAR(pair.space.sum(f), pair.plane.sum(f), 1e-9 * (1.0 + pair.plane.sum(f))) << f;
    }
  }
  // The midpoint's look ahead in other ways, so that they differ by the square of the step.
  const Pair coarse, fine;
  coarse.step(2, 0, 0.1, 250);
  fine.step(2, 0, 0.1, 500);
  EXPECT_LT(fine.apart(), 1e-3);
  EXPECT_NEAR(coarse.apart() / fine.apart(), 4.0, 0.4);
}

TEST(SpatialSteps, DoNotTurnAClampedJoint) {
  const Beams b(4, 1, 3);
  b.kind(0, SpatialKind::Free) = 0.0;
  for (std::size_t k = 0; k < 3; ++k) b.at(0, SpatialState::Rate + k) = 0.0;
  const Vector angle = spatial_state(b, 0, SpatialState::Angle);
  kBaselineKernels.in_double.spatial[1][0].one(b.beam(), 1e-3, 50, false);
  EXPECT_EQ(spatial_state(b, 0, SpatialState::Angle).at, angle.at);
  EXPECT_NE(b.at(1, SpatialState::Rate), 0.0);
  EXPECT_TRUE(std::isfinite(b.at(3, SpatialState::Angle)));
}

/// Whether lane by lane the states are the same to the last bit.
template <class Real>
void expect_lanes_as_alone(const StepKernels<SpatialBeam<Real>>& kernel, const std::string& what) {
  constexpr std::size_t kWidth = kManyLanes<Real>;
  const RandomSpatialBeams<Real> all(7, kWidth);
  // One lane leaves the range of the series.
  all.at(3, SpatialState::Angle + 1, 5) = 1.5;
  const std::size_t steps = plastica::testing::kSanitized ? 4 : 20;
  kernel.many(all.beam(), 1e-3, steps, false);
  for (std::size_t lane = 0; lane < kWidth; ++lane) {
    const RandomSpatialBeams<Real> alone(7, 1, static_cast<unsigned>(lane));
    if (lane == 5) alone.at(3, SpatialState::Angle + 1) = 1.5;
    kernel.one(alone.beam(), 1e-3, steps, false);
    for (std::size_t i = 0; i < 7; ++i) {
      for (std::size_t field = 0; field < SpatialState::kCount; ++field) {
        ASSERT_EQ(all.at(i, field, lane), alone.at(i, field))
            << what << ", lane " << lane << ", segment " << i << ", field " << field;
      }
    }
    for (std::size_t field = 0; field < SpatialSums::kCount; ++field) {
      ASSERT_EQ(all.sum(field, lane), alone.sum(field)) << what << ", sum " << field;
    }
  }
}

TEST(SpatialSteps, GiveALaneTheBitsOfALoneBeamOnEveryInstructionSet) {
  for (const InstructionSet level : levels()) {
    for (int order = 0; order < 2; ++order) {
      for (int yields = 0; yields < 2; ++yields) {
        const std::string what = std::string(name_of(level)) + ", order " +
                                 std::to_string(order + 1) + (yields != 0 ? ", yielding" : "");
        expect_lanes_as_alone(kernels(level).in_double.spatial[order][yields], what);
        expect_lanes_as_alone(kernels(level).in_float.spatial[order][yields], what + ", float");
      }
    }
  }
}

TEST(SpatialSteps, AgreeBetweenInstructionSetsToRounding) {
  const Beams base(9, 1);
  kBaselineKernels.in_double.spatial[1][0].one(base.beam(), 1e-3, 20, false);
  for (const InstructionSet level : levels()) {
    const Beams other(9, 1);
    kernels(level).in_double.spatial[1][0].one(other.beam(), 1e-3, 20, false);
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(other.at(i, SpatialState::Angle + k), base.at(i, SpatialState::Angle + k),
                    1e-11);
      }
    }
  }
}

TEST(SpatialSteps, AgreeBetweenPrecisionsToRounding) {
  const Beams wide(6, 1);
  const RandomSpatialBeams<float> narrow(6, 1);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t f = 0; f < SpatialKind::kCount; ++f) wide.kind(i, f) = narrow.kind(i, f);
    for (std::size_t f = 0; f < SpatialLoad::kCount; ++f) wide.load(i, f) = narrow.load(i, f);
    for (std::size_t f = 0; f < SpatialState::kCount; ++f) wide.at(i, f) = narrow.at(i, f);
  }
  kBaselineKernels.in_double.spatial[1][1].one(wide.beam(), 1e-3, 20, false);
  kBaselineKernels.in_float.spatial[1][1].one(narrow.beam(), 1e-3, 20, false);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = wide.at(i, SpatialState::Angle + k);
      EXPECT_NEAR(narrow.at(i, SpatialState::Angle + k), expected, 2e-6);
      EXPECT_NEAR(narrow.sum(SpatialSums::LargestAngle), wide.sum(SpatialSums::LargestAngle), 2e-6);
    }
  }
}

TEST(SpatialSteps, LeaveLanesAloneWhereAnotherFails) {
  const Beams all(5, 8), healthy(5, 8);
  all.at(2, SpatialState::Rate, 3) = std::numeric_limits<double>::quiet_NaN();
  const auto& kernel = kernels(resolved(InstructionSet::Auto)).in_double.spatial[1][1];
  kernel.many(all.beam(), 1e-3, 10, false);
  kernel.many(healthy.beam(), 1e-3, 10, false);
  for (std::size_t lane = 0; lane < 8; ++lane) {
    if (lane == 3) continue;
    EXPECT_EQ(all.at(4, SpatialState::Angle, lane), healthy.at(4, SpatialState::Angle, lane));
  }
  EXPECT_TRUE(std::isnan(all.at(4, SpatialState::Angle, 3)));
}

TEST(SpatialSteps, GoOnWhereTheyLeftOff) {
  const Beams whole(5, 1), parts(5, 1), observed_again(5, 1);
  const auto& kernel = kBaselineKernels.in_double.spatial[1][1];
  kernel.one(whole.beam(), 1e-3, 20, false);
  kernel.one(parts.beam(), 1e-3, 9, false);
  kernel.one(parts.beam(), 1e-3, 11, true);
  kernel.one(observed_again.beam(), 1e-3, 9, false);
  kernel.one(observed_again.beam(), 1e-3, 11, false);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(spatial_state(parts, i, SpatialState::Angle).at,
              spatial_state(whole, i, SpatialState::Angle).at);
    EXPECT_EQ(spatial_state(observed_again, i, SpatialState::Angle).at,
              spatial_state(whole, i, SpatialState::Angle).at);
  }
}

}  // namespace
}  // namespace plastica::lanes
