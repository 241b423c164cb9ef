#include "calibrate/target/repair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "calibrate/target/make.hpp"
#include "tests/calibrate/target/curves.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::kSanitized;
using plastica::testing::smooth_curve;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::size_t count_of(const Target& target, const std::string& kind) {
  for (const Repair& repair : target.repairs) {
    if (repair.kind == kind) return repair.count;
  }
  return 0;
}

Curve settling_cycles(double peak_fraction) {
  const Curve smooth = smooth_curve();
  Curve curve;
  std::size_t top = 0;
  while (smooth.stress[top] < peak_fraction * 350e6) ++top;
  for (std::size_t i = 0; i <= top; ++i) {
    curve.strain.push_back(smooth.strain[i]);
    curve.stress.push_back(smooth.stress[i]);
  }
  for (std::size_t i = top; i-- > 0;) {
    curve.strain.push_back(smooth.strain[top] - smooth.stress[top] / 70e9 +
                           smooth.stress[i] / 70e9);
    curve.stress.push_back(smooth.stress[i]);
  }
  for (std::size_t i = 1; i < smooth.size(); ++i) {
    curve.strain.push_back(smooth.strain[i]);
    curve.stress.push_back(smooth.stress[i]);
  }
  return curve;
}

TEST(Repair, LeavesACleanCurveAlone) {
  const Curve clean = smooth_curve();
  const Target target = make_target("clean", clean);
  EXPECT_EQ(target.status, TargetStatus::Ready) << target.reason;
  EXPECT_TRUE(target.repairs.empty());
  EXPECT_EQ(target.corrected.strain, clean.strain);
  EXPECT_EQ(target.corrected.stress, clean.stress);
}

TEST(Repair, DropsAndCountsRowsWithoutNumbers) {
  Curve curve = smooth_curve();
  curve.strain[100] = kNan;
  curve.stress[200] = kNan;
  curve.stress[300] = std::numeric_limits<double>::infinity();
  const Target target = make_target("holes", curve);
  EXPECT_EQ(count_of(target, "nan-rows"), 3U);
  EXPECT_EQ(count_of(target, "extensometer-removed"), 0U);
  EXPECT_EQ(target.corrected.size(), 497U);
  EXPECT_EQ(target.raw.size(), 500U);
}

TEST(Repair, TakesRmFromTheRowsAfterTheExtensometerWasRemoved) {
  Curve curve = smooth_curve();
  const double rm = curve.stress.back();
  for (std::size_t i = 200; i < curve.size(); ++i) curve.strain[i] = kNan;
  const Target target = make_target("removed", curve);
  EXPECT_EQ(target.status, TargetStatus::Ready) << target.reason;
  EXPECT_EQ(count_of(target, "extensometer-removed"), 300U);
  EXPECT_EQ(count_of(target, "nan-rows"), 0U) << "reported once";
  EXPECT_EQ(target.characteristics.rm, rm);
  EXPECT_FALSE(target.characteristics.strain_at_rm.has_value());
  EXPECT_FALSE(target.characteristics.observed_break.has_value());
}

TEST(Repair, DropsSamplesEqualToTheOneBefore) {
  Curve curve = smooth_curve();
  curve.strain.insert(curve.strain.begin() + 50, curve.strain[50]);
  curve.stress.insert(curve.stress.begin() + 50, curve.stress[50]);
  const Target target = make_target("twins", curve);
  EXPECT_EQ(count_of(target, "duplicates"), 1U);
  EXPECT_EQ(target.corrected.size(), 500U);
}

TEST(Repair, DropsStrainThatRunsBackBeyondTheToleranceAndKeepsLess) {
  Curve curve = smooth_curve();
  curve.strain[300] = curve.strain[299] - 2e-5;
  EXPECT_EQ(count_of(make_target("beyond", curve), "strain-reversals"), 1U);
  curve.strain[300] = curve.strain[299] - 5e-6;
  EXPECT_EQ(count_of(make_target("within", curve), "strain-reversals"), 0U);
  TargetOptions options;
  options.reversal_tolerance = 1e-6;
  EXPECT_EQ(count_of(make_target("strict", curve, options), "strain-reversals"), 1U);
}

