#include "calibrate/inference/modulus_warning.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/has.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::has;

std::string said(double fitted, double error, ParameterRole role = ParameterRole::Free,
                 calibrate::Test test = calibrate::Test::Tension) {
  Target target;
  target.test = test;
  target.characteristics.youngs_modulus = 200e9;
  target.characteristics.youngs_modulus_stderr = 2e9;
  FittedParameter p;
  p.path = "material.youngs_modulus";
  p.role = role;
  p.value = fitted;
  p.noise_error = error;
  p.identified = true;
  return modulus_warning(target, std::vector<FittedParameter>{p});
}

TEST(ModulusWarning, IsOfAModulusFarFromTheElasticPart) {
  EXPECT_TRUE(has(said(62e9, 1e9), "youngs_modulus = 62 GPa is not the slope"));
  EXPECT_TRUE(has(said(271e9, 1e9), "200 GPa"));
  EXPECT_EQ(said(219e9, 1e9), "");
  EXPECT_EQ(said(181e9, 1e9), "");
}

TEST(ModulusWarning, LeavesWhatNoiseExplains) {
  EXPECT_EQ(said(250e9, 17e9), "");
  EXPECT_NE(said(260e9, 17e9), "");
}

TEST(ModulusWarning, IsOfAFreeModulusInTensionAlone) {
  EXPECT_EQ(said(62e9, 1e9, ParameterRole::Fixed), "");
  EXPECT_EQ(said(62e9, 1e9, ParameterRole::Free, calibrate::Test::Bending), "");
  EXPECT_EQ(modulus_warning({}, {}), "");
}

}  // namespace
}  // namespace plastica::calibrate
