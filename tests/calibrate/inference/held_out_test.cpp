#include "calibrate/inference/held_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

TEST(PartsAlong, DealsBlocksOfEqualLengthRound) {
  std::vector<double> line(101);
  std::iota(line.begin(), line.end(), 0.0);
  const std::vector<std::size_t> part = parts_along(line, line);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(part[i], i / 10 % kParts) << i;
  EXPECT_EQ(part[100], 4U) << "the end belongs to the last block";
}

TEST(PartsAlong, GivesTheElasticPartBlocksOfItsOwn) {
  // Ten samples of a steep rise, a hundred of a plateau: both are half of the curve as it is drawn.
  std::vector<double> strain, stress;
  for (int i = 0; i < 10; ++i) {
    strain.push_back(1e-4 * i);
    stress.push_back(3e7 * i);
  }
  for (int i = 0; i <= 100; ++i) {
    strain.push_back(9e-4 + 1e-3 * i);
    stress.push_back(2.7e8);
  }
  const std::vector<std::size_t> part = parts_along(strain, stress);
  for (std::size_t k = 0; k < kParts; ++k) EXPECT_EQ(part[2 * k], k);
  EXPECT_EQ(part[10], 0U);
  EXPECT_EQ(part.back(), 4U);
}

TEST(PartsAlong, IsNotLengthenedByNoise) {
  // A plateau of many noisy samples is no longer than one of few exact ones.
  std::vector<double> strain, stress;
  Noise noise(5);
  for (int i = 0; i < 20; ++i) {
    strain.push_back(1e-3 * i / 20.0);
    stress.push_back(3e8 * i / 20.0);
  }
  for (int i = 0; i < 5000; ++i) {
    strain.push_back(1e-3 + 0.1 * i / 5000.0);
    stress.push_back(3e8 + noise(1e6));
  }
  const std::vector<std::size_t> part = parts_along(strain, stress);
  for (std::size_t k = 0; k < kParts; ++k) {
    EXPECT_EQ(part[4 * k + 1], k) << "the rise is half of the curve, as without noise";
  }
}

TEST(PartsAlong, TakesCurvesThatHardlyAreOne) {
  EXPECT_TRUE(parts_along({}, {}).empty());
  const std::vector<double> same{1.0, 1.0};
  EXPECT_EQ(parts_along(same, same), (std::vector<std::size_t>{0, 0}));
}

/// Of an elastic curve the fit without a part has a closed form: E = sum w s e/sum w e^2.
TEST(HeldOut, IsTheClosedFormOfAnElasticCurve) {
  FitOptions options = fit_of({free_parameter("youngs_modulus")});
  options.setup.scene.material.yield_stress = 1e12;
  const std::vector<double> strain = ramp(60, 0.002);
  std::vector<double> stress;
  Noise noise(3);
  for (const double e : strain) stress.push_back(200e9 * e + 5e10 * e * e / 0.002 + noise(3e6));
  const Target target = target_of(strain, stress);
  const FitResult result = fit_target(target, options);
  ASSERT_EQ(result.status, FitStatus::Fitted);
  const std::vector<double> left = held_out(target, options, result);
  ASSERT_EQ(left.size(), kParts);
  const std::vector<std::size_t> part = parts_along(strain, stress);
  const double largest = largest_magnitude(stress);
  const auto weight = [&](std::size_t i) { return i == 0 || i == 59 ? 0.5 : 1.0; };
  for (std::size_t k = 0; k < kParts; ++k) {
    double product = 0.0, square = 0.0;
    for (std::size_t i = 0; i < 60; ++i) {
      if (part[i] == k) continue;
      product += weight(i) * stress[i] * strain[i];
      square += weight(i) * strain[i] * strain[i];
    }
    double squares = 0.0;
    for (std::size_t i = 0; i < 60; ++i) {
      if (part[i] == k)
        squares += weight(i) * std::pow(product / square * strain[i] - stress[i], 2);
    }
    const double expected = 5.0 * squares / 59.0 / (largest * largest);
    EXPECT_NEAR(left[k], expected, tolerance(1e-5 * expected)) << k;
  }
}

TEST(HeldOut, IsEmptyWithoutAFit) { EXPECT_TRUE(held_out({}, {}, {}).empty()); }

}  // namespace
}  // namespace plastica::calibrate
