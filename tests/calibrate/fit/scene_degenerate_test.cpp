#include <gtest/gtest.h>

#include "tests/calibrate/fit/bilinear_coupon.hpp"

namespace plastica::calibrate {
namespace {

using testing::bounded;

/// At one rate Cowper and Symonds' factor f = 1 + (rate/C)^(1/P) scales yield stress and slope
/// beyond it: the curve has f Y and f H, and none of the four by itself. Both directions that it
/// does not show are to be seen: with C and P given up, Y and H would count as determined.
TEST(SceneFit, DeterminesNoParameterOfTwoDirectionsThatNoCurveShows) {
  plastica::Setup setup = testing::bilinear_coupon();
  RateDependence& rate = setup.scene.material.rate;
  rate = {RateLaw::CowperSymonds, 40.0, 5.0, {}, 1.0};
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const SceneTarget target = testing::noisy_bilinear({}, 2e-3, seed, 40);
    const SceneFitOptions options{
        .parameters = {bounded("yield_stress", 0.05, 0.3), bounded("tangent_modulus", 0.01, 0.5),
                       bounded("material.rate.reference_rate", 1.0, 1e4),
                       bounded("material.rate.exponent", 1.0, 20.0)},
        .starts = 4,
        .segments_error = false};
    const SceneFitResult result = fit_scene(setup, target, options);
    ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
    for (const char* name : {"yield_stress", "tangent_modulus", "reference_rate", "exponent"}) {
      EXPECT_EQ(result.parameter(name).verdict(), Verdict::NotIdentified) << name << ", " << seed;
    }
  }
}

/// E, of an elastic part that is short beside its noise, has the same error whether the rate's
/// parameters are held or free: what f Y and f H may be is known no better.
TEST(SceneFit, HasTheErrorsOfOneWhoseUndeterminedParametersAreHeld) {
  plastica::Setup setup = testing::bilinear_coupon();
  setup.scene.material.rate = {RateLaw::CowperSymonds, 40.0, 5.0, {}, 1.0};
  const SceneTarget target = testing::noisy_bilinear({}, 5e-3, 3, 40);
  const auto fitted = [&](bool free) {
    std::vector<Parameter> parameters{bounded("youngs_modulus", 0.5, 5.0),
                                      bounded("yield_stress", 0.05, 0.3),
                                      bounded("tangent_modulus", 0.01, 0.5)};
    if (free) {
      parameters.push_back(bounded("material.rate.reference_rate", 1.0, 1e4));
      parameters.push_back(bounded("material.rate.exponent", 1.0, 20.0));
    }
    return fit_scene(setup, target,
                     {.parameters = parameters, .starts = 4, .segments_error = false});
  };
  const SceneFitResult held = fitted(false), free = fitted(true);
  for (const char* name : {"yield_stress", "tangent_modulus"}) {
    EXPECT_EQ(free.parameter(name).verdict(), Verdict::NotIdentified) << name;
  }
  const double error = held.parameter("youngs_modulus").standard_error;
  EXPECT_GT(error, 0.0);
  // Of 40 samples the two parameters more take two degrees of freedom, or none.
  EXPECT_NEAR(free.parameter("youngs_modulus").standard_error, error, 0.04 * error);
}

}  // namespace
}  // namespace plastica::calibrate
