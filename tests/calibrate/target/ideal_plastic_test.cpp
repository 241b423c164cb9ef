#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "calibrate/target/make.hpp"
#include "tests/calibrate/target/curves.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::IdealPlastic;

/// Random tests of each kind.
constexpr unsigned kTests = plastica::testing::kSanitized ? 50 : 500;

/// The k-th random test: properties log-uniform over the ranges that the automatic rules promise.
IdealPlastic random_test(unsigned k, double noise) {
  std::mt19937_64 random(1000 + k);
  const auto log_uniform = [&](double low, double high) {
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
  };
  IdealPlastic test;
  test.modulus = log_uniform(1e9, 400e9);
  test.yield_stress = log_uniform(1e6, 3e9);
  test.permanent_break = log_uniform(1e-3, 0.5);
  test.elastic = static_cast<std::size_t>(log_uniform(5.0, 200.0));
  test.plateau = static_cast<std::size_t>(log_uniform(5.0, 400.0));
  test.broken = 1 + k % 3;
  test.noise = noise;
  return test;
}

void expect_undisturbed(const IdealPlastic& test, unsigned k) {
  const Target target = make_target("ideal", test.curve(k), plastica::testing::any_numbers());
  ASSERT_EQ(target.status, TargetStatus::Ready) << k << ": " << target.reason;
  EXPECT_EQ(target.loading, Loading::Monotonic) << k;
  EXPECT_TRUE(target.repairs.empty()) << k;
  ASSERT_EQ(target.corrected.size(), test.intact()) << k;
  for (std::size_t i = 0; i < test.intact(); ++i) {
    ASSERT_EQ(target.corrected.strain[i], target.raw.strain[i]) << k;
    ASSERT_EQ(target.corrected.stress[i], target.raw.stress[i]) << k;
  }
  ASSERT_TRUE(target.characteristics.observed_break.has_value()) << k;
  const BreakObservation& observed = *target.characteristics.observed_break;
  EXPECT_EQ(observed.last_intact_strain, target.raw.strain[test.intact() - 1]) << k;
  EXPECT_EQ(observed.first_broken_strain, target.raw.strain[test.intact()]) << k;
  EXPECT_FALSE(target.characteristics.reh.has_value()) << k;
}

TEST(IdealPlasticCurve, PassesEveryAutomaticRuleUndisturbed) {
  for (unsigned k = 0; k < kTests; ++k) {
    const IdealPlastic test = random_test(k, 0.0);
    expect_undisturbed(test, k);
    const Characteristics c =
        make_target("ideal", test.curve(k), plastica::testing::any_numbers()).characteristics;
    EXPECT_NEAR(c.youngs_modulus.value_or(0.0) / test.modulus, 1.0, 1e-9) << k;
    EXPECT_NEAR(c.rm.value_or(0.0) / test.yield_stress, 1.0, 1e-12) << k;
    if (c.proof_stress) {
      EXPECT_NEAR(*c.proof_stress / test.yield_stress, 1.0, 1e-9) << k;
    }
    EXPECT_NEAR(c.break_strain_plastic.value_or(0.0), test.permanent_break,
                c.observed_break->half_interval() + 1e-12)
        << k;
  }
}

TEST(IdealPlasticCurve, WithOnePercentNoisePassesEveryAutomaticRuleUndisturbed) {
  for (unsigned k = 0; k < kTests; ++k) {
    const IdealPlastic test = random_test(k, 0.01);
    expect_undisturbed(test, k);
    const Characteristics c =
        make_target("ideal", test.curve(k), plastica::testing::any_numbers()).characteristics;
    EXPECT_NEAR(c.youngs_modulus.value_or(0.0) / test.modulus, 1.0, 0.15) << k;
    EXPECT_NEAR(c.rm.value_or(0.0) / test.yield_stress, 1.0, 0.05) << k;
  }
}

TEST(IdealPlasticCurve, EvenlySpacedOverallPassesUndisturbed) {
  int tried = 0;
  for (unsigned k = 0; tried < 200; ++k) {
    std::mt19937_64 random(77 + k);
    IdealPlastic test = random_test(k, k % 2 == 0 ? 0.0 : 0.01);
    const double shorter = std::min(test.yield_strain(), test.permanent_break);
    const double step = shorter / std::uniform_real_distribution<double>(5.5, 30.0)(random);
    const double total = test.yield_strain() + test.permanent_break;
    if (total / step > 3000.0) continue;
    ++tried;
    std::normal_distribution<double> normal(0.0, 1.0);
    Curve curve;
    std::size_t intact = 0;
    for (double strain = 0.0; strain < total + 2.0 * step; strain += step) {
      const bool is_intact = strain <= total;
      intact += is_intact ? 1 : 0;
      const double stress = is_intact ? std::min(test.modulus * strain, test.yield_stress) : 0.0;
      curve.strain.push_back(strain);
      curve.stress.push_back(stress + test.noise * test.yield_stress * normal(random));
    }
    const Target target = make_target("even", curve, plastica::testing::any_numbers());
    EXPECT_EQ(target.status, TargetStatus::Ready) << k << ": " << target.reason;
    ASSERT_EQ(target.corrected.size(), intact) << k;
    EXPECT_EQ(target.corrected.strain.front(), 0.0) << k;
    EXPECT_EQ(target.corrected.strain.back(), curve.strain[intact - 1]) << k;
  }
}

TEST(IdealPlasticCurve, IsCalledTooCoarseWithTheCountsThatItHas) {
  IdealPlastic test;
  test.elastic = 2;
  const Target few_elastic = make_target("coarse", test.curve());
  EXPECT_EQ(few_elastic.status, TargetStatus::TooCoarse);
  EXPECT_NE(few_elastic.reason.find("elastic part"), std::string::npos) << few_elastic.reason;

  test.elastic = 3;  // samples at 0, 1/3, 2/3 and all of the yield strain
  const Target four = make_target("coarse", test.curve());
  EXPECT_EQ(four.status, TargetStatus::TooCoarse);
  EXPECT_NE(four.reason.find("4 samples on the elastic part"), std::string::npos) << four.reason;

  test.elastic = 40;
  test.plateau = 3;  // and the sample at the yield strain itself
  const Target few_plateau = make_target("coarse", test.curve());
  EXPECT_EQ(few_plateau.status, TargetStatus::TooCoarse);
  EXPECT_NE(few_plateau.reason.find("4 on the plateau"), std::string::npos) << few_plateau.reason;

  TargetOptions options;
  options.min_samples = 4;
  EXPECT_EQ(make_target("fine", test.curve(), options).status, TargetStatus::Ready);
}

}  // namespace
}  // namespace plastica::calibrate
