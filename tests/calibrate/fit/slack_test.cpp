#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "calibrate/fit/fit.hpp"
#include "calibrate/target/make.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/has.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

constexpr double kSlope = 200e9, kPlateau = 300e6;

/// A tension test of ideal plasticity whose grips take up strain before, and while they bed in.
/// @param slack  strain without load [1]
/// @param foot   strain that is added while the first 40 MPa build up [1]
Curve gripped(double slack, double foot, double noise = 0.0) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Curve curve;
  const auto add = [&](double strain, double stress) {
    curve.strain.push_back(strain);
    curve.stress.push_back(stress + noise * normal(random));
  };
  for (double strain = 0.0; strain < slack - 2.5e-5; strain += 5e-5) add(strain, 0.0);
  for (int i = 0; i <= 400; ++i) {
    const double strain = 5e-5 * i;
    const double stress = std::min(kSlope * strain, kPlateau);
    add(slack + strain + foot * (1.0 - std::exp(-stress / 8e6)), stress);
  }
  return curve;
}

FitResult fitted(const Curve& curve) {
  return fit_target(make_target("gripped", curve),
                    fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")}));
}

TEST(Slack, BeforeTheLoadDoesNotMoveTheModulus) {
  for (const double noise : {0.0, 1e6}) {
    const double alone = fitted(gripped(0.0, 0.0, noise)).parameter("youngs_modulus").value;
    // Up to more than three times the yield strain.
    for (const double slack : {2e-4, 5e-4, 1e-3, 2e-3, 5e-3}) {
      const FitResult result = fitted(gripped(slack, 0.0, noise));
      ASSERT_EQ(result.status, FitStatus::Fitted) << slack << ' ' << result.reason;
      const double error = noise > 0.0 ? 0.02 : 1e-3;
      EXPECT_NEAR(result.parameter("youngs_modulus").value / alone, 1.0, error) << slack;
      EXPECT_NEAR(result.parameter("yield_stress").value / kPlateau, 1.0, 2e-3) << slack;
      EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
    }
  }
}

// Of a yield strain of 0.15 %.
TEST(Slack, LongerThanTheElasticRangeIsWarnedOf) {
  const auto warned = [](double slack) {
    const Target target = make_target("gripped", gripped(slack, 0.0));
    return std::ranges::any_of(target.warnings, [](const std::string& text) {
      return has(text, "is longer than the elastic range");
    });
  };
  EXPECT_TRUE(warned(2e-3));
  EXPECT_FALSE(warned(1e-3));
}

TEST(Slack, IsSaidWithTheSamplesThatItCosts) {
  const Target target = make_target("gripped", gripped(1e-3, 0.0));
  const auto toe = std::ranges::find(target.corrections, "toe", &Correction::kind);
  ASSERT_NE(toe, target.corrections.end());
  EXPECT_TRUE(toe->applied);
  EXPECT_TRUE(has(toe->text, " samples before it dropped")) << toe->text;
  EXPECT_GE(target.corrected.strain.front(), 0.0);
  EXPECT_NEAR(static_cast<double>(target.raw.size() - target.corrected.size()), 20.0, 1.0);
}

TEST(Slack, OfGripsThatBedInMovesTheModulusLittle) {
  for (const double foot : {2e-4, 6e-4, 1e-3}) {
    const FitResult result = fitted(gripped(0.0, foot));
    ASSERT_EQ(result.status, FitStatus::Fitted);
    EXPECT_NEAR(result.parameter("youngs_modulus").value / kSlope, 1.0, 0.02) << foot;
  }
}

TEST(Slack, IsNoWordForACurveThatBendsAllTheWay) {
  // A rubber-like curve: nowhere a line through the origin, and load from the first sample on.
  Curve curve;
  for (int i = 0; i <= 200; ++i) {
    const double strain = 5e-3 * i;
    curve.strain.push_back(strain);
    curve.stress.push_back(1e6 * (strain + 30.0 * std::pow(strain, 4)));
  }
  const Target target = make_target("rubber", curve);
  const auto toe = std::ranges::find(target.corrections, "toe", &Correction::kind);
  ASSERT_NE(toe, target.corrections.end());
  EXPECT_FALSE(toe->applied) << toe->amount;
  ASSERT_FALSE(target.warnings.empty());
  EXPECT_TRUE(has(target.warnings.front(), "beyond the yield strain")) << target.warnings.front();
}

}  // namespace
}  // namespace plastica::calibrate
