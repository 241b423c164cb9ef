#include "plastica/model/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace plastica {
namespace {

TEST(Material, DerivesShearFromTheIsotropicRelations) {
  const Material m{.youngs_modulus = 200e9, .poisson_ratio = 0.25, .yield_stress = 300e6};
  EXPECT_DOUBLE_EQ(resolved_shear_modulus(m), 80e9);
  EXPECT_DOUBLE_EQ(resolved_shear_yield_stress(m), 300e6 / std::sqrt(3.0));
}

TEST(Material, GivenShearValuesWin) {
  const Material m{.shear_modulus = 0.69e9,
                   .shear_yield_stress = 4e6,
                   .break_strain = 0.1,
                   .break_shear_strain = 0.3};
  EXPECT_EQ(resolved_shear_modulus(m), 0.69e9);
  EXPECT_EQ(resolved_shear_yield_stress(m), 4e6);
  EXPECT_EQ(resolved_break_shear_strain(m), 0.3);
}

TEST(Material, WithoutALimitNothingBreaks) {
  EXPECT_FALSE(Material{}.break_strain.has_value());
  EXPECT_FALSE(resolved_break_shear_strain(Material{}).has_value());
}

TEST(Material, BreakShearStrainFollowsTheBreakStrain) {
  EXPECT_DOUBLE_EQ(*resolved_break_shear_strain({.break_strain = 0.1}), 0.1 * std::sqrt(3.0));
}

TEST(Material, PlasticModulusGivesTheTangentInSeriesWithElasticity) {
  const double E = 200e9, Et = 2e9;
  const double H = plastic_modulus(E, Et);
  EXPECT_NEAR(E * H / (E + H), Et, 1e-5);
  EXPECT_EQ(plastic_modulus(E, 0.0), 0.0);
}

TEST(Material, DefaultIsValid) { EXPECT_NO_THROW(check_material({})); }

struct BadMaterial {
  std::function<void(Material&)> spoil;
  std::string message;
};

class MaterialRejects : public ::testing::TestWithParam<BadMaterial> {};

TEST_P(MaterialRejects, ByNamingFieldValueAndRule) {
  Material m;
  GetParam().spoil(m);
  try {
    check_material(m, {.file = "a.toml", .line = 7});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "a.toml:7: material." + GetParam().message);
  }
}

const std::string kPositive = "must be positive and finite";

INSTANTIATE_TEST_SUITE_P(
    Material, MaterialRejects,
    ::testing::Values(
        BadMaterial{[](Material& m) { m.youngs_modulus = 0.0; },
                    "youngs_modulus = 0: " + kPositive},
        BadMaterial{[](Material& m) { m.poisson_ratio = 0.51; },
                    "poisson_ratio = 0.51: must be above -1 and at most 0.5"},
        BadMaterial{[](Material& m) { m.poisson_ratio = std::nan(""); },
                    "poisson_ratio = nan: must be above -1 and at most 0.5"},
        BadMaterial{[](Material& m) { m.shear_modulus = -1.0; },
                    "shear_modulus = -1: " + kPositive},
        BadMaterial{[](Material& m) { m.density = 0.0; }, "density = 0: " + kPositive},
        BadMaterial{[](Material& m) { m.yield_stress = -355e6; },
                    "yield_stress = -3.55e+08: " + kPositive},
        BadMaterial{[](Material& m) { m.shear_yield_stress = 0.0; },
                    "shear_yield_stress = 0: " + kPositive},
        BadMaterial{[](Material& m) { m.break_strain = 0.0; }, "break_strain = 0: " + kPositive},
        BadMaterial{[](Material& m) { m.break_shear_strain = -0.1; },
                    "break_shear_strain = -0.1: " + kPositive},
        BadMaterial{[](Material& m) {
                      m.hardening = {.law = HardeningLaw::Linear, .tangent_modulus = 210e9};
                    },
                    "hardening.tangent_modulus = 2.1e+11: must be below "
                    "material.youngs_modulus = 2.1e+11"},
        BadMaterial{[](Material& m) {
                      m.hardening = {.law = HardeningLaw::Linear, .kinematic_fraction = 1.5};
                    },
                    "hardening.kinematic_fraction = 1.5: must be from 0 to 1"},
        BadMaterial{[](Material& m) {
                      m.hardening = {.law = HardeningLaw::VoceChaboche,
                                     .saturation_stress = -355e6};
                    },
                    "hardening.saturation_stress = -3.55e+08: must be above "
                    "-material.yield_stress = -3.55e+08"},
        BadMaterial{[](Material& m) {
                      m.hardening = {.law = HardeningLaw::VoceChaboche, .saturation_rate = -1.0};
                    },
                    "hardening.saturation_rate = -1: must be at least 0"},
        BadMaterial{[](Material& m) {
                      m.hardening = {.law = HardeningLaw::VoceChaboche,
                                     .backstress_modulus = {0.0, -1.0, 0.0}};
                    },
                    "hardening.backstress_modulus_2 = -1: must be at least 0 Pa"},
        BadMaterial{[](Material& m) {
                      m.hardening = {.law = HardeningLaw::VoceChaboche,
                                     .backstress_rate = {0.0, 0.0, -2.0}};
                    },
                    "hardening.backstress_rate_3 = -2: must be at least 0"},
        BadMaterial{[](Material& m) { m.hardening = {.law = HardeningLaw::Multilinear}; },
                    "hardening.plastic_strain_1 = 0: must be above 0: the table has no point"},
        BadMaterial{[](Material& m) {
                      m.hardening = {.law = HardeningLaw::Multilinear,
                                     .plastic_strain = {0.02, 0.01},
                                     .flow_stress = {400e6, 410e6}};
                    },
                    "hardening.plastic_strain_2 = 0.01: must be above the one before, 0.02"},
        BadMaterial{[](Material& m) {
                      m.hardening = {.law = HardeningLaw::Multilinear,
                                     .plastic_strain = {0.01, 0.0, 0.02},
                                     .flow_stress = {400e6, 0.0, 410e6}};
                    },
                    "hardening.plastic_strain_3 = 0.02: must follow the points before it without "
                    "a gap"},
        BadMaterial{
            [](Material& m) {
              m.hardening = {.law = HardeningLaw::Multilinear,
                             .plastic_strain = {0.01, 0.02},
                             .flow_stress = {400e6}};
            },
            "hardening.flow_stress_2 = 0: must be above 0: the point's plastic strain has none"},
        BadMaterial{[](Material& m) {
                      m.hardening = {.law = HardeningLaw::Multilinear,
                                     .plastic_strain = {0.001},
                                     .flow_stress = {300e6}};
                    },
                    "hardening.flow_stress_1 = 3e+08: falls from 3.55e+08 more steeply than "
                    "2.1e+10 Pa, a tenth of the elastic modulus"}));

TEST(Material, ParametersOfOtherLawsAreIgnored) {
  Material m;
  m.hardening = {.law = HardeningLaw::Ideal, .tangent_modulus = 1e15, .saturation_rate = -1.0};
  EXPECT_NO_THROW(check_material(m));
}

}  // namespace
}  // namespace plastica
