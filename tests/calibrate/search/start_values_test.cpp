#include "calibrate/search/start_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/calibrate/fit/targets.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

/// E = 200 GPa, yields at 300 MPa, then 2 GPa up to 2 %; characteristics as an import finds them.
Target steel_bar(Deformation test = Deformation::Tension) {
  std::vector<double> strain = ramp(81, 0.02);
  std::vector<double> stress;
  for (const double e : strain)
    stress.push_back(e < 0.0015 ? 200e9 * e : 300e6 + 2e9 * (e - 0.0015));
  Target target = target_of(strain, stress, test);
  target.characteristics.proof_stress = 300e6;
  return target;
}

StartValue start_of(const char* name, const Target& target, const FitOptions& options) {
  return start_value(find_field(name), curve_sizes(target, options), target, options);
}

StartValue start_of(const char* name, const Target& target) {
  const FitOptions ideal;
  return start_of(name, target, ideal);
}

TEST(StartValues, TakeModulusAndYieldFromTheCharacteristics) {
  const double strength = 300e6 + 2e9 * 0.0185;
  EXPECT_NEAR(start_of("youngs_modulus", steel_bar()).start, 200e9, 1.0);
  // Ideal plasticity has to follow both proof stress and strength, hardening begins at the first.
  EXPECT_NEAR(start_of("yield_stress", steel_bar()).start, 0.5 * (300e6 + strength), 1.0);
  FitOptions linear;
  linear.setup.scene.material.hardening.law = HardeningLaw::Linear;
  EXPECT_NEAR(start_of("yield_stress", steel_bar(), linear).start, 300e6, 1.0);
  EXPECT_NEAR(start_of("tangent_modulus", steel_bar(), linear).start, 2e9, 1.0);
  EXPECT_LT(start_of("tangent_modulus", steel_bar(), linear).upper, 200e9);
  Target cyclic = steel_bar();
  cyclic.loading = Loading::Cyclic;
  EXPECT_NEAR(start_of("yield_stress", cyclic).start, 0.8 * strength, 1.0);
}

TEST(StartValues, TranslateTorsionToTheMaterialsOwnNumbers) {
  const Target torsion = steel_bar(Deformation::Torsion);
  FitOptions options;
  options.setup.scene.material.poisson_ratio = 0.25;
  options.setup.scene.material.hardening.law = HardeningLaw::Linear;
  EXPECT_NEAR(start_of("shear_modulus", torsion, options).start, 200e9, 1.0);
  EXPECT_NEAR(start_of("youngs_modulus", torsion, options).start, 2.5 * 200e9, 10.0);
  EXPECT_NEAR(start_of("shear_yield_stress", torsion, options).start, 300e6, 1.0);
  EXPECT_NEAR(start_of("yield_stress", torsion, options).start, std::sqrt(3.0) * 300e6, 1.0);
  EXPECT_NEAR(start_of("tangent_modulus", torsion, options).start, 3.0 * 2e9, 10.0);
  EXPECT_GT(start_of("tangent_modulus", torsion, options).upper, 2.4 * 200e9);
}

TEST(StartValues, TakeTheBreakStrainFromThePermanentStrain) {
  Target target = steel_bar();
  break_at(target, 0.0205, 0.0185);
  EXPECT_EQ(start_of("break_strain", target).start, 0.0185);
  target.test = Deformation::Torsion;
  EXPECT_NEAR(start_of("break_strain", target).start, 0.0185 / std::sqrt(3.0), 1e-15);
  EXPECT_EQ(start_of("break_shear_strain", target).start, 0.0185);
}

TEST(StartValues, StandInWithTheCurvesSizesWhereCharacteristicsAreMissing) {
  Target bare = steel_bar();
  bare.characteristics = {};
  const double strength = 300e6 + 2e9 * 0.0185;
  EXPECT_NEAR(start_of("youngs_modulus", bare).start, strength / 0.02, 1e3);
  EXPECT_NEAR(start_of("yield_stress", bare).start, 0.95 * strength, 1.0);
  EXPECT_NEAR(start_of("break_strain", bare).start, 0.02, 1e-15);
}

