#include "calibrate/target/find_break.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "calibrate/target/make.hpp"
#include "tests/calibrate/target/curves.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::ending_with;
using plastica::testing::find_correction;
using plastica::testing::IdealPlastic;
using plastica::testing::smooth_curve;
using Mode = CorrectionChoice::Mode;

TEST(FindBreak, TrimsAtAnExplicitFallToZero) {
  const Target target = make_target("zero", ending_with({0.0}));
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  EXPECT_EQ(target.characteristics.observed_break->rule, "fall-to-zero");
  EXPECT_EQ(target.corrected.size(), 500U);
  EXPECT_EQ(find_correction(target, "trim-at-break").amount, 1.0);
}

TEST(FindBreak, TrimsAtASteepDropOfTheLoadThatDecaysOverManySamples) {
  const Target target = make_target("decay", ending_with({0.97, 0.9, 0.7, 0.4, 0.3, 0.2, 0.15}));
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  const BreakObservation& observed = *target.characteristics.observed_break;
  EXPECT_EQ(observed.rule, "load-drop");
  EXPECT_EQ(target.corrected.size(), 502U);  // 0.97 and 0.9 still carry load
  EXPECT_NEAR(observed.first_broken_strain - observed.last_intact_strain, 1e-7, 1e-12);
}

TEST(FindBreak, TakesSlowSofteningForANeckNotForABreak) {
  const Target target = make_target("neck", ending_with({0.99, 0.97, 0.95, 0.93, 0.91}, 0.005));
  EXPECT_FALSE(target.characteristics.observed_break.has_value());
  EXPECT_EQ(target.corrected.size(), 505U);
}

TEST(FindBreak, TakesTheEndOfTheDataForTheBreakOfANeckedSpecimen) {
  const Target target = make_target("end", ending_with({0.97, 0.92, 0.86}, 0.005));
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  const BreakObservation& observed = *target.characteristics.observed_break;
  EXPECT_EQ(observed.rule, "end-of-data");
  EXPECT_EQ(target.corrected.size(), 503U);
  EXPECT_NEAR(observed.half_interval(), 0.0025, 1e-12);
}

