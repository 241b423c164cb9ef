#include "plastica/theory/uniaxial.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plastica::theory {
namespace {

constexpr double kModulus = 200e9;
constexpr double kYield = 400e6;  // at a strain of 0.002

TEST(Uniaxial, IdealPlasticityHoldsTheYieldStress) {
  EXPECT_DOUBLE_EQ(ideal_plastic_stress(0.001, kModulus, kYield), 200e6);
  EXPECT_DOUBLE_EQ(ideal_plastic_stress(0.03, kModulus, kYield), kYield);
  EXPECT_DOUBLE_EQ(ideal_plastic_stress(-0.03, kModulus, kYield), -kYield);
}

TEST(Uniaxial, UnloadingIsElasticUntilTheOppositeYield) {
  EXPECT_NEAR(ideal_plastic_unloading_stress(0.009, 0.01, kModulus, kYield), 200e6, 1e-6);
  EXPECT_NEAR(ideal_plastic_unloading_stress(0.008, 0.01, kModulus, kYield), 0.0, 1e-6);
  EXPECT_DOUBLE_EQ(ideal_plastic_unloading_stress(0.0, 0.01, kModulus, kYield), -kYield);
  EXPECT_NEAR(ideal_plastic_unloading_stress(-0.009, -0.01, kModulus, kYield), -200e6, 1e-6);
}

TEST(Uniaxial, PermanentStrainIsWhereTheUnloadedStressIsZero) {
  const double permanent = ideal_plastic_permanent_strain(0.01, kModulus, kYield);
  EXPECT_NEAR(permanent, 0.008, 1e-16);
  EXPECT_NEAR(ideal_plastic_unloading_stress(permanent, 0.01, kModulus, kYield), 0.0, 1e-5);
  EXPECT_EQ(ideal_plastic_permanent_strain(0.001, kModulus, kYield), 0.0);
}

TEST(Uniaxial, BilinearGoesOnWithTheTangentModulus) {
  EXPECT_NEAR(bilinear_stress(0.012, kModulus, kYield, 2e9), 420e6, 1e-3);
  EXPECT_NEAR(bilinear_stress(-0.012, kModulus, kYield, 2e9), -420e6, 1e-3);
  EXPECT_NEAR(bilinear_stress(0.001, kModulus, kYield, 2e9), 200e6, 1e-3);
}

TEST(Uniaxial, VoceRisesFromTheYieldStressToSaturation) {
  EXPECT_DOUBLE_EQ(voce_yield_stress(0.0, kYield, 100e6, 20.0), kYield);
  EXPECT_NEAR(voce_yield_stress(10.0, kYield, 100e6, 20.0), 500e6, 1e-3);
  // Slope at the start is b Q.
  EXPECT_NEAR((voce_yield_stress(1e-7, kYield, 100e6, 20.0) - kYield) / 1e-7, 2e9, 1e4);
}

TEST(Uniaxial, BackstressSolvesItsEquation) {
  // Runge-Kutta's classical method on dX/de = C - gamma X d, from X_0 against the flow.
  const double C = 20e9, gamma = 150.0, start = 30e6;
  for (const double increment : {0.01, -0.01}) {
    const double d = increment > 0.0 ? 1.0 : -1.0;
    const auto slope = [&](double x) { return C - gamma * x * d; };
    constexpr int kSteps = 200;
    const double step = increment / kSteps;
    double x = start;
    for (int i = 0; i < kSteps; ++i) {
      const double k1 = slope(x), k2 = slope(x + step / 2.0 * k1);
      const double k3 = slope(x + step / 2.0 * k2), k4 = slope(x + step * k3);
      x += step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    EXPECT_NEAR(backstress(start, increment, C, gamma), x, 1e-8 * std::abs(x));
  }
}

TEST(Uniaxial, BackstressWithoutRecallIsLinear) {
  EXPECT_DOUBLE_EQ(backstress(5e6, -0.002, 1e9, 0.0), 3e6);
  // The limit gamma -> 0 joins it.
  EXPECT_NEAR(backstress(5e6, -0.002, 1e9, 1e-9), 3e6, 1e-3);
  EXPECT_NEAR(stabilized_backstress(0.002, 1e9, 1e-9), stabilized_backstress(0.002, 1e9, 0.0),
              1e-3);
}

TEST(Uniaxial, ManyCyclesReachTheStabilizedBackstress) {
  const double C = 20e9, gamma = 100.0, amplitude = 0.005;
  double x = backstress(0.0, amplitude, C, gamma);
  for (int cycle = 0; cycle < 50; ++cycle) {
    x = backstress(x, -2.0 * amplitude, C, gamma);
    x = backstress(x, 2.0 * amplitude, C, gamma);
  }
  EXPECT_NEAR(x, stabilized_backstress(amplitude, C, gamma), 1e-12 * x);
  EXPECT_LT(x, backstress(0.0, amplitude, C, gamma) * 1.5);
}

TEST(Uniaxial, MonotonicStressOfEachLaw) {
  Material m{.youngs_modulus = kModulus, .yield_stress = kYield};
  EXPECT_EQ(monotonic_stress(0.05, m), kYield);

  m.hardening = {.law = HardeningLaw::Linear, .tangent_modulus = 2e9};
  const double linear = monotonic_stress(0.05, m);
  EXPECT_NEAR(bilinear_stress(0.05 + linear / kModulus, kModulus, kYield, 2e9), linear, 1e-3);

  m.hardening = {.law = HardeningLaw::VoceChaboche,
                 .saturation_stress = 100e6,
                 .saturation_rate = 20.0,
                 .backstress_modulus = {20e9, 1e9, 0.0},
                 .backstress_rate = {200.0, 0.0, 0.0}};
  const double expected =
      kYield + 100e6 * (1.0 - std::exp(-1.0)) + 100e6 * (1.0 - std::exp(-10.0)) + 1e9 * 0.05;
  EXPECT_NEAR(monotonic_stress(0.05, m), expected, 1e-3);
}

}  // namespace
}  // namespace plastica::theory
