#include "calibrate/target/correct.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "calibrate/target/make.hpp"
#include "tests/calibrate/target/curves.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::ending_with;
using plastica::testing::find_correction;
using plastica::testing::smooth_curve;
using plastica::testing::warns_that;
using Mode = CorrectionChoice::Mode;

Curve shifted(double amount) {
  Curve curve = smooth_curve(2000);
  for (double& strain : curve.strain) strain += amount;
  return curve;
}

/// A soft foot: the strain runs ahead by up to `amount` within the first 50 MPa.
Curve with_foot(double amount) {
  Curve curve = smooth_curve(2000);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    curve.strain[i] += amount * (1.0 - std::exp(-curve.stress[i] / 8e6));
  }
  return curve;
}

TEST(Correction, ShiftsAFootAway) {
  const Target target = make_target("foot", with_foot(4e-4));
  EXPECT_TRUE(find_correction(target, "toe").applied);
  EXPECT_FALSE(find_correction(target, "preload-offset").applied);
  EXPECT_NEAR(find_correction(target, "toe").amount, 4e-4, 2e-5);
  EXPECT_NEAR(target.corrected.strain.back(), target.raw.strain.back() - 4e-4, 2e-5);
}

TEST(Correction, ShiftsAnOffsetOfTheExtensometerAway) {
  const Target target = make_target("offset", shifted(6e-4));
  EXPECT_TRUE(find_correction(target, "preload-offset").applied);
  EXPECT_FALSE(find_correction(target, "toe").applied);
  EXPECT_NEAR(find_correction(target, "preload-offset").amount, 6e-4, 1e-6);
  EXPECT_NEAR(target.corrected.strain.front(), 0.0, 1e-6);
}

TEST(Correction, LeavesAShiftBelowTheThreshold) {
  // Threshold: 1 % of about 300 MPa / 70 GPa.
  const Target below = make_target("below", shifted(3e-5));
  EXPECT_FALSE(find_correction(below, "preload-offset").applied);
  EXPECT_FALSE(find_correction(below, "preload-offset").text.empty());
  EXPECT_EQ(below.corrected.strain, below.raw.strain);
  EXPECT_TRUE(find_correction(make_target("above", shifted(6e-5)), "preload-offset").applied);
}

TEST(Correction, DoesNotTakeOffAToeWhereTheModulusIsGiven) {
  TargetOptions options;
  options.youngs_modulus = 70e9;
  const Target target = make_target("given", with_foot(4e-4), options);
  EXPECT_FALSE(find_correction(target, "toe").applied);
  EXPECT_FALSE(find_correction(target, "toe").text.empty());
  EXPECT_EQ(target.corrected.strain, target.raw.strain);
}

TEST(Correction, ZeroesAGrossOffsetWhereTheModulusIsGiven) {
  TargetOptions options;
  options.youngs_modulus = 70e9;
  // Threshold: 10 % of about 300 MPa / 70 GPa.
  const Target gross = make_target("gross", shifted(1e-3), options);
  EXPECT_TRUE(find_correction(gross, "preload-offset").applied);
  EXPECT_NEAR(find_correction(gross, "preload-offset").amount, 1e-3, 1e-5);
  const Target small = make_target("small", shifted(2e-4), options);
  EXPECT_FALSE(find_correction(small, "preload-offset").applied);
  EXPECT_EQ(small.corrected.strain, small.raw.strain);
}

/// Grips that were slack, and a modulus that the user knows.
TEST(Correction, TakesOffSlackWhereTheModulusIsGiven) {
  TargetOptions options;
  options.youngs_modulus = 70e9;
  for (const double slack : {1e-3, 5e-3, 2e-2}) {
    Curve curve;
    for (int i = 0; i < 60; ++i) {
      curve.strain.push_back(slack * i / 60.0);
      curve.stress.push_back(0.1e6);
    }
    const Curve smooth = plastica::testing::smooth_curve();
    for (std::size_t i = 0; i < smooth.size(); ++i) {
      curve.strain.push_back(slack + smooth.strain[i]);
      curve.stress.push_back(smooth.stress[i]);
    }
    const Target target = make_target("slack", curve, options);
    EXPECT_TRUE(find_correction(target, "toe").applied) << slack;
    EXPECT_NEAR(find_correction(target, "toe").amount, slack, 2e-5);
    const Target plain = make_target("plain", smooth, options);
    EXPECT_NEAR(*target.characteristics.proof_stress / *plain.characteristics.proof_stress, 1.0,
                1e-3);
    // Of another slope than the given one nothing is known of its zero.
    TargetOptions other = options;
    other.youngs_modulus = 100e9;
    EXPECT_FALSE(find_correction(make_target("other", curve, other), "toe").applied);
  }
}

TEST(Correction, DoesNotShiftACyclicCurve) {
  TargetOptions options;
  options.loading = Loading::Cyclic;
  const Target target = make_target("cyclic", shifted(6e-4), options);
  EXPECT_EQ(target.corrected.strain, target.raw.strain);
}

