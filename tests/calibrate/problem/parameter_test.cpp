#include "calibrate/problem/parameter.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

std::string refusal(std::vector<Parameter> parameters) {
  for (Parameter& p : parameters) p.where = {"fit.toml", 7};
  return message_of([&] { check_parameters(parameters); });
}

/// A yield stress with bounds and a start, each of them as an optional.
Parameter yield(std::optional<double> lower, std::optional<double> upper,
                std::optional<double> start = {}) {
  Parameter p = free_parameter("yield_stress");
  p.lower = lower;
  p.upper = upper;
  p.value = start;
  return p;
}

TEST(Parameters, AreNamedByTheLastPartOfTheirPath) {
  EXPECT_EQ(free_parameter("yield_stress").name(), "yield_stress");
  EXPECT_EQ(free_parameter("material.hardening.saturation_rate").name(), "saturation_rate");
}

TEST(Parameters, PassWhenTheyAreRight) {
  EXPECT_EQ(refusal({yield(10e6, 2e9, 300e6), fixed_parameter("youngs_modulus", 200e9),
                     tied_parameter("shear_yield_stress", "yield_stress", 0.6)}),
            "no error");
  EXPECT_EQ(refusal({yield(10e6, 2e9, 10e6)}), "no error");
  EXPECT_EQ(refusal({yield({}, {})}), "no error");
}

TEST(Parameters, RefuseBoundsWithoutRoom) {
  const std::string rule = ": the lower bound must be below the upper one";
  EXPECT_EQ(refusal({yield(2e9, 1e7)}), "fit.toml:7: yield_stress = [2e+09, 1e+07]" + rule);
  EXPECT_EQ(refusal({yield(1e7, 1e7)}), "fit.toml:7: yield_stress = [1e+07, 1e+07]" + rule);
}

TEST(Parameters, RefuseAStartBesideItsBounds) {
  EXPECT_EQ(refusal({yield(1e7, 2e9, 9e6)}),
            "fit.toml:7: yield_stress = 9e+06: the start must not be below the lower bound");
  EXPECT_EQ(refusal({yield(1e7, 2e9, 3e9)}),
            "fit.toml:7: yield_stress = 3e+09: the start must not be above the upper bound");
}

TEST(Parameters, RefuseNumbersOutsideOfTheFieldsRange) {
  EXPECT_EQ(refusal({yield(-1.0, {})}),
            "fit.toml:7: material.yield_stress = -1: must be above 0 Pa");
  EXPECT_EQ(refusal({yield({}, {}, 0.0)}),
            "fit.toml:7: material.yield_stress = 0: must be above 0 Pa");
  EXPECT_EQ(refusal({yield({}, {}), fixed_parameter("kinematic_fraction", 1.5)}),
            "fit.toml:7: material.hardening.kinematic_fraction = 1.5: must be from 0 to 1");
}

TEST(Parameters, RefuseALogarithmFromZero) {
  Parameter tangent = free_parameter("tangent_modulus");
  tangent.lower = 0.0;
  tangent.scale = ParameterScale::Logarithmic;
  EXPECT_EQ(refusal({tangent}),
            "fit.toml:7: tangent_modulus = 0: a logarithmic scale needs a lower bound above 0");
}

TEST(Parameters, RefuseAFieldGivenTwice) {
  EXPECT_EQ(refusal({yield({}, {}), fixed_parameter("yield_stress", 3e8)}),
            "fit.toml:7: yield_stress: is given twice");
}

TEST(Parameters, RefuseFieldsThatNoFitCanMove) {
  EXPECT_EQ(refusal({free_parameter("material.density")}),
            "fit.toml:7: density: is not a material field, so a fit cannot move it");
}

TEST(Parameters, RefuseAFixedOneWithoutValue) {
  Parameter modulus = free_parameter("youngs_modulus");
  modulus.role = ParameterRole::Fixed;
  EXPECT_EQ(refusal({yield({}, {}), modulus}),
            "fit.toml:7: youngs_modulus: is fixed and needs a value");
}

TEST(Parameters, RefuseTiesThatLeadNowhere) {
  EXPECT_EQ(refusal({yield({}, {}), tied_parameter("shear_modulus", "shear_modulus", 1.0)}),
            "fit.toml:7: shear_modulus: must not be tied to itself");
  const std::string rule = ": must be tied to a free or fixed parameter of the fit";
  EXPECT_EQ(refusal({yield({}, {}), tied_parameter("shear_modulus", "youngs_modulus", 0.4)}),
            "fit.toml:7: shear_modulus = material.youngs_modulus" + rule);
  EXPECT_EQ(refusal({yield({}, {}), tied_parameter("shear_yield_stress", "yield_stress", 0.6),
                     tied_parameter("saturation_stress", "shear_yield_stress", 0.1)}),
            "fit.toml:7: saturation_stress = material.shear_yield_stress" + rule);
}

TEST(Parameters, NeedAFreeOne) {
  EXPECT_EQ(refusal({fixed_parameter("yield_stress", 3e8)}),
            "fit.parameters: at least one must be free");
  EXPECT_EQ(refusal({}), "fit.parameters: at least one must be free");
}

}  // namespace
}  // namespace plastica::calibrate
