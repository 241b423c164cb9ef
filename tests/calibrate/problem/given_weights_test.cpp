#include "calibrate/problem/given_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/problem/misfit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

FitOptions weighted(std::vector<WeightStep> weights) {
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  options.objective = Objective::LeastSquares;
  options.weights = std::move(weights);
  return options;
}

/// Ideal plasticity up to 1 %, and a hardening from there to 2 % that its model cannot follow.
Target two_branches() {
  const std::vector<double> strain = ramp(201, 0.02);
  std::vector<double> stress = ideal_curve(strain, 200e9, 300e6);
  for (std::size_t i = 0; i < strain.size(); ++i) {
    if (strain[i] >= 0.01) stress[i] += 50e6 + 5e9 * (strain[i] - 0.01);
  }
  return target_of(strain, stress);
}

TEST(GivenWeights, AreASlopelessStaircaseOverTheSizeOfTheStrain) {
  const std::vector<WeightStep> steps{{0.01, 0.5}, {0.02, 0.0}, {0.03, 4.0}};
  EXPECT_EQ(given_weight(steps, 0.0), 1.0);
  EXPECT_EQ(given_weight(steps, std::nextafter(0.01, 0.0)), 1.0);
  EXPECT_EQ(given_weight(steps, 0.01), 0.5);
  EXPECT_EQ(given_weight(steps, 0.02), 0.0);
  EXPECT_EQ(given_weight(steps, 1.0), 4.0);
  EXPECT_EQ(given_weight(steps, -0.015), 0.5);
  EXPECT_EQ(given_weight({{0.0, 3.0}}, 0.0), 3.0);
  EXPECT_EQ(given_weight({}, 0.5), 1.0);
}

TEST(GivenWeights, EnterTheCostWithTheNoise) {
  // E = 200 GPa, Y = 300 MPa: r = 0, 10, -20, 40 MPa at these strains.
  const Target target = target_of({0.0, 0.001, -0.002, 0.006}, {0.0, 190e6, -280e6, 260e6});
  FitOptions options = weighted({{0.001, 3.0}, {0.002, 0.25}, {0.005, 0.0}});
  const double expected = (3.0 * 100.0 + 0.25 * 400.0) / (1.0 + 3.0 + 0.25) * 1e12;
  const auto check = [&](double unit) {
    const ParameterSet set(target, options);
    Misfit misfit(target, options, set);
    const std::vector<double> at{200e9, 300e6};
    EXPECT_NEAR(misfit.cost(at, {}), expected, tolerance(1e-12 * expected));
    EXPECT_EQ(misfit.samples(), 3U);
    const std::vector<double> weight{unit, 3.0 * unit, 0.25 * unit, 0.0};
    const auto found = misfit.details(at).weight;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(found[i], weight[i]);
  };
  check(1.0);
  options.noise = 2e6;
  check(0.25e-12);
}

TEST(GivenWeights, OfZeroLeaveSamplesOutOfTheFit) {
  const Target target = two_branches();
  const FitResult whole = fit_target(target, weighted({}));
  EXPECT_EQ(whole.samples, 201U);
  EXPECT_GT(whole.parameter("yield_stress").value, 330e6);

  const FitResult part = fit_target(target, weighted({{0.01, 0.0}}));
  ASSERT_EQ(part.status, FitStatus::Fitted) << part.reason;
  EXPECT_EQ(part.samples, 100U);
  EXPECT_NEAR(part.parameter("youngs_modulus").value, 200e9, tolerance(200.0));
  EXPECT_NEAR(part.parameter("yield_stress").value, 300e6, tolerance(0.3));
  // The half that is left out does not count as misfit or noise either.
  EXPECT_LT(part.misfit_rms, 1.0);
  EXPECT_LT(part.parameter("yield_stress").standard_error, 1.0);
  // Another tail, another search, the same answer.
  Target other = target;
  for (std::size_t i = 100; i < 201; ++i) other.corrected.stress[i] = 900e6;
  const FitResult same = fit_target(other, weighted({{0.01, 0.0}}));
  EXPECT_NEAR(same.parameter("yield_stress").value, 300e6, tolerance(0.3));
}

TEST(GivenWeights, PullTheFitToTheHeavierPart) {
  const Target target = two_branches();
  const auto yield = [&](double weight) {
    return fit_target(target, weighted({{0.01, weight}})).parameter("yield_stress").value;
  };
  EXPECT_LT(yield(0.1), yield(1.0) - 1e6);
  EXPECT_LT(yield(1.0), yield(10.0) - 1e6);
  EXPECT_EQ(yield(1.0), fit_target(target, weighted({})).parameter("yield_stress").value);
}

TEST(GivenWeights, ThatLeaveATargetNoSampleRejectIt) {
  const FitResult result = fit_target(two_branches(), weighted({{0.0, 0.0}, {0.021, 1.0}}));
  EXPECT_EQ(result.status, FitStatus::Rejected);
  EXPECT_EQ(result.reason, "the given weight is 0 at every sample");
  EXPECT_EQ(result.evaluations(), 0U);
  EXPECT_EQ(fit_target(two_branches(), weighted({{0.0, 0.0}, {0.005, 1.0}})).status,
            FitStatus::Fitted);
}

TEST(GivenWeights, LeaveAParameterThatOnlyUnweightedSamplesShowUnidentified) {
  const FitResult result = fit_target(two_branches(), weighted({{0.001, 0.0}}));
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
  EXPECT_TRUE(result.parameter("youngs_modulus").identified);
  EXPECT_FALSE(result.parameter("yield_stress").identified);
}

TEST(GivenWeights, BoundTheSearchByTheStressesThatCount) {
  const ParameterSet all(two_branches(), weighted({}));
  const ParameterSet part(two_branches(), weighted({{0.01, 0.0}}));
  EXPECT_DOUBLE_EQ(all.all()[1].search_upper, 400e6);
  EXPECT_DOUBLE_EQ(part.all()[1].search_upper, 300e6);
}

TEST(GivenWeights, ThatBreakARuleAreRefused) {
  const auto refusal = [](std::vector<WeightStep> weights) {
    return message_of([&] { fit_target(two_branches(), weighted(weights)); });
  };
  EXPECT_EQ(refusal({{-0.1, 1.0}}), "fit.weights[1].from = -0.1: must be at least 0");
  EXPECT_EQ(refusal({{0.0, 1.0}, {NAN, 1.0}}), "fit.weights[2].from = nan: must be at least 0");
  EXPECT_EQ(refusal({{0.0, -1.0}}), "fit.weights[1].weight = -1: must be at least 0");
  EXPECT_EQ(refusal({{0.0, INFINITY}}), "fit.weights[1].weight = inf: must be finite");
  EXPECT_EQ(refusal({{0.1, 1.0}, {0.1, 2.0}}),
            "fit.weights[2].from = 0.1: must be above that of the step before");
  FitOptions options = weighted({{0.0, 1.0}});
  options.objective = Objective::Path;
  EXPECT_EQ(message_of([&] { fit_target(two_branches(), options); }),
            "fit.weights: go with the objective least squares alone");
}

}  // namespace
}  // namespace plastica::calibrate