TEST(Correction, CanBeSwitchedOffOrSet) {
  TargetOptions options;
  options.toe.mode = Mode::Off;
  const Target off = make_target("off", with_foot(4e-4), options);
  EXPECT_FALSE(find_correction(off, "toe").applied);
  EXPECT_EQ(find_correction(off, "toe").text, "off");
  EXPECT_EQ(off.corrected.strain, off.raw.strain);
  options.toe = {Mode::Set, 1e-3};
  const Target set = make_target("set", with_foot(4e-4), options);
  EXPECT_TRUE(find_correction(set, "toe").applied);
  EXPECT_EQ(find_correction(set, "toe").amount, 1e-3);
  EXPECT_EQ(set.corrected.strain.back(), set.raw.strain.back() - 1e-3);
}

TEST(Correction, ConvertsToTrueUpToRmAndRefusesTheNeck) {
  TargetOptions options;
  options.convert_to_true = true;
  const Curve curve = ending_with({0.99, 0.97}, 0.005);
  const Target target = make_target("true", curve, options);
  EXPECT_EQ(target.measure, Measure::True);
  ASSERT_EQ(target.corrected.size(), 500U);
  EXPECT_NEAR(target.corrected.strain.back(), std::log(1.1), 1e-12);
  EXPECT_NEAR(target.corrected.stress.back(), curve.stress[499] * 1.1, 1.0);
  ASSERT_FALSE(target.warnings.empty());
  EXPECT_NE(target.warnings[0].find("2 samples"), std::string::npos);
  options.force_true = true;
  EXPECT_EQ(make_target("forced", curve, options).corrected.size(), 502U);
}

// A bar that is pressed to 10 % less length thickens: 0.9 of the engineering stress is true.
TEST(Correction, ConvertsCompressionByTheStrainAsItWas) {
  TargetOptions options;
  options.convert_to_true = options.is_compressed = true;
  const Curve curve = ending_with({}, 0.005);
  const Target target = make_target("pressed", curve, options);
  ASSERT_EQ(target.corrected.size(), 500U);
  EXPECT_NEAR(target.corrected.strain.back(), -std::log(0.9), 1e-12);
  EXPECT_NEAR(target.corrected.stress.back(), curve.stress[499] * 0.9, 1.0);
}

TEST(Correction, RefusesToConvertATorsionCurve) {
  TargetOptions options;
  options.convert_to_true = true;
  options.test = calibrate::Test::Torsion;
  EXPECT_EQ(make_target("torsion", smooth_curve(), options).status, TargetStatus::Rejected);
}

/// Stress of a stretched rubber over its strain, which breaks between its last two samples.
template <typename Stress>
Curve rubber(double end, const Stress& stress) {
  Curve curve;
  for (int i = 0; i <= 800; ++i) {
    const double strain = end * i / 800.0;
    curve.strain.push_back(strain);
    curve.stress.push_back(stress(1.0 + strain));
  }
  curve.strain.push_back(1.002 * end);
  curve.stress.push_back(0.0);
  return curve;
}

/// Neo-Hooke's rubber begins three times as steep as it goes on: no foot can be so, and its strain
/// at break stays. With some noise, without which the line is found at the very beginning.
TEST(Correction, DoesNotTakeAConcaveCurveForAFoot) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 1.5e3);
  for (const double end : {0.5, 1.0, 2.0, 4.0, 6.0}) {
    const auto neo_hooke = [&](double stretch) {
      return 0.5e6 * (stretch - 1.0 / (stretch * stretch)) + noise(random);
    };
    const Target target = make_target("rubber", rubber(end, neo_hooke));
    EXPECT_FALSE(find_correction(target, "toe").applied) << end;
    ASSERT_TRUE(target.characteristics.break_strain) << end;
    EXPECT_NEAR(*target.characteristics.break_strain, 1.001 * end, 2e-3 * end) << end;
    EXPECT_TRUE(warns_that(target, "the curve begins steeper") ||
                warns_that(target, "the curve bends"))
        << end;
  }
}

/// A strain that stuck at first lies beyond the line, too, behind which the curve is straight.
TEST(Correction, ShiftsACurveWhoseStrainStuckAtFirst) {
  Curve curve;
  for (int i = 0; i <= 600; ++i) {
    const double true_strain = 1e-5 * i;
    curve.strain.push_back(std::max(0.0, true_strain - 5e-4 * (1.0 - std::exp(-i / 20.0))));
    curve.stress.push_back(std::min(69e9 * true_strain, 250e6 + 1e9 * true_strain));
  }
  const Target target = make_target("stuck", curve);
  EXPECT_TRUE(find_correction(target, "toe").applied);
  EXPECT_NEAR(find_correction(target, "toe").amount, -5e-4, 0.3e-4);
}

/// A steel whose slope rises as E (1 - exp(-strain/foot)) and whose foot ends within the window.
TEST(Correction, WarnsWhereAFootReachesIntoTheWindowOfTheModulus) {
  const auto warns = [](double foot) {
    Curve curve;
    for (int i = 0; i <= 600; ++i) {
      const double strain = 1e-5 * i;
      const double rises = strain - foot * (1.0 - std::exp(-strain / foot));
      curve.strain.push_back(strain);
      curve.stress.push_back(std::min(205e9 * rises, 350e6 + 1e9 * strain));
    }
    return warns_that(make_target("foot", curve), "the curve grows steeper");
  };
  EXPECT_TRUE(warns(5e-4));
  EXPECT_TRUE(warns(4e-4));
  EXPECT_FALSE(warns(5e-5));
}

}  // namespace
}  // namespace plastica::calibrate
