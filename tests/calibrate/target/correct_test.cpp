#include "calibrate/target/correct.hpp"
#include "calibrate/target/find_break.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "calibrate/target/make.hpp"
#include "tests/calibrate/target/curves.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::IdealPlastic;
using plastica::testing::smooth_curve;
using plastica::testing::warns_that;
using Mode = CorrectionChoice::Mode;

const Correction& find(const Target& target, const std::string& kind) {
  for (const Correction& correction : target.corrections) {
    if (correction.kind == kind) return correction;
  }
  throw std::runtime_error("no correction " + kind);
}

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

/// A smooth curve that falls on from its largest stress along given fractions of it.
Curve ending_with(std::initializer_list<double> fractions, double step = 1e-7) {
  Curve curve = smooth_curve();
  const double rm = curve.stress.back();
  for (const double fraction : fractions) {
    curve.strain.push_back(curve.strain.back() + step);
    curve.stress.push_back(fraction * rm);
  }
  return curve;
}

TEST(Correction, ShiftsAFootAway) {
  const Target target = make_target("foot", with_foot(4e-4));
  EXPECT_TRUE(find(target, "toe").applied);
  EXPECT_FALSE(find(target, "preload-offset").applied);
  EXPECT_NEAR(find(target, "toe").amount, 4e-4, 2e-5);
  EXPECT_NEAR(target.corrected.strain.back(), target.raw.strain.back() - 4e-4, 2e-5);
}

TEST(Correction, ShiftsAnOffsetOfTheExtensometerAway) {
  const Target target = make_target("offset", shifted(6e-4));
  EXPECT_TRUE(find(target, "preload-offset").applied);
  EXPECT_FALSE(find(target, "toe").applied);
  EXPECT_NEAR(find(target, "preload-offset").amount, 6e-4, 1e-6);
  EXPECT_NEAR(target.corrected.strain.front(), 0.0, 1e-6);
}

TEST(Correction, LeavesAShiftBelowTheThreshold) {
  // Threshold: 1 % of about 300 MPa / 70 GPa.
  const Target below = make_target("below", shifted(3e-5));
  EXPECT_FALSE(find(below, "preload-offset").applied);
  EXPECT_FALSE(find(below, "preload-offset").text.empty());
  EXPECT_EQ(below.corrected.strain, below.raw.strain);
  EXPECT_TRUE(find(make_target("above", shifted(6e-5)), "preload-offset").applied);
}

TEST(Correction, DoesNotTakeOffAToeWhereTheModulusIsGiven) {
  TargetOptions options;
  options.youngs_modulus = 70e9;
  const Target target = make_target("given", with_foot(4e-4), options);
  EXPECT_FALSE(find(target, "toe").applied);
  EXPECT_FALSE(find(target, "toe").text.empty());
  EXPECT_EQ(target.corrected.strain, target.raw.strain);
}

TEST(Correction, ZeroesAGrossOffsetWhereTheModulusIsGiven) {
  TargetOptions options;
  options.youngs_modulus = 70e9;
  // Threshold: 10 % of about 300 MPa / 70 GPa.
  const Target gross = make_target("gross", shifted(1e-3), options);
  EXPECT_TRUE(find(gross, "preload-offset").applied);
  EXPECT_NEAR(find(gross, "preload-offset").amount, 1e-3, 1e-5);
  const Target small = make_target("small", shifted(2e-4), options);
  EXPECT_FALSE(find(small, "preload-offset").applied);
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
    EXPECT_TRUE(find(target, "toe").applied) << slack;
    EXPECT_NEAR(find(target, "toe").amount, slack, 2e-5);
    const Target plain = make_target("plain", smooth, options);
    EXPECT_NEAR(*target.characteristics.proof_stress / *plain.characteristics.proof_stress, 1.0,
                1e-3);
    // Of another slope than the given one nothing is known of its zero.
    TargetOptions other = options;
    other.youngs_modulus = 100e9;
    EXPECT_FALSE(find(make_target("other", curve, other), "toe").applied);
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
  EXPECT_FALSE(find(off, "toe").applied);
  EXPECT_EQ(find(off, "toe").text, "off");
  EXPECT_EQ(off.corrected.strain, off.raw.strain);
  options.toe = {Mode::Set, 1e-3};
  const Target set = make_target("set", with_foot(4e-4), options);
  EXPECT_TRUE(find(set, "toe").applied);
  EXPECT_EQ(find(set, "toe").amount, 1e-3);
  EXPECT_EQ(set.corrected.strain.back(), set.raw.strain.back() - 1e-3);
}

