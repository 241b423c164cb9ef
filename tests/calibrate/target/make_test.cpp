#include "calibrate/target/make.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>

#include "plastica/base/check.hpp"
#include "tests/calibrate/target/curves.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::warns_that;

TEST(MakeTarget, RejectsACurveWithoutASampleAndSaysWhy) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Curve& curve : {Curve{}, Curve{{nan, 0.1}, {1.0, nan}}}) {
    const Target target = make_target("empty", curve);
    EXPECT_EQ(target.status, TargetStatus::Rejected);
    EXPECT_EQ(target.reason, "no row has both numbers");
  }
}

TEST(MakeTarget, RejectsACurveWithoutTension) {
  const Target target = make_target("compression", {{0.0, 0.1, 0.2}, {0.0, -1e6, -2e6}});
  EXPECT_EQ(target.status, TargetStatus::Rejected);
  EXPECT_EQ(target.reason, "the stress is nowhere positive");
}

TEST(MakeTarget, RejectsCompressionByItsName) {
  Curve curve = plastica::testing::smooth_curve();
  for (double& strain : curve.strain) strain = -strain;
  for (double& stress : curve.stress) stress = -stress;
  curve.stress[0] = 1e6;  // noise about zero
  const Target target = make_target("compression", curve);
  EXPECT_EQ(target.status, TargetStatus::Rejected);
  EXPECT_TRUE(target.reason.starts_with("compression: ")) << target.reason;
}

TEST(MakeTarget, DoesNotCallACurveWithoutARisingPartTooCoarse) {
  Curve falling;
  Curve backwards;
  for (int i = 0; i < 50; ++i) {
    falling.strain.push_back(1e-3 * i);
    falling.stress.push_back(300e6 - 2e6 * i);
    backwards.strain.push_back(-1e-4 * i);
    backwards.stress.push_back(5e6 * i);
  }
  for (const Curve& curve : {falling, backwards}) {
    const Target target = make_target("falls", curve);
    EXPECT_EQ(target.status, TargetStatus::Rejected);
    EXPECT_TRUE(target.reason.starts_with("no rising part: ")) << target.reason;
  }
}

TEST(MakeTarget, CallsAHandfulOfSamplesTooCoarse) {
  const Target target = make_target("two", {{0.0, 0.1}, {0.0, 1e6}});
  EXPECT_EQ(target.status, TargetStatus::TooCoarse);
  EXPECT_NE(target.reason.find("the curve has 2"), std::string::npos) << target.reason;
}

TEST(MakeTarget, WarnsOfACurveThatIsElasticToItsEndAndKeepsItReady) {
  Curve curve;
  for (int i = 0; i <= 50; ++i) {
    curve.strain.push_back(1e-4 * i);
    curve.stress.push_back(2e7 * i);
  }
  const Target target = make_target("elastic", curve);
  EXPECT_EQ(target.status, TargetStatus::Ready) << target.reason;
  ASSERT_EQ(target.warnings.size(), 1U);
  EXPECT_EQ(target.warnings[0], "elastic to its end: the yield stress is not identifiable");
  EXPECT_FALSE(target.characteristics.proof_stress.has_value());
  EXPECT_TRUE(make_target("smooth", plastica::testing::smooth_curve()).warnings.empty());
}

TEST(MakeTarget, RefusesColumnsOfUnequalLengthAndOptionsThatMakeNoSense) {
  EXPECT_THROW(make_target("unequal", {{0.0, 0.1}, {0.0}}), InputError);
  TargetOptions options;
  options.offset = 0.0;
  EXPECT_THROW(make_target("offset", plastica::testing::smooth_curve(), options), InputError);
  options = {};
  options.modulus_low = 0.7;
  EXPECT_THROW(make_target("window", plastica::testing::smooth_curve(), options), InputError);
}

TEST(MakeTarget, KeepsTheRawCurveAsItWas) {
  const Curve curve = plastica::testing::IdealPlastic{}.curve();
  const Target target = make_target("raw", curve);
  EXPECT_EQ(target.raw.strain, curve.strain);
  EXPECT_EQ(target.raw.stress, curve.stress);
  EXPECT_LT(target.corrected.size(), curve.size());
}

/// A hardening steel with some noise, that breaks to `zero`.
Curve noisy_curve(double zero = 0.0) {
  Curve curve = plastica::testing::smooth_curve(800);
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 0.5e6);
  for (double& stress : curve.stress) stress += noise(random) + zero;
  for (int i = 1; i <= 5; ++i) {
    curve.strain.push_back(0.1 + 1e-4 * i);
    curve.stress.push_back(zero + noise(random));
  }
  return curve;
}

TEST(MakeTarget, WarnsOfALoadCellAtItsLimit) {
  const std::string warning = "the stress stands at its largest value, ";
  Curve curve = noisy_curve();
  EXPECT_FALSE(warns_that(make_target("whole", curve), warning));
  for (double& stress : curve.stress) stress = std::min(stress, 320e6);
  const Target target = make_target("capped", curve);
  EXPECT_TRUE(warns_that(target, warning + "320 MPa, for "));
  EXPECT_FALSE(target.characteristics.reh.has_value()) << "its noise is no yield point";
  // A made curve without any noise has a right to its plateau.
  EXPECT_FALSE(
      warns_that(make_target("ideal", plastica::testing::IdealPlastic{}.curve()), warning));
}

TEST(MakeTarget, WarnsOfAGivenModulusThatIsNotTheCurves) {
  TargetOptions options;
  for (const double given : {20e9, 205e9}) {
    options.youngs_modulus = given;
    EXPECT_TRUE(warns_that(make_target("other", noisy_curve(), options), "the curve rises with "));
  }
  options.youngs_modulus = 72e9;
  EXPECT_FALSE(warns_that(make_target("near", noisy_curve(), options), "the curve rises with "));
}

TEST(MakeTarget, WarnsOfALoadCellThatIsNotZeroAfterTheBreak) {
  const std::string warning = "after the break the stress is ";
  EXPECT_TRUE(warns_that(make_target("plus", noisy_curve(30e6)), warning + "+3"));
  EXPECT_TRUE(warns_that(make_target("minus", noisy_curve(-30e6)), warning + "-"));
  EXPECT_FALSE(warns_that(make_target("zero", noisy_curve()), warning));
}

/// The machine stopped on the elastic part, and the load relaxed.
TEST(MakeTarget, TakesNoRelaxationForAYieldPoint) {
  const Curve whole = noisy_curve();
  Curve curve;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    curve.strain.push_back(whole.strain[i]);
    curve.stress.push_back(whole.stress[i]);
    if (i != 20) continue;  // 175 MPa
    for (int k = 1; k <= 20; ++k) {
      curve.strain.push_back(whole.strain[i] + 1e-8 * k);
      curve.stress.push_back(whole.stress[i] * (1.0 - 0.05 * k / 20.0));
    }
  }
  const Target target = make_target("pause", curve);
  EXPECT_FALSE(target.characteristics.reh.has_value());
  EXPECT_TRUE(warns_that(target, "the stress falls at 17"));
}

}  // namespace
}  // namespace plastica::calibrate