TEST(Repair, StartsAFootThatRanBackwardsAtItsLeastStrain) {
  Curve curve = smooth_curve(2000);
  for (double& strain : curve.strain) strain -= 5e-4;
  Curve foot;  // from zero back to the least strain, with little load
  for (int i = 0; i < 5; ++i) {
    foot.strain.push_back(-1e-4 * i);
    foot.stress.push_back(-1e3 * (5 - i));
  }
  foot.strain.insert(foot.strain.end(), curve.strain.begin(), curve.strain.end());
  foot.stress.insert(foot.stress.end(), curve.stress.begin(), curve.stress.end());
  const Target target = make_target("foot", foot);
  EXPECT_EQ(count_of(target, "foot-reversals"), 5U);
  EXPECT_EQ(target.corrected.size(), 2000U);
  EXPECT_NEAR(target.corrected.strain.front(), 0.0, 1e-6);
}

TEST(Repair, TakesSettlingCyclesBelowHalfOfTheLargestStressForMonotonic) {
  const Target target = make_target("settling", settling_cycles(0.3));
  EXPECT_EQ(target.loading, Loading::Monotonic);
  EXPECT_GT(count_of(target, "strain-reversals"), 0U);
}

/// Tension to 5 % with elastic loops down to a fraction of the stress, spread over the test.
Curve with_loops(int loops, double down_to, double end = 0.05) {
  const Curve smooth = smooth_curve(500, end);
  Curve curve;
  const auto add = [&](double strain, double stress) {
    curve.strain.push_back(strain);
    curve.stress.push_back(stress);
  };
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    add(smooth.strain[i], smooth.stress[i]);
    const auto gap = static_cast<std::size_t>(400 / loops);
    if (i < 100 || (i - 100) % gap != 0) continue;
    const double fall = (1.0 - down_to) * smooth.stress[i];
    for (int k = 1; k < 40; ++k) {
      const double part = 1.0 - std::abs(k - 20) / 20.0;
      add(smooth.strain[i] - part * fall / 70e9, smooth.stress[i] - part * fall);
    }
  }
  return curve;
}

TEST(Repair, TakesATensionTestWithALoopForMonotonicAndDropsTheLoop) {
  for (const double down_to : {0.1, 0.0, 0.6}) {
    const Target plain = make_target("plain", smooth_curve(500, 0.05));
    const Target target = make_target("loop", with_loops(1, down_to));
    EXPECT_EQ(target.loading, Loading::Monotonic);
    EXPECT_EQ(target.status, TargetStatus::Ready) << target.reason;
    EXPECT_EQ(count_of(target, "unloading-loops"), 39U);
    EXPECT_EQ(target.corrected.strain, plain.corrected.strain);
    EXPECT_EQ(target.characteristics.proof_stress, plain.characteristics.proof_stress);
    EXPECT_FALSE(target.characteristics.observed_break.has_value());
  }
  EXPECT_EQ(find_loading(with_loops(4, 0.1)), Loading::Monotonic);
}

TEST(Repair, TakesManyLoopsInAShortStrainForCyclic) {
  EXPECT_EQ(find_loading(with_loops(8, 0.1, 0.015)), Loading::Cyclic);
}

TEST(Repair, TakesAChangeOfSignForCyclicAndKeepsAllSamples) {
  EXPECT_EQ(find_loading(with_loops(1, -0.05)), Loading::Monotonic);
  const Curve curve = with_loops(1, -0.3);
  const Target target = make_target("cyclic", curve);
  EXPECT_EQ(target.loading, Loading::Cyclic);
  EXPECT_EQ(target.corrected.size(), curve.size());
}

/// Tension to 5 %, then unloading over some samples at a fraction of the modulus.
Curve unloaded(int samples, double down_to, double slope = 1.0) {
  Curve curve = smooth_curve(500, 0.05);
  const double strain = curve.strain.back();
  const double stress = curve.stress.back();
  for (int k = 1; k <= samples; ++k) {
    const double fall = (1.0 - down_to) * stress * k / samples;
    curve.strain.push_back(strain - fall / (slope * 70e9));
    curve.stress.push_back(stress - fall);
  }
  return curve;
}

TEST(Repair, DropsElasticUnloadingAtTheEndAndSeesNoBreak) {
  for (const double down_to : {0.0, 0.5}) {
    const Target target = make_target("unloaded", unloaded(50, down_to, 0.85));
    EXPECT_EQ(target.loading, Loading::Monotonic);
    EXPECT_EQ(count_of(target, "unloading"), 50U);
    EXPECT_FALSE(target.characteristics.observed_break.has_value());
    EXPECT_EQ(target.corrected.size(), 500U);
  }
}