TEST(Correction, TrimsAtAnExplicitFallToZero) {
  const Target target = make_target("zero", ending_with({0.0}));
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  EXPECT_EQ(target.characteristics.observed_break->rule, "fall-to-zero");
  EXPECT_EQ(target.corrected.size(), 500U);
  EXPECT_EQ(find(target, "trim-at-break").amount, 1.0);
}

TEST(Correction, TrimsAtASteepDropOfTheLoadThatDecaysOverManySamples) {
  const Target target = make_target("decay", ending_with({0.97, 0.9, 0.7, 0.4, 0.3, 0.2, 0.15}));
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  const BreakObservation& observed = *target.characteristics.observed_break;
  EXPECT_EQ(observed.rule, "load-drop");
  EXPECT_EQ(target.corrected.size(), 502U);  // 0.97 and 0.9 still carry load
  EXPECT_NEAR(observed.first_broken_strain - observed.last_intact_strain, 1e-7, 1e-12);
}

TEST(Correction, TakesSlowSofteningForANeckNotForABreak) {
  const Target target = make_target("neck", ending_with({0.99, 0.97, 0.95, 0.93, 0.91}, 0.005));
  EXPECT_FALSE(target.characteristics.observed_break.has_value());
  EXPECT_EQ(target.corrected.size(), 505U);
}

TEST(Correction, TakesTheEndOfTheDataForTheBreakOfANeckedSpecimen) {
  const Target target = make_target("end", ending_with({0.97, 0.92, 0.86}, 0.005));
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  const BreakObservation& observed = *target.characteristics.observed_break;
  EXPECT_EQ(observed.rule, "end-of-data");
  EXPECT_EQ(target.corrected.size(), 503U);
  EXPECT_NEAR(observed.half_interval(), 0.0025, 1e-12);
}

TEST(Correction, DoesNotTakeTheEndOfAYieldPlateauForABreak) {
  Curve curve;
  for (int i = 0; i <= 200; ++i) {
    const double strain = 1e-4 * i;
    curve.strain.push_back(strain);
    curve.stress.push_back(strain <= 0.002 ? 200e9 * strain : 340e6);
  }
  const Target plateau = make_target("plateau", curve);
  EXPECT_FALSE(plateau.characteristics.observed_break.has_value());
  EXPECT_EQ(plateau.corrected.size(), 201U);
  // Hardened up to 380 MPa, below the upper yield point of 400 MPa, then necked.
  for (int i = 1; i <= 100; ++i) {
    curve.strain.push_back(0.02 + 1e-3 * i);
    curve.stress.push_back(340e6 + 0.4e6 * i);
  }
  Curve necked = curve;
  for (int i = 1; i <= 50; ++i) {
    necked.strain.push_back(0.12 + 1e-3 * i);
    necked.stress.push_back(380e6 - 0.5e6 * i);
  }
  EXPECT_FALSE(make_target("355 of 380", necked).characteristics.observed_break.has_value());
  for (int i = 1; i <= 50; ++i) {
    necked.strain.push_back(0.17 + 1e-3 * i);
    necked.stress.push_back(355e6 - 0.5e6 * i);
  }
  const auto broken = make_target("330 of 380", necked).characteristics.observed_break;
  ASSERT_TRUE(broken.has_value());
  EXPECT_EQ(broken->rule, "end-of-data");
}

TEST(Correction, TakesADropForABreakOnlyIfTheLoadStaysDown) {
  Curve curve = smooth_curve();
  for (std::size_t i = 250; i < 253; ++i) curve.stress[i] = 0.0;
  const Target dropped = make_target("dropped", curve);
  EXPECT_FALSE(dropped.characteristics.observed_break.has_value());
  EXPECT_EQ(dropped.corrected.size(), 500U);
  for (std::size_t i = 253; i < 500; ++i) curve.stress[i] = 0.5 * curve.stress[249];
  const Target broken = make_target("broken", curve);
  ASSERT_TRUE(broken.characteristics.observed_break.has_value());
  EXPECT_EQ(broken.corrected.size(), 250U);
}

