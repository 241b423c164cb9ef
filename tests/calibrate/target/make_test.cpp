#include "calibrate/target/make.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "plastica/base/check.hpp"
#include "tests/calibrate/target/curves.hpp"

namespace plastica::calibrate {
namespace {

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
  EXPECT_FALSE(target.characteristics.rp02.has_value());
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

}  // namespace
}  // namespace plastica::calibrate