TEST(FindBreak, DoesNotTakeTheEndOfAYieldPlateauForABreak) {
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

TEST(FindBreak, TakesADropForABreakOnlyIfTheLoadStaysDown) {
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

TEST(FindBreak, TheBreakComesNoEarlierThanTheLargestWholeStrain) {
  Curve curve = ending_with({0.0});
  curve.strain[499] = curve.strain[498] - 8e-6;  // within the tolerance
  curve.strain[500] = curve.strain[498] - 9e-6;
  const Target target = make_target("back", curve);
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  const double beyond =
      target.characteristics.observed_break->first_broken_strain - curve.strain[498];
  EXPECT_GT(beyond, 0.0);
  EXPECT_LE(beyond, curve.strain[498] - curve.strain[497]);
  EXPECT_GE(*target.characteristics.break_strain, target.characteristics.largest_strain);
}

/// A strain that falls back as the specimen springs back, or stands still, says nothing of how far
/// it went: to the next sample at most.
TEST(FindBreak, ABreakAtWhichTheStrainFallsBackLiesWithinAStep) {
  const auto broken = [](double back, std::size_t after) {
    Curve curve = smooth_curve(101);  // 1e-3 each
    for (std::size_t i = 0; i < after; ++i) {
      curve.strain.push_back(0.1 - back);
      curve.stress.push_back(0.0);
    }
    return *make_target("back", curve).characteristics.observed_break;
  };
  for (const double back : {0.05, 6e-3, 1e-4, 0.0, -1e-6, -7e-4}) {
    for (const std::size_t after : {1U, 3U}) {
      const BreakObservation found = broken(back, after);
      EXPECT_EQ(found.last_intact_strain, 0.1) << back;
      EXPECT_NEAR(found.first_broken_strain, 0.101, 1e-12) << back;
    }
  }
  EXPECT_NEAR(broken(-9.5e-4, 1).first_broken_strain, 0.10095, 1e-12);
  EXPECT_NEAR(broken(-3e-3, 1).first_broken_strain, 0.103, 1e-12);
}

/// A cyclic test breaks on its way down as on its way up.
TEST(FindBreak, IsAlikeOnBothStrokesOfACycle) {
  for (const double onwards : {1.0, 0.0, -3.0}) {
    std::vector<BreakObservation> found;
    for (const double sign : {1.0, -1.0}) {
      Curve curve;
      double stress = 0.0;
      const auto go_to = [&](double end) {
        const double begin = curve.strain.empty() ? 0.0 : curve.strain.back();
        for (int i = 1; i <= 40; ++i) {
          const double strain = begin + (end - begin) * i / 40.0;
          const double before = curve.strain.empty() ? 0.0 : curve.strain.back();
          stress = std::clamp(stress + 200e9 * (strain - before), -300e6, 300e6);
          curve.strain.push_back(strain);
          curve.stress.push_back(stress);
        }
      };
      for (const double end : {0.01, -0.01, 0.02}) go_to(sign * end);
      curve.strain.push_back(sign * (0.02 + onwards * 7.5e-4));
      curve.stress.push_back(0.0);
      TargetOptions options;
      options.loading = Loading::Cyclic;
      found.push_back(*make_target("cycle", curve, options).characteristics.observed_break);
    }
    EXPECT_NEAR(found[0].last_intact_strain, 0.02, 1e-15);
    EXPECT_NEAR(found[0].first_broken_strain, 0.02075, 1e-12) << onwards;
    EXPECT_NEAR(found[1].last_intact_strain, -found[0].last_intact_strain, 1e-15);
    EXPECT_NEAR(found[1].first_broken_strain, -found[0].first_broken_strain, 1e-15) << onwards;
    EXPECT_NEAR(found[1].half_interval(), found[0].half_interval(), 1e-15);
  }
}

TEST(FindBreak, DoesNotTakeTheEndOfTheStrainForABreakWhenTheLoadGoesOn) {
  Curve curve = ending_with({0.97, 0.92, 0.86, 0.5}, 0.005);
  curve.strain.back() = std::numeric_limits<double>::quiet_NaN();
  const Target target = make_target("removed", curve);
  EXPECT_FALSE(target.characteristics.observed_break.has_value());
  EXPECT_EQ(find_correction(target, "trim-at-break").text, "the strain ends before the break");
}

TEST(FindBreak, TrimCanBeSwitchedOffOrSet) {
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

TEST(FindBreak, CutsACyclicCurveOnlyAtAFinalFallToZero) {
  TargetOptions options;
  options.loading = Loading::Cyclic;
  EXPECT_EQ(make_target("zero", ending_with({0.0}), options).corrected.size(), 500U);
  EXPECT_EQ(make_target("near", ending_with({0.02}), options).corrected.size(), 500U);
  EXPECT_EQ(make_target("low", ending_with({0.1}), options).corrected.size(), 501U);
}

TEST(FindBreak, SeesTheBreakOfACyclicCurveThatIsRecordedOnAfterIt) {
  TargetOptions options;
  options.loading = Loading::Cyclic;
  for (const Curve& curve : {ending_with({0.0, 0.0}), ending_with({0.0, 0.01, -0.01, 0.0})}) {
    const Target target = make_target("zeros", curve, options);
    EXPECT_EQ(target.corrected.size(), 500U);
    EXPECT_TRUE(target.characteristics.observed_break.has_value());
  }
}

TEST(FindBreak, FindsTheBreakOfANoisyPlateauToTheSample) {
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
TEST(FindBreak, TakesTheEndForTheBreakWhereTheUserSaysSo) {
  const Curve curve = plastica::testing::smooth_curve();
  EXPECT_FALSE(make_target("ends", curve).characteristics.break_strain.has_value());
  TargetOptions options;
  options.end_fraction = 1.0;
  const Target target = make_target("broke", curve, options);
  ASSERT_TRUE(target.characteristics.observed_break.has_value());
  EXPECT_EQ(target.characteristics.observed_break->rule, "end-of-data");
  EXPECT_EQ(target.characteristics.observed_break->last_intact_strain, curve.strain.back());
}

}  // namespace
}  // namespace plastica::calibrate