TEST(Correction, TheBreakComesNoEarlierThanTheLargestWholeStrain) {
  Curve curve = ending_with({0.0});
  curve.strain[499] = curve.strain[498] - 8e-6;  // within the tolerance
  curve.strain[500] = curve.strain[498] - 9e-6;
  const Target target = make_target("back", curve);
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  EXPECT_EQ(target.characteristics.observed_break->first_broken_strain, curve.strain[498]);
  EXPECT_GE(*target.characteristics.break_strain, target.characteristics.largest_strain);
}

TEST(Correction, DoesNotTakeTheEndOfTheStrainForABreakWhenTheLoadGoesOn) {
  Curve curve = ending_with({0.97, 0.92, 0.86, 0.5}, 0.005);
  curve.strain.back() = std::numeric_limits<double>::quiet_NaN();
  const Target target = make_target("removed", curve);
  EXPECT_FALSE(target.characteristics.observed_break.has_value());
  EXPECT_EQ(find(target, "trim-at-break").text, "the strain ends before the break");
}

TEST(Correction, TrimCanBeSwitchedOffOrSet) {
  TargetOptions options;
  options.trim.mode = Mode::Off;
  const Target off = make_target("off", ending_with({0.0}), options);
  EXPECT_EQ(off.corrected.size(), 501U);
  EXPECT_FALSE(off.characteristics.observed_break.has_value());
  options.trim = {Mode::Set, 0.05};
  const Target set = make_target("set", ending_with({0.0}), options);
  EXPECT_EQ(set.corrected.size(), 250U);
  EXPECT_EQ(set.characteristics.observed_break->rule, "set");
}

TEST(Correction, CutsACyclicCurveOnlyAtAFinalFallToZero) {
  TargetOptions options;
  options.loading = Loading::Cyclic;
  EXPECT_EQ(make_target("zero", ending_with({0.0}), options).corrected.size(), 500U);
  EXPECT_EQ(make_target("near", ending_with({0.02}), options).corrected.size(), 500U);
  EXPECT_EQ(make_target("low", ending_with({0.1}), options).corrected.size(), 501U);
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

TEST(Correction, SeesTheBreakOfACyclicCurveThatIsRecordedOnAfterIt) {
  TargetOptions options;
  options.loading = Loading::Cyclic;
  for (const Curve& curve : {ending_with({0.0, 0.0}), ending_with({0.0, 0.01, -0.01, 0.0})}) {
    const Target target = make_target("zeros", curve, options);
    EXPECT_EQ(target.corrected.size(), 500U);
    EXPECT_TRUE(target.characteristics.observed_break.has_value());
  }
}

TEST(Correction, RefusesToConvertATorsionCurve) {
  TargetOptions options;
  options.convert_to_true = true;
  options.test = calibrate::Test::Torsion;
  EXPECT_EQ(make_target("torsion", smooth_curve(), options).status, TargetStatus::Rejected);
}

TEST(Correction, FindsTheBreakOfANoisyPlateauToTheSample) {
  IdealPlastic test;
  test.noise = 0.01;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Curve curve = test.curve(seed);
    const auto found = find_break(curve, Loading::Monotonic, test.modulus, false, {});
    ASSERT_TRUE(found.has_value()) << seed;
    EXPECT_EQ(found->intact, test.intact()) << seed;
  }
}

/// What the report proposes where a record ends under load.
TEST(Correction, TakesTheEndForTheBreakWhereTheUserSaysSo) {
  const Curve curve = plastica::testing::smooth_curve();
  EXPECT_FALSE(make_target("ends", curve).characteristics.break_strain.has_value());
  TargetOptions options;
  options.end_fraction = 1.0;
  const Target target = make_target("broke", curve, options);
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  EXPECT_EQ(target.characteristics.observed_break->rule, "end-of-data");
  EXPECT_EQ(target.characteristics.observed_break->last_intact_strain, curve.strain.back());
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
    EXPECT_FALSE(find(target, "toe").applied) << end;
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
  EXPECT_TRUE(find(target, "toe").applied);
  EXPECT_NEAR(find(target, "toe").amount, -5e-4, 0.3e-4);
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
