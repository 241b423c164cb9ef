#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/problem/misfit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

constexpr double kRatedYoung = 200e9;
constexpr double kRatedYield = 300e6;
constexpr double kRatedModulus = 2e9;  ///< of the yield stress over plastic strain

/// A test at a rate that multiplies the yield stress and its growth by a factor, by hand.
Target test_at(double rate, double factor) {
  std::vector<double> strain, stress;
  for (int i = 0; i < 30; ++i) {
    stress.push_back(factor * kRatedYield * i / 30);
    strain.push_back(stress.back() / kRatedYoung);
  }
  for (int i = 0; i <= 100; ++i) {
    const double p = 0.05 * i / 100;
    stress.push_back(factor * (kRatedYield + kRatedModulus * p));
    strain.push_back(p + stress.back() / kRatedYoung);
  }
  Target target = target_of(strain, stress);
  target.properties = {{"strain_rate", rate}};
  return target;
}

/// The quasi-static law is known; one parameter of the rate law is not.
FitOptions options_of(const RateDependence& rate, const char* free) {
  FitOptions options = fit_of({free_parameter(free)});
  Material& material = options.setup.scene.material;
  material.youngs_modulus = kRatedYoung;
  material.yield_stress = kRatedYield;
  material.hardening.law = HardeningLaw::Linear;
  material.hardening.tangent_modulus = kRatedYoung * kRatedModulus / (kRatedYoung + kRatedModulus);
  material.rate = rate;
  return options;
}

TEST(RateFit, RecoversEachParameterOfARateLaw) {
  const RateDependence symonds{RateLaw::CowperSymonds, 100.0, 4.0, {}, {}};
  const RateDependence cook{RateLaw::JohnsonCook, 1e-3, {}, 0.002, {}};
  const double raised = 1.0 + std::pow(250.0 / 40.4, 0.2);
  const auto fitted = [](const Target& target, const RateDependence& rate, const char* name) {
    const FitResult result = fit_target(target, options_of(rate, name));
    EXPECT_EQ(result.status, FitStatus::Fitted) << result.reason;
    EXPECT_TRUE(result.parameter(name).identified) << name;
    return result.parameter(name).value;
  };
  RateDependence known = symonds;
  known.exponent = 5.0;
  EXPECT_NEAR(fitted(test_at(250.0, raised), known, "reference_rate"), 40.4, 4e-3);
  known = symonds;
  known.reference_rate = 40.4;
  EXPECT_NEAR(fitted(test_at(250.0, raised), known, "exponent"), 5.0, 1e-4);
  const double logarithm = 1.0 + 0.015 * std::log(250.0 / 1e-3);
  EXPECT_NEAR(fitted(test_at(250.0, logarithm), cook, "coefficient"), 0.015, 1e-6);
}

TEST(RateFit, HasTheGradientOfItsCost) {
  FitOptions options = options_of({RateLaw::CowperSymonds, 100.0, 4.0, {}, {}}, "reference_rate");
  options.parameters.push_back(free_parameter("exponent"));
  options.parameters.push_back(free_parameter("yield_stress"));
  const Target target = test_at(250.0, 2.0);
  const ParameterSet parameters(target, options);
  Misfit misfit(target, options, parameters);
  const std::vector<double> at{100.0, 4.0, 280e6};
  std::vector<double> gradient(3);
  (void)misfit.cost(at, gradient);
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 2> cost{};
    for (const double direction : {-1.0, 1.0}) {
      std::vector<double> moved = at;
      moved[k] *= 1.0 + 1e-5 * direction;
      cost[direction > 0.0 ? 1 : 0] = misfit.cost(moved, {});
    }
    const double slope = (cost[1] - cost[0]) / (2e-5 * at[k]);
    EXPECT_NEAR(gradient[k], slope, 1e-4 * std::fabs(slope)) << k;
  }
}

/// One test shows f Y and f H, f the rate's factor, and no rate parameter: with it free neither is
/// determined, and E, which is, has the error of a fit that holds it.
TEST(RateFit, HasTheErrorsOfOneWhoseUndeterminedParameterIsHeld) {
  Target target = test_at(250.0, 2.0);
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0.0, 20e6);
  for (double& stress : target.corrected.stress) stress += noise(random);
  const auto fitted = [&](const std::vector<const char*>& names) {
    FitOptions options = options_of({RateLaw::CowperSymonds, 250.0, 4.0, {}, {}}, "youngs_modulus");
    for (const char* name : names) options.parameters.push_back(free_parameter(name));
    return fit_target(target, options);
  };
  const FitResult held = fitted({"yield_stress", "tangent_modulus"});
  const FitResult free = fitted({"yield_stress", "tangent_modulus", "reference_rate"});
  for (const char* name : {"yield_stress", "tangent_modulus", "reference_rate"}) {
    EXPECT_FALSE(free.parameter(name).identified) << name;
  }
  ASSERT_TRUE(free.parameter("youngs_modulus").identified);
  EXPECT_GT(held.parameter("youngs_modulus").noise_error, 0.0);
  EXPECT_NEAR(free.parameter("youngs_modulus").noise_error,
              held.parameter("youngs_modulus").noise_error,
              0.02 * held.parameter("youngs_modulus").noise_error);
}

TEST(RateFit, RefusesWhatWouldMoveNothing) {
  const auto message = [](const FitOptions& options) {
    return message_of([&] { (void)fit_target(test_at(250.0, 2.0), options); });
  };
  EXPECT_EQ(message(options_of({}, "exponent")),
            "exponent: is no parameter of material.rate.law = \"none\": it would move nothing");
  EXPECT_EQ(message(options_of({RateLaw::JohnsonCook, 1.0, {}, 0.1, {}}, "exponent")),
            "exponent: is no parameter of material.rate.law = \"johnson_cook\": it would move "
            "nothing");
  EXPECT_EQ(message(options_of({}, "yield_stress")),
            "target.strain_rate: is of no use without a law, material.rate.law: it would move "
            "nothing");
}

}  // namespace
}  // namespace plastica::calibrate
