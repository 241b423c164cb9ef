#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/scene.hpp"
#include "tests/support/tolerance.hpp"

/// Coupons under strain histories against closed forms, each law in each deformation.
namespace plastica {
namespace {

using testing::coupon_scene;
using testing::kE;
using testing::kG;
using testing::kYield;
using testing::last;
using testing::last_stress;
using testing::of;
using testing::tolerance;

struct Uniaxial {
  Deformation deformation;
  double stiffness;
  double yield;
  double r;  ///< yield stress over shear yield stress; 1 outside of torsion
};

const std::vector<Uniaxial> kCoupons{
    {Deformation::Tension, kE, kYield, 1.0},
    {Deformation::Bending, kE, kYield, 1.0},
    {Deformation::Torsion, kG, kYield / std::numbers::sqrt3, std::numbers::sqrt3}};

void expect_stress(double computed, double expected) {
  EXPECT_NEAR(computed, expected, tolerance(1e-12) * kYield);
}

TEST(Coupon, OfIdealPlasticityLoadsUnloadsAndYieldsInReverse) {
  for (const Uniaxial& c : kCoupons) {
    const double y = c.yield / c.stiffness;
    Scene scene = coupon_scene(c.deformation, {0.5 * y, y, 5.0 * y, 4.0 * y, 3.0 * y, 2.0 * y});
    const std::vector<double> stress = of(simulate(scene), ProbeQuantity::Stress);
    const double expected[] = {0.5, 1.0, 1.0, 0.0, -1.0, -1.0};
    for (std::size_t i = 0; i < stress.size(); ++i) expect_stress(stress[i], expected[i] * c.yield);
  }
}

TEST(Coupon, OfLinearHardeningFollowsTheTangentModulusAndTheBauschingerEffect) {
  for (const Uniaxial& c : kCoupons) {
    // By equal plastic work the plastic modulus in shear is that of tension over r^2.
    const double modulus = kE * 2e9 / (kE - 2e9) / (c.r * c.r);
    const double tangent = c.stiffness * modulus / (c.stiffness + modulus);
    const double y = c.yield / c.stiffness;
    const double top = c.yield + tangent * 9.0 * y;
    for (const double fraction : {0.0, 0.4, 1.0}) {
      // Reversed yield: kinematic hardening keeps the elastic range of 2 Y, isotropic widens it.
      const double range = 2.0 * (c.yield + (1.0 - fraction) * (top - c.yield));
      Scene scene =
          coupon_scene(c.deformation, {10.0 * y, 10.0 * y - range / c.stiffness, -20.0 * y});
      scene.material.hardening.law = HardeningLaw::Linear;
      scene.material.hardening.tangent_modulus = 2e9;
      scene.material.hardening.kinematic_fraction = fraction;
      const std::vector<double> stress = of(simulate(scene), ProbeQuantity::Stress);
      expect_stress(stress[0], top);
      expect_stress(stress[1], top - range);
      const double rest = -20.0 * y - scene.drive.strain[1];
      expect_stress(stress[2], top - range + tangent * rest);
    }
  }
}

TEST(Coupon, OfLinearHardeningHasTheTangentModulusAsSlopeInTension) {
  Scene scene = coupon_scene(Deformation::Tension, {0.01, 0.02});
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 2e9;
  const std::vector<double> stress = of(simulate(scene), ProbeQuantity::Stress);
  EXPECT_NEAR((stress[1] - stress[0]) / 0.01, 2e9, tolerance(1e-9) * 2e9);
}

TEST(Coupon, OfVoceAndChabocheFollowsTheMonotonicClosedForm) {
  for (const Uniaxial& c : kCoupons) {
    Scene scene = coupon_scene(c.deformation, {0.03});
    Hardening& h = scene.material.hardening;
    h.law = HardeningLaw::VoceChaboche;
    h.saturation_stress = 80e6;
    h.saturation_rate = 12.0;
    h.backstress_modulus = {20e9, 4e9, 0.5e9};
    h.backstress_rate = {300.0, 40.0, 0.0};
    const Response response = simulate(scene);
    // In terms of tension: e_p = gamma_p/r, sigma = r tau.
    const double p = last(response, ProbeQuantity::PlasticStrain) / c.r;
    const double sigma = kYield + 80e6 * (1.0 - std::exp(-12.0 * p)) +
                         20e9 / 300.0 * (1.0 - std::exp(-300.0 * p)) +
                         4e9 / 40.0 * (1.0 - std::exp(-40.0 * p)) + 0.5e9 * p;
    expect_stress(last(response, ProbeQuantity::Stress), sigma / c.r);
    expect_stress(last(response, ProbeQuantity::Stress), c.stiffness * (0.03 - c.r * p));
  }
}

TEST(Coupon, InTorsionDoesThePlasticWorkOfTensionAtEquivalentStrain) {
  for (const HardeningLaw law : {HardeningLaw::Linear, HardeningLaw::VoceChaboche}) {
    const auto with = [&](Deformation deformation, double strain) {
      Scene scene = coupon_scene(deformation, {strain});
      Hardening& h = scene.material.hardening;
      h = {law,           2e9,           0.3, 80e6, 12.0, {20e9, 0.0, 0.0}, {300.0, 0.0, 0.0},
           {0.002, 0.01}, {330e6, 400e6}};
      return simulate(scene);
    };
    const Response tension = with(Deformation::Tension, 0.03);
    // The shear strain that has the equivalent plastic strain, and the elastic one on top.
    const double root = std::numbers::sqrt3;
    const double gamma = root * last(tension, ProbeQuantity::PlasticStrain) +
                         last(tension, ProbeQuantity::Stress) / root / kG;
    const Response torsion = with(Deformation::Torsion, gamma);
    const double work = last(tension, ProbeQuantity::Dissipation);
    EXPECT_NEAR(last(torsion, ProbeQuantity::Dissipation), work, tolerance(1e-10) * work);
    EXPECT_NEAR(last(torsion, ProbeQuantity::Stress) * root, last(tension, ProbeQuantity::Stress),
                tolerance(1e-10) * kYield);
  }
}

TEST(Coupon, CapsItsLoadAtTheFullyPlasticMoment) {
  Scene scene = coupon_scene(Deformation::Bending, {0.1});
  scene.yield_cap = YieldCap::FullyPlastic;
  const double expected = kYield * 0.06 * 0.1 * 0.1 / 4.0;
  EXPECT_NEAR(last(simulate(scene), ProbeQuantity::Load), expected, tolerance(1e-13) * expected);
}

TEST(Coupon, OfTheReportIsHalfAsStiffAndYieldsByItsEquationFour) {
  Scene scene = coupon_scene(Deformation::Bending, {1e-4, 0.1});
  scene.formulas = Formulas::Report;
  const std::vector<double> moment = of(simulate(scene), ProbeQuantity::Load);
  const double second_moment = 0.06 * 1e-3 / 12.0;
  const double curvature = 1e-4 / 0.05;
  EXPECT_NEAR(moment[0], 0.5 * kE * second_moment * curvature, tolerance(1e-13) * moment[0]);
  EXPECT_NEAR(moment[1], kYield * second_moment / 0.06, tolerance(1e-13) * moment[1]);
}

TEST(Coupon, DoesNotDependOnHowDenselyAStraightPathIsSampled) {
  for (const HardeningLaw law : {HardeningLaw::Ideal, HardeningLaw::Linear,
                                 HardeningLaw::VoceChaboche, HardeningLaw::Multilinear}) {
    std::vector<double> fine;
    for (int i = 1; i <= 500; ++i) fine.push_back(0.02 * i / 500.0);
    for (int i = 1; i <= 500; ++i) fine.push_back(0.02 - 0.03 * i / 500.0);
    Scene coarse = coupon_scene(Deformation::Tension, {0.02, -0.01});
    coarse.material.hardening = {
        law,           2e9,           0.3, 80e6, 12.0, {20e9, 1e9, 0.0}, {300.0, 0.0, 0.0},
        {0.002, 0.01}, {330e6, 400e6}};
    Scene dense = coarse;
    dense.drive.strain = fine;
    EXPECT_NEAR(last_stress(dense), last_stress(coarse), tolerance(1e-10) * kYield);
    EXPECT_NEAR(last(simulate(dense), ProbeQuantity::Dissipation),
                last(simulate(coarse), ProbeQuantity::Dissipation), tolerance(1e-10) * kYield);
  }
}

}  // namespace
}  // namespace plastica
