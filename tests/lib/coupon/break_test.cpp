#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/support/scene.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica {
namespace {

using testing::coupon_scene;
using testing::kE;
using testing::kG;
using testing::kYield;
using testing::last;
using testing::of;
using testing::tolerance;

constexpr double kLimit = 0.0123;

Scene breaking_scene(Deformation deformation, std::vector<double> strain) {
  Scene scene = coupon_scene(deformation, std::move(strain));
  scene.material.break_strain = kLimit;
  return scene;
}

void expect_strain(double computed, double expected) {
  EXPECT_NEAR(computed, expected, tolerance(1e-14));
}

TEST(Break, HappensAtTheExactStrainForIdealPlasticity) {
  const Response response =
      simulate(breaking_scene(Deformation::Tension, {0.005, 0.011, 0.021, 0.031}));
  ASSERT_TRUE(response.event);
  EXPECT_EQ(response.status, Status::Broken);
  EXPECT_EQ(response.event->sample, 2U);
  expect_strain(response.event->strain, kLimit + kYield / kE);
  EXPECT_EQ(response.event->stress, kYield);
  EXPECT_EQ(response.event->permanent_strain, kLimit);
  EXPECT_NEAR(response.event->dissipation, kYield * kLimit, tolerance(1e-13) * kYield);
}

TEST(Break, HappensAtTheExactStrainForLinearHardening) {
  Scene scene = breaking_scene(Deformation::Tension, {0.05});
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 2e9;
  scene.material.hardening.kinematic_fraction = 0.5;
  const Response response = simulate(scene);
  ASSERT_TRUE(response.event);
  const double modulus = kE * 2e9 / (kE - 2e9);
  const double stress = kYield + modulus * kLimit;
  expect_strain(response.event->strain, kLimit + stress / kE);
  EXPECT_NEAR(response.event->stress, stress, tolerance(1e-12) * stress);
  const double work = 0.5 * (kYield + stress) * kLimit;
  EXPECT_NEAR(response.event->dissipation, work, tolerance(1e-12) * work);
}

TEST(Break, IsWithinItsSampleAndCloseForVoceHardening) {
  Scene scene = breaking_scene(Deformation::Tension, {});
  scene.material.hardening = {HardeningLaw::VoceChaboche, 0.0, 0.0, 80e6, 12.0, {}, {}};
  for (int i = 1; i <= 200; ++i) scene.drive.strain.push_back(1e-4 * i);
  const Response response = simulate(scene);
  ASSERT_TRUE(response.event);
  const double stress = kYield + 80e6 * (1.0 - std::exp(-12.0 * kLimit));
  EXPECT_NEAR(response.event->strain, kLimit + stress / kE, 1e-8);
  EXPECT_NEAR(response.event->stress, stress, 1e-5 * stress);
}

TEST(Break, HappensInCompressionAndInBending) {
  for (const Deformation deformation : {Deformation::Tension, Deformation::Bending}) {
    const Response response = simulate(breaking_scene(deformation, {-0.01, -0.02}));
    ASSERT_TRUE(response.event);
    expect_strain(response.event->strain, -kLimit - kYield / kE);
    EXPECT_EQ(response.event->stress, -kYield);
    EXPECT_GT(response.event->dissipation, 0.0);
  }
}

TEST(Break, TakesRootThreeOfTheBreakStrainInTorsion) {
  const Response response = simulate(breaking_scene(Deformation::Torsion, {0.05}));
  ASSERT_TRUE(response.event);
  const double root = std::numbers::sqrt3;
  expect_strain(response.event->strain, root * kLimit + kYield / root / kG);
  EXPECT_DOUBLE_EQ(response.event->permanent_strain, root * kLimit);
}

TEST(Break, HappensWhereTheReportsMeasureReachesTheLimit) {
  Scene scene = breaking_scene(Deformation::Bending, {0.5});
  scene.formulas = Formulas::Report;
  scene.material.break_strain = 0.2;
  scene.beam = {1.0, 5};
  const Response response = simulate(scene);
  ASSERT_TRUE(response.event);
  // (24): h/l sin(theta/2) = limit; half the stiffness, and the cap of (4).
  const double angle = 2.0 * std::asin(0.2 * 0.2 / 0.1);
  const double yield = kYield * 0.05 / 0.06;
  expect_strain(response.event->strain, angle * 0.05 / 0.2 + yield / (0.5 * kE));
  EXPECT_EQ(response.event->permanent_strain, 0.2);

  Scene twist = breaking_scene(Deformation::Torsion, {0.5});
  twist.formulas = Formulas::Report;
  const Response twisted = simulate(twist);
  ASSERT_TRUE(twisted.event);
  EXPECT_EQ(twisted.event->permanent_strain, kLimit);
  twist.drive.strain = {twisted.event->strain * (1.0 - 1e-9)};
  EXPECT_EQ(simulate(twist).status, Status::Completed);
  twist.drive.strain = {twisted.event->strain * (1.0 + 1e-9)};
  EXPECT_EQ(simulate(twist).status, Status::Broken);
}

TEST(Break, DoesNotHappenWithoutALimit) {
  for (const Deformation deformation :
       {Deformation::Tension, Deformation::Bending, Deformation::Torsion}) {
    const Response response = simulate(coupon_scene(deformation, {1e3, -1e3}));
    EXPECT_EQ(response.status, Status::Completed);
    EXPECT_FALSE(response.event);
  }
}

TEST(Break, DoesNotHappenExactlyAtTheLimit) {
  Scene scene = coupon_scene(Deformation::Tension, {0.0078125 + 0.0009765625});
  scene.material.youngs_modulus = 1024e9;
  scene.material.yield_stress = 1e9;
  scene.material.break_strain = 0.0078125;
  EXPECT_EQ(simulate(scene).status, Status::Completed);
}

TEST(Break, ComesFromACycleWithTheAccumulatedMeasureAlone) {
  // Each half cycle adds 0.004 of permanent strain or takes it back.
  const double y = kYield / kE;
  Scene scene = breaking_scene(Deformation::Tension, {});
  for (int i = 0; i < 3; ++i) {
    scene.drive.strain.push_back(0.004 + y);
    scene.drive.strain.push_back(-y);
  }
  EXPECT_EQ(simulate(scene).status, Status::Completed);
  scene.break_measure = BreakMeasure::Accumulated;
  const Response response = simulate(scene);
  ASSERT_TRUE(response.event);
  EXPECT_EQ(response.event->sample, 3U);
  expect_strain(response.event->strain, 0.004 - y - (kLimit - 0.012));
  EXPECT_NEAR(response.event->dissipation, kYield * kLimit, tolerance(1e-13) * kYield);
}

TEST(Break, CutsTheBeamWhichThenCarriesNothingAndKeepsItsPermanentStrain) {
  const Response response =
      simulate(breaking_scene(Deformation::Tension, {0.01, 0.02, 0.03, -0.03}));
  const double expected[] = {kYield, 0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(of(response, ProbeQuantity::Stress)[i], expected[i]);
    EXPECT_EQ(of(response, ProbeQuantity::Load)[i], expected[i] * 0.06 * 0.1);
  }
  EXPECT_EQ(last(response, ProbeQuantity::Strain), -0.03);
  expect_strain(last(response, ProbeQuantity::PlasticStrain), kLimit);
  expect_strain(last(response, ProbeQuantity::AccumulatedStrain), kLimit);
  EXPECT_EQ(last(response, ProbeQuantity::Dissipation), response.event->dissipation);
  EXPECT_EQ(response.permanent_strain, kLimit);
  EXPECT_EQ(response.samples, 4U);
}

TEST(Break, IsOnlyRecordedIfTheSceneSaysSo) {
  Scene scene = breaking_scene(Deformation::Tension, {0.01, 0.02, 0.03});
  scene.on_break = BreakPolicy::RecordOnly;
  const Response recorded = simulate(scene);
  scene.material.break_strain.reset();
  const Response whole = simulate(scene);
  EXPECT_EQ(recorded.status, Status::Broken);
  EXPECT_EQ(recorded.probes, whole.probes);
  EXPECT_EQ(recorded.permanent_strain, whole.permanent_strain);
  EXPECT_EQ(recorded.event->sample, 1U);
}

}  // namespace
}  // namespace plastica
