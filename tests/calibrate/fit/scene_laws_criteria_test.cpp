#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/fit/scene_laws.hpp"
#include "calibrate/inference/bootstrap.hpp"
#include "calibrate/report/law_choice.hpp"
#include "tests/calibrate/fit/bilinear_coupon.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/tolerance.hpp"

/// What laws are compared by, the same by both roads: of a specimen's curve, and of the same curve
/// through the scene of its coupon.
namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

/// Noisy, unequally spaced, and bent over a second time, so that no law follows it all.
SceneTarget curve() {
  Draws draws(5, 0);
  SceneTarget target = bilinear_target("curve", std::vector<double>(121));
  for (std::size_t i = 0; i < target.abscissa.size(); ++i) {
    const double strain = std::pow(static_cast<double>(i) / 120.0, 1.5);
    target.abscissa[i] = strain;
    const double more = std::max(0.0, strain - 0.5);
    target.ordinate[i] = bilinear_stress(Bilinear{}, strain) + 0.05 * more + 0.002 * draws.normal();
  }
  return target;
}

const std::vector<Law> kLaws = {Law::Ideal, Law::Linear};

struct Asked {
  Objective objective = Objective::LeastSquares;
  std::optional<Prior> prior;  ///< of Young's modulus
  std::optional<Parameter> more;
};

std::vector<Parameter> parameters(const Asked& asked) {
  std::vector<Parameter> all = {bounded("youngs_modulus", 0.5, 4.5),
                                bounded("yield_stress", 0.05, 0.45)};
  all[0].prior = asked.prior;
  if (asked.more) all.push_back(*asked.more);
  return all;
}

/// By their laws.
std::vector<ComparedLaw> by_laws(LawComparison comparison) {
  std::ranges::sort(comparison.laws, {}, [](const ComparedLaw& law) { return law.fit.law; });
  return comparison.laws;
}

std::vector<SceneFitRecord> scene_records(const Asked& asked) {
  SceneFitOptions options;
  options.objective = asked.objective;
  options.parameters = parameters(asked);
  options.laws = kLaws;
  const std::vector<WeightedTarget> targets{{bilinear_coupon(), curve()}};
  std::vector<SceneFitRecord> records;
  for (const Law law : kLaws) {
    const SceneFitOptions own = options_of(law, options, targets);
    const std::vector<WeightedTarget> own_targets = targets_of(law, targets);
    SceneFitResult result = fit(own_targets, own);
    result.law = law;
    records.push_back(record_of({"curve", own_targets}, std::move(result)));
  }
  return records;
}

std::vector<ComparedLaw> through_the_scene(const Asked& asked) {
  const std::vector<SceneFitRecord> records = scene_records(asked);
  return by_laws(compare_laws(std::span<const SceneFitRecord>(records)));
}

std::vector<ComparedLaw> of_the_curve(const Asked& asked) {
  FitOptions options;
  options.setup = bilinear_coupon();
  options.objective = asked.objective;
  options.parameters = parameters(asked);
  options.modulus_prior = false;
  options.laws = kLaws;
  const SceneTarget same = curve();
  const std::vector<Target> targets{target_of(same.abscissa, same.ordinate)};
  std::vector<FitRecord> records;
  for (FitResult& result : fit(targets, options)) {
    records.push_back({targets[0], std::move(result)});
  }
  return by_laws(compare_laws(std::span<const FitRecord>(records)));
}

void expect_alike(const Asked& asked, double within = 1e-3) {
  const std::vector<ComparedLaw> here = of_the_curve(asked);
  const std::vector<ComparedLaw> there = through_the_scene(asked);
  ASSERT_EQ(here.size(), 2U);
  ASSERT_EQ(there.size(), 2U);
  const double gap = here[0].bic - here[1].bic;
  EXPECT_GT(std::fabs(gap), 10.0);
  EXPECT_NEAR(there[0].bic - there[1].bic, gap, tolerance(within * std::fabs(gap)));
  EXPECT_NEAR(there[0].aic - there[1].aic, here[0].aic - here[1].aic,
              tolerance(within * std::fabs(gap)));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(there[k].held_out, here[k].held_out, tolerance(within * here[k].held_out)) << k;
    EXPECT_NEAR(there[k].fit.curves[0].samples, here[k].fit.curves[0].samples, 1e-9) << k;
  }
}

TEST(SceneLawsCriteria, AreThoseOfTheCurveBySamples) { expect_alike({}); }

TEST(SceneLawsCriteria, AreThoseOfTheCurveAlongThePath) { expect_alike({Objective::Path, {}, {}}); }

/// The ideal law leaves so much that a false prior has its way; the linear one stretches it. Priors
/// are weighed by the noise that is left without them there, with them here: a pull of one standard
/// deviation moves that of 121 samples by 0.8 %.
TEST(SceneLawsCriteria, CountWhatPriorsAreStretched) {
  const Asked asked{Objective::LeastSquares, Prior{1.53, 0.008}, {}};
  expect_alike(asked, 0.01);
  const std::vector<ComparedLaw> laws = through_the_scene(asked);
  EXPECT_GT(laws[1].fit.curves[0].prior, laws[0].fit.curves[0].prior + 0.5);
}

/// What one law searches may be tied, or not there, in another; a file has all of it.
TEST(SceneLawsCriteria, EachLawHasItsOwnHeldParameters) {
  Parameter tied = bounded("material.hardening.tangent_modulus", 0.0, 0.0);
  tied.lower.reset();
  tied.upper.reset();
  tied.role = ParameterRole::Tied;
  tied.tied_to = &find_field("material.youngs_modulus");
  tied.factor = 0.05;
  const std::vector<SceneFitRecord> records = scene_records({Objective::LeastSquares, {}, tied});
  EXPECT_EQ(records[0].result.find_parameter(tied.field->path), nullptr) << "the ideal law";
  const FittedParameter* held = records[1].result.find_parameter(tied.field->path);
  ASSERT_NE(held, nullptr);
  EXPECT_EQ(held->role, ParameterRole::Tied);
  EXPECT_EQ(held->value, 0.05 * records[1].result.parameter("youngs_modulus").value);
}

}  // namespace
}  // namespace plastica::calibrate
