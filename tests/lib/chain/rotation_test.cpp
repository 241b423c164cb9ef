#include "plastica/chain/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"

namespace plastica::chain {
namespace {

using V = Vec<double, 3>;
using M = Mat<double, 3, 3>;

const V kAxis{{2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0}};

double distance(const M& a, const M& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 9; ++i) largest = std::max(largest, std::fabs(a.at[i] - b.at[i]));
  return largest;
}

class RotationByAngle : public ::testing::TestWithParam<double> {};

TEST_P(RotationByAngle, IsOrthogonalAndKeepsItsAxis) {
  const M r = rotation_matrix(GetParam() * kAxis);
  EXPECT_LT(distance(r * transpose(r), identity<double, 3>()), 1e-15 * 8);
  const V kept = r * kAxis - kAxis;
  EXPECT_LT(std::sqrt(dot(kept, kept)), 1e-15 * 8);
  EXPECT_NEAR(r(0, 0) + r(1, 1) + r(2, 2), 1.0 + 2.0 * std::cos(GetParam()), 1e-15 * 8);
}

TEST_P(RotationByAngle, ComesBackFromItsMatrix) {
  if (GetParam() > 3.14159) return;  // beyond half a turn another vector is shorter
  const V theta = GetParam() * kAxis;
  const V back = rotation_vector(rotation_matrix(theta)) - theta;
  // Near half a turn the angle is known to the root of rounding from the trace, not from here.
  EXPECT_LT(std::sqrt(dot(back, back)), 1e-14 * (1.0 + GetParam()));
}

/// exp(theta + h d) = exp(h spin) exp(theta) with d = T^-1 spin: by central differences.
TEST_P(RotationByAngle, TurnsByASpinAsItsTangentMapSays) {
  const V theta = GetParam() * kAxis;
  const V spin{{0.3, 0.5, -0.7}};
  const V d = inverse_tangent_map(theta, RotationCoefficients<double>(dot(theta, theta))) * spin;
  const double h = 1e-5;
  const M turned = rotation_matrix(theta + h * d) - rotation_matrix(theta - h * d);
  const M expected = (2.0 * h) * (skew(spin) * rotation_matrix(theta));
  // Differences: h^2/6 of the third derivative, about 1e-11 of the slope, and rounding over h.
  EXPECT_LT(distance(turned, expected) / (2.0 * h), 1e-9);
}

TEST_P(RotationByAngle, SlopeOfItsMomentMatchesDifferences) {
  const V theta = GetParam() * kAxis;
  const V s{{1.3, -0.4, 0.9}};
  const auto moment = [&](const V& at) {
    return transposed_times(inverse_tangent_map(at, RotationCoefficients<double>(dot(at, at))), s);
  };
  const M slope = moment_slope(theta, s, RotationCoefficients<double>(dot(theta, theta)));
  const double h = 1e-5;
  for (std::size_t k = 0; k < 3; ++k) {
    V step{};
    step[k] = h;
    const V difference = moment(theta + step) - moment(theta - step);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(difference[i] / (2.0 * h), slope(i, k), 1e-8) << i << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FromNothingToMoreThanHalfATurn, RotationByAngle,
                         ::testing::Values(0.0, 1e-12, 1e-6, 0.01, 0.5, 0.999999, 1.000001, 2.0,
                                           3.0, 3.141592653589, 4.5, 5.5));

TEST(Rotation, HasDerivativesWhereItIsTheIdentity) {
  using D = Dual<double, 3>;
  Vec<D, 3> theta;
  for (std::size_t k = 0; k < 3; ++k) theta[k] = D::parameter(0.0, k);
  const Mat<D, 3, 3> r = rotation_matrix(theta);
  EXPECT_EQ(r(2, 1).derivative(0), 1.0);
  EXPECT_EQ(r(0, 0).derivative(0), 0.0);
  const Vec<D, 3> back = rotation_vector(r);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(back[i].derivative(k), i == k ? 1.0 : 0.0, 1e-15);
    }
  }
}

TEST(Rotation, IsTheSameInEachLane) {
  using P = Pack<double, 8>;
  Vec<P, 3> theta;
  for (int lane = 0; lane < 8; ++lane) {
    for (std::size_t k = 0; k < 3; ++k) theta[k].set(lane, 0.45 * lane * kAxis[k]);
  }
  const Mat<P, 3, 3> r = rotation_matrix(theta);
  const Vec<P, 3> back = rotation_vector(r);
  for (int lane = 0; lane < 8; ++lane) {
    const V alone{{theta[0][lane], theta[1][lane], theta[2][lane]}};
    const M r_alone = rotation_matrix(alone);
    const V back_alone = rotation_vector(r_alone);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(r.at[i][lane], r_alone.at[i]);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(back[i][lane], back_alone[i]);
  }
}

}  // namespace
}  // namespace plastica::chain