TEST(Repair, TakesASnapBackOfTheExtensometerForABreak) {
  for (const Curve& curve : {unloaded(2, 0.0), unloaded(50, 0.0, 10.0), unloaded(50, 0.0, 0.2)}) {
    const Target target = make_target("snap", curve);
    EXPECT_EQ(count_of(target, "unloading"), 0U);
    ASSERT_TRUE(target.characteristics.observed_break.has_value());
    EXPECT_GE(target.characteristics.observed_break->first_broken_strain, 0.05);
  }
}

TEST(Repair, DropsALoneOutlierAndKeepsTheRestOfTheCurve) {
  for (const double wrong : {0.0, 900e6, -500e6}) {
    Curve curve = smooth_curve();
    curve.stress[250] = wrong;
    const Target target = make_target("outlier", curve);
    EXPECT_EQ(target.loading, Loading::Monotonic);
    EXPECT_EQ(count_of(target, "outliers"), 1U);
    EXPECT_EQ(target.corrected.size(), 499U);
    EXPECT_FALSE(target.characteristics.observed_break.has_value());
    EXPECT_NEAR(target.characteristics.rm.value(), curve.stress.back(), 1.0);
  }
  Curve curve = smooth_curve();
  curve.stress[250] *= 0.975;
  EXPECT_EQ(count_of(make_target("small", curve), "outliers"), 0U);
}

TEST(Repair, FollowsALoadingThatIsGiven) {
  TargetOptions options;
  options.loading = Loading::Monotonic;
  const Target target = make_target("given", settling_cycles(0.8), options);
  EXPECT_EQ(target.loading, Loading::Monotonic);
  EXPECT_GT(count_of(target, "unloading-loops"), 0U);
  options.loading = Loading::Cyclic;
  EXPECT_EQ(make_target("given", smooth_curve(), options).loading, Loading::Cyclic);
}

TEST(Repair, TakesALoadDropForABreakNotForUnloading) {
  plastica::testing::IdealPlastic test;
  EXPECT_EQ(find_loading(test.curve()), Loading::Monotonic);
}

/// A neck after Rm, with the extensometer as it is from some row on.
Curve taken_off(double value, double noise) {
  Curve curve = smooth_curve(400, 0.1);
  for (int i = 1; i <= 200; ++i) {
    curve.strain.push_back(0.1 + 5e-4 * i);
    curve.stress.push_back(350e6 - 1e6 * i);
  }
  for (std::size_t i = 300; i < curve.size(); ++i) {
    curve.strain[i] = (value < 0.0 ? curve.strain[299] : value) + noise * (i % 3 == 0 ? 1.0 : -0.5);
  }
  return curve;
}

TEST(Repair, TakesAStrainThatStandsStillUnderLoadForNone) {
  for (const double value : {-1.0, 0.0, 0.02}) {  // held, set to zero, or clamped elsewhere
    for (const double noise : {0.0, 1e-7, 1e-5}) {
      const Target target = make_target("held", taken_off(value, noise));
      EXPECT_EQ(target.status, TargetStatus::Ready) << target.reason;
      EXPECT_GE(count_of(target, "extensometer-removed"), 299U) << value;
      EXPECT_FALSE(target.characteristics.break_strain.has_value()) << value;
      EXPECT_NEAR(*target.characteristics.rm, 350e6, 1e6) << value;
      EXPECT_LT(target.characteristics.largest_strain, 0.076) << value;
    }
  }
}

/// Where the machine stops at the break, the strain stands still as well, without load.
TEST(Repair, TakesABreakAtAStandingStrainForABreak) {
  Curve curve = smooth_curve(400, 0.1);
  for (int i = 1; i <= 20; ++i) {
    curve.strain.push_back(0.1);
    curve.stress.push_back(350e6 * std::pow(0.3, i));
  }
  const Target target = make_target("broken", curve);
  EXPECT_EQ(count_of(target, "extensometer-removed"), 0U);
  EXPECT_NEAR(target.characteristics.break_strain.value_or(0.0), 0.1, 1e-3);
}