TEST(StartValues, ReachFarBelowTheStrainOfASpecimenThatBrokeElastically) {
  Target brittle = steel_bar();
  brittle.characteristics.break_strain_plastic.reset();
  brittle.characteristics.observed_break.emplace();
  const StartValue value = start_of("break_strain", brittle);
  EXPECT_LT(value.lower, 1e-3 * 0.02);
  EXPECT_LT(value.start, 0.1 * 0.02);
  EXPECT_GT(value.upper, 0.02);
}

TEST(StartValues, LieInsideOfBoundsThatLieInTheFieldsRange) {
  FitOptions options;
  Hardening& hardening = options.setup.scene.material.hardening;
  hardening.plastic_strain.fill(0.01);
  hardening.flow_stress.fill(400e6);
  for (const Deformation test : {Deformation::Tension, Deformation::Torsion}) {
    for (const Field& field : fields()) {
      if (!field.material) continue;
      const Target target = steel_bar(test);
      const StartValue value = start_value(field, curve_sizes(target, options), target, options);
      EXPECT_LT(value.lower, value.upper) << field.path;
      EXPECT_GE(value.start, value.lower) << field.path;
      EXPECT_LE(value.start, value.upper) << field.path;
      EXPECT_GE(value.lower, field.range.low) << field.path;
      EXPECT_LE(value.upper, field.range.high) << field.path;
      EXPECT_TRUE(std::isfinite(value.lower) && std::isfinite(value.upper)) << field.path;
      // A factor of ten around the start where the scale is logarithmic.
      if (value.lower > 0.0) {
        EXPECT_LE(value.lower, std::max(value.start / 10.0, field.range.low)) << field.path;
        EXPECT_GE(value.upper, value.start * 10.0) << field.path;
      }
    }
  }
}

/// 200 GPa, a yield stress of 300 MPa + isotropic + kinematic hardening moduli times plastic
/// strain, isotropic down to no less than half; worked step by step.
Target strokes(const std::vector<double>& corners, double isotropic, double kinematic,
               double noise = 0.0) {
  const std::vector<double> strain = path(corners, 200);
  std::vector<double> stress;
  double plastic = 0.0, passed = 0.0;
  Noise random(4);
  for (const double e : strain) {
    const double yield = std::max(150e6, 300e6 + isotropic * passed);
    const double tried = 200e9 * (e - plastic) - kinematic * plastic;
    const double beyond = std::abs(tried) - yield;
    if (beyond > 0.0) {
      const double step = beyond / (200e9 + kinematic + isotropic);
      plastic += std::copysign(step, tried);
      passed += step;
    }
    stress.push_back(200e9 * (e - plastic) + random(noise));
  }
  Target target = target_of(strain, stress);
  target.loading = Loading::Cyclic;
  return target;
}

TEST(StartValues, LetACyclicCurveSoftenThatDoes) {
  const std::vector<double> even{0.008, -0.008, 0.01, -0.01, 0.012, -0.012};
  const std::vector<double> uneven{0.01, -0.004, 0.006, 0.0, 0.012};
  for (const double kinematic : {0.0, 5e9}) {
    const StartValue softens = start_of("saturation_stress", strokes(even, -1e9, kinematic, 1e6));
    EXPECT_LT(softens.start, 0.0);
    EXPECT_LT(softens.lower, -200e6);
    EXPECT_GT(softens.upper, 200e6);
    for (const std::vector<double>& corners : {even, uneven}) {
      for (const double isotropic : {0.0, 1e9}) {
        for (const double noise : {0.0, 3e6}) {
          EXPECT_GT(
              start_of("saturation_stress", strokes(corners, isotropic, kinematic, noise)).lower,
              0.0);
        }
      }
    }
  }
  // A strain with noise turns at every sample.
  Target noisy = strokes(even, 1e9, 5e9, 1e6);
  Noise of_strain(6);
  for (double& e : noisy.corrected.strain) e += of_strain(1e-4);
  EXPECT_GT(start_of("saturation_stress", noisy).lower, 0.0);
  noisy = strokes(even, -1e9, 0.0, 1e6);
  for (double& e : noisy.corrected.strain) e += of_strain(3e-5);
  EXPECT_LT(start_of("saturation_stress", noisy).lower, 0.0);
  // A fall after the largest stress of one stroke may be a neck.
  Target once = strokes({0.05}, -2e9, 0.0);
  once.loading = Loading::Monotonic;
  EXPECT_GT(start_of("saturation_stress", once).lower, 0.0);
}

}  // namespace
}  // namespace plastica::calibrate
