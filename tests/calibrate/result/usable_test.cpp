#include "calibrate/result/usable.hpp"

#include <gtest/gtest.h>

namespace plastica::calibrate {
namespace {

FittedParameter at_bound(const char* path, double lower, bool upper = false) {
  FittedParameter parameter;
  parameter.path = path;
  parameter.lower = lower;
  parameter.upper = 10.0;
  parameter.at_lower = !upper;
  parameter.at_upper = upper;
  return parameter;
}

FitResult fitted(std::vector<FittedParameter> parameters, double misfit = 0.01) {
  FitResult result;
  result.status = FitStatus::Fitted;
  result.parameters = std::move(parameters);
  result.misfit_fraction = misfit;
  return result;
}

TEST(Usable, IsAFitThatFollowsItsCurve) {
  EXPECT_TRUE(is_usable(fitted({})));
  EXPECT_TRUE(is_usable(fitted({}, 0.5)));
  EXPECT_EQ(why_unusable(fitted({}, 0.79)), "the misfit is 79 % of the largest value, above 50 %");
  FitResult rejected;
  EXPECT_FALSE(is_usable(rejected));
  EXPECT_EQ(why_unusable(rejected), "") << "its reason stands elsewhere";
}

TEST(Usable, MayHaveOneParameterAtABound) {
  const FittedParameter modulus = at_bound("material.youngs_modulus", 1.0);
  const FittedParameter yield = at_bound("material.yield_stress", 1.0, true);
  EXPECT_TRUE(is_usable(fitted({modulus})));
  EXPECT_EQ(why_unusable(fitted({modulus, yield}, 0.6)),
            "the misfit is 60 % of the largest value, above 50 %; 2 parameters ended at bounds: "
            "youngs_modulus, yield_stress");
  FittedParameter fixed = modulus;
  fixed.role = ParameterRole::Fixed;
  EXPECT_TRUE(is_usable(fitted({fixed, yield})));
}

TEST(Usable, MayEndWhereARightValueLies) {
  const FittedParameter yield = at_bound("material.yield_stress", 1.0);
  EXPECT_TRUE(is_usable(fitted({yield, at_bound("material.break_strain", 1.0, true)})));
  EXPECT_TRUE(is_usable(fitted({yield, at_bound("material.hardening.modulus", 0.0)})));
  EXPECT_TRUE(
      is_usable(fitted({yield, at_bound("material.hardening.kinematic_fraction", 0.1, true)})));
  EXPECT_FALSE(is_usable(fitted({yield, at_bound("material.hardening.modulus", 0.0, true)})));
}

TEST(Usable, GoesByTheWorstTargetOfAJointFit) {
  SceneFitResult result;
  result.status = FitStatus::Fitted;
  result.targets.resize(2);
  result.targets[0].misfit_fraction = 0.02;
  EXPECT_TRUE(is_usable(result));
  result.targets[1].misfit_fraction = 0.7;
  EXPECT_FALSE(is_usable(result));
}

}  // namespace
}  // namespace plastica::calibrate