TEST(Repair, SaysAboveAllThatManySamplesWereDropped) {
  // A loop of a hundred samples in a test of two hundred.
  const Curve smooth = smooth_curve(200);
  Curve curve;
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    curve.strain.push_back(smooth.strain[i]);
    curve.stress.push_back(smooth.stress[i]);
    if (i != 100) continue;
    for (int k = 1; k < 100; ++k) {
      const double down = 0.9 * smooth.stress[i] * (k < 50 ? k : 100 - k) / 50.0;
      curve.strain.push_back(smooth.strain[i] - down / 70e9);
      curve.stress.push_back(smooth.stress[i] - down);
    }
  }
  const Target target = make_target("loops", curve);
  ASSERT_FALSE(target.warnings.empty());
  EXPECT_TRUE(target.warnings.front().starts_with(
      "33 % of the samples were dropped (unloading-loops 99), as the curve is taken for one "))
      << target.warnings.front();
  EXPECT_EQ(too_many_dropped(make_target("smooth", smooth)), "");
}

/// A spike is no strength and no strain at break.
TEST(Repair, DropsSpikesOfSeveralSamples) {
  const Target whole = make_target("whole", plastica::testing::IdealPlastic{}.curve());
  const auto expect_dropped = [&](const Curve& curve, std::size_t count) {
    const Target target = make_target("spike", curve);
    EXPECT_EQ(count_of(target, "spikes"), count);
    EXPECT_NEAR(*target.characteristics.rm / *whole.characteristics.rm, 1.0, 1e-9);
    EXPECT_NEAR(target.characteristics.break_strain.value_or(0.0),
                *whole.characteristics.break_strain, 6e-4);
  };
  for (const std::size_t at : {60U, 100U}) {
    for (const std::size_t length : {2U, 3U, 5U}) {
      Curve curve = plastica::testing::IdealPlastic{}.curve();
      for (std::size_t i = at; i < at + length; ++i) curve.stress[i] *= 1.6;
      expect_dropped(curve, length);
    }
  }
  Curve strain = plastica::testing::IdealPlastic{}.curve();
  strain.strain[70] = 0.9;
  expect_dropped(strain, 1);
  Curve overflow = plastica::testing::IdealPlastic{}.curve();
  for (std::size_t i = overflow.size() - 2; i < overflow.size(); ++i) overflow.stress[i] = 9999e6;
  expect_dropped(overflow, 2);
}

TEST(Repair, KeepsWhatFallsForAFewSamples) {
  Curve curve = plastica::testing::IdealPlastic{}.curve();
  for (std::size_t i = 100; i < 103; ++i) curve.stress[i] = 200e6;
  EXPECT_EQ(count_of(make_target("dropout", curve), "spikes"), 0U);
  // Few samples on a steep rise are no spike at the end.
  Curve elastic;
  for (int i = 0; i < 40; ++i) {
    elastic.strain.push_back(1e-5 * i * i);
    elastic.stress.push_back(2e6 * i * i);
  }
  EXPECT_EQ(count_of(make_target("rise", elastic), "spikes"), 0U);
}

TEST(Repair, KeepsPeaksAndUpturnsOfTheMaterial) {
  Curve luders;  // an upper yield point of two samples, on the elastic rise
  for (const double stress : {0.0, 75.0, 150.0, 225.0, 300.0, 375.0, 392.0}) {
    luders.strain.push_back(stress / 205e3);
    luders.stress.push_back(1e6 * stress);
  }
  for (int i = 1; i <= 33; ++i) {
    luders.strain.push_back(0.002 + 6e-4 * i);
    luders.stress.push_back(300e6 + 1e6 * (i % 2));
  }
  EXPECT_EQ(count_of(make_target("luders", luders), "spikes"), 0U);
  Curve rubber;  // gets steep towards its end
  for (int i = 0; i < 40; ++i) {
    rubber.strain.push_back(0.15 * i);
    rubber.stress.push_back(1e6 * std::exp(0.27 * i) / 300.0 + 2e5 * i);
  }
  EXPECT_EQ(count_of(make_target("rubber", rubber), "spikes"), 0U);
}

/// Of a hundred fine records with a noisy strain none ends before its end.
TEST(Repair, TakesNoNoisyEndForAStandingStrain) {
  int taken = 0;
  for (unsigned seed = 0; seed < (kSanitized ? 5 : 100); ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    Curve curve = smooth_curve(5000, 0.1);
    for (double& strain : curve.strain) strain += 3e-4 * normal(random);
    for (double& stress : curve.stress) stress += 3e6 * normal(random);
    taken += count_of(make_target("noisy", curve), "extensometer-removed") > 0 ? 1 : 0;
  }
  EXPECT_EQ(taken, 0);
}

}  // namespace
}  // namespace plastica::calibrate
