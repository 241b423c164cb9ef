#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

FitOptions fit_of_law(HardeningLaw law, const std::vector<std::string>& more) {
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  for (const std::string& name : more) options.parameters.push_back(free_parameter(name.c_str()));
  options.setup.scene.material.hardening.law = law;
  return options;
}

TEST(TableFit, RecoversTheStressesOfATable) {
  FitOptions options = fit_of_law(HardeningLaw::Multilinear, {"flow_stress_1", "flow_stress_2"});
  Material& material = options.setup.scene.material;
  material.hardening.plastic_strain = {0.01, 0.04};
  // The curve of the truth, by hand; the fit begins elsewhere.
  material.hardening.flow_stress = {360e6, 360e6};
  const double E = 190e9, begin = 317e6, middle = 352e6, end = 401e6;
  std::vector<double> strain, stress;
  for (int i = 0; i < 40; ++i) {
    stress.push_back(begin * i / 40);
    strain.push_back(stress.back() / E);
  }
  for (int i = 0; i <= 160; ++i) {
    const double p = 0.05 * i / 160;
    stress.push_back(p < 0.01   ? begin + (middle - begin) * p / 0.01
                     : p < 0.04 ? middle + (end - middle) * (p - 0.01) / 0.03
                                : end);
    strain.push_back(p + stress.back() / E);
  }
  const FitResult result = fit_target(target_of(strain, stress), options);
  const auto expect_near = [&](const char* name, double truth) {
    EXPECT_NEAR(result.parameter(name).value, truth, tolerance(1e-6 * truth)) << name;
  };
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
  expect_near("youngs_modulus", E);
  expect_near("yield_stress", begin);
  expect_near("flow_stress_1", middle);
  expect_near("flow_stress_2", end);
}

TEST(TableFit, RefusesParametersOfHardeningThatMoveNothing) {
  const auto message = [](HardeningLaw law, const char* name, std::vector<Law> laws = {}) {
    FitOptions options = fit_of_law(law, {name});
    options.setup.scene.material.hardening.plastic_strain = {0.01, 0.04};
    options.setup.scene.material.hardening.flow_stress = {360e6, 370e6};
    options.laws = std::move(laws);
    return message_of([&] {
      (void)fit_target(target_of({0.0, 0.001, 0.002}, {0.0, 200e6, 300e6}), options);
    });
  };
  const std::string of_ideal =
      ": is no parameter of material.hardening.law = \"ideal\": it would move nothing";
  EXPECT_EQ(message(HardeningLaw::Ideal, "tangent_modulus"), "tangent_modulus" + of_ideal);
  EXPECT_EQ(message(HardeningLaw::Ideal, "flow_stress_1"), "flow_stress_1" + of_ideal);
  EXPECT_EQ(message(HardeningLaw::Ideal, "saturation_rate", {Law::Linear}),
            "saturation_rate" + of_ideal);
  EXPECT_EQ(message(HardeningLaw::Multilinear, "flow_stress_3"),
            "flow_stress_3: is no point of the table, which has 2");
}

}  // namespace
}  // namespace plastica::calibrate
