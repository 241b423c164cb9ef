#include "calibrate/target/strain_end.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "calibrate/target/make.hpp"
#include "calibrate/target/repair.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::size_t kMeasured = 140;  // rows

/// Voce's curve to 10 %, then rows at a strain, in which the load goes on.
/// @param further  stress above the last measured one, of the fraction of those rows
template <typename Further>
Curve stands_at(double strain, std::size_t rows, double noise, const Further& further) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  Curve curve;
  double last = 0.0;
  for (std::size_t i = 0; i < kMeasured; ++i) {
    const double total = 0.1 * static_cast<double>(i) / static_cast<double>(kMeasured - 1);
    const double hardening = 180e6 * (1.0 - std::exp(-14.0 * total));
    last = std::min(200e9 * total, 350e6 + hardening);
    curve.strain.push_back(total);
    curve.stress.push_back(last + noise * normal(random));
  }
  for (std::size_t i = 0; i < rows; ++i) {
    const double fraction = static_cast<double>(i + 1) / static_cast<double>(rows);
    curve.strain.push_back(strain);
    curve.stress.push_back(last + further(fraction) + noise * normal(random));
  }
  return curve;
}

double rises_by_ten(double fraction) { return 50e6 * fraction; }

/// The rows before the extensometer was taken off are those of the record that was cut there,
/// wherever its signal jumps: one false sample beyond the curve was two thirds of its strain path.
TEST(StrainEnd, TakesNoJumpForASample) {
  for (const double at : {0.3, 0.11, 0.05, 0.0, -0.02}) {
    const Curve curve = stands_at(at, 80, 0.5e6, rises_by_ten);
    EXPECT_EQ(strain_end(curve).measured, kMeasured) << at;
    const Target target = make_target("jumps", curve);
    EXPECT_EQ(target.corrected.size(), kMeasured) << at;
    EXPECT_DOUBLE_EQ(target.corrected.strain.back(), curve.strain[kMeasured - 1]) << at;
    EXPECT_FALSE(target.characteristics.observed_break);
  }
}

/// The first row that stands still was measured where it is a step on.
TEST(StrainEnd, KeepsTheRowAtWhichItStopped) {
  EXPECT_EQ(strain_end(stands_at(0.1007, 80, 0.5e6, rises_by_ten)).measured, kMeasured + 1);
}

/// A load of 3 % up and down again does not move from quarter to quarter, and rises all the same:
/// at one strain nothing does.
TEST(StrainEnd, IsAlsoSeenByALoadThatRises) {
  const auto hump = [](double fraction) {
    return 15e6 * std::sin(std::acos(-1.0) * fraction) - (fraction == 1.0 ? 500e6 : 0.0);
  };
  for (const double at : {0.1, 0.3, 0.0}) {
    const Target target = make_target("hump", stands_at(at, 82, 0.5e6, hump));
    EXPECT_FALSE(target.characteristics.observed_break) << at;
    EXPECT_LE(target.characteristics.largest_strain, 0.1) << at;
    EXPECT_NEAR(*target.characteristics.rm, 500e6, 3e6) << at;
  }
}

/// Where the load stays as it is nothing tells; that is said.
TEST(StrainEnd, SaysThatABreakAtALongStandingStrainMayNotBeMeasured) {
  const auto breaks = [](double fraction) { return fraction == 1.0 ? -485e6 : 0.0; };
  const auto says = [&](std::size_t rows) {
    const Target target = make_target("still", stands_at(0.1, rows, 0.5e6, breaks));
    EXPECT_TRUE(target.characteristics.observed_break);
    return std::ranges::any_of(target.warnings, [](const std::string& warning) {
      return warning.starts_with("the strain stands still at 10 % over ");
    });
  };
  EXPECT_TRUE(says(82));
  EXPECT_FALSE(says(10));
}

/// However long the pauses were: none begins with a jump.
TEST(StrainEnd, IsInDoubtWhereTheStrainHasJumped) {
  const auto breaks = [](double fraction) { return fraction == 1.0 ? -485e6 : 0.0; };
  for (const double at : {0.1, 0.15}) {
    Curve curve = stands_at(at, 60, 0.5e6, breaks);
    for (int k = 0; k < 90; ++k) {  // a pause at row 30
      curve.strain.insert(curve.strain.begin() + 31, curve.strain[30]);
      curve.stress.insert(curve.stress.begin() + 31, curve.stress[30]);
    }
    EXPECT_EQ(strain_end(curve).unclear > 0, at > 0.1);
  }
}

/// Rows that are dense on the elastic part stand still no more than others, by whatever the strain
/// jumps to, and with noise: an extensometer that was taken off later is seen.
TEST(StrainEnd, IsSeenBehindADenseElasticPart) {
  for (const double noise : {0.0, 3e-5}) {
    for (const double at : {0.1, 0.3, 1.4, 10.0, 0.0}) {
      std::mt19937_64 random(7);
      std::normal_distribution<double> normal(0.0, 1.0);
      const Curve sparse = stands_at(at, 60, 0.5e6, rises_by_ten);
      Curve dense;
      for (int i = 0; i < 1000; ++i) {
        dense.strain.push_back(2e-6 * i);
        dense.stress.push_back(200e9 * 2e-6 * i * 0.9);
      }
      for (std::size_t i = 3; i < sparse.size(); ++i) {
        dense.strain.push_back(sparse.strain[i]);
        dense.stress.push_back(sparse.stress[i]);
      }
      for (double& strain : dense.strain) strain += noise * normal(random);
      EXPECT_NEAR(static_cast<double>(strain_end(dense).measured), 1000.0 + kMeasured - 3.0, 1.0)
          << at << ' ' << noise;
    }
  }
}

/// Nor does a row without a number, a glitch, or the shock of the break hide it.
TEST(StrainEnd, IsSeenPastWhatIsNoStrain) {
  const auto breaks = [](double fraction) { return fraction > 0.9 ? -480e6 : 50e6 * fraction; };
  const Curve whole = stands_at(0.3, 100, 0.5e6, breaks);
  for (const int kind : {0, 1, 2, 3}) {
    Curve curve = whole;
    if (kind == 0) curve.strain[kMeasured + 40] = NAN;
    if (kind == 1) curve.strain[kMeasured + 40] += 0.01;
    if (kind == 2) curve.stress[kMeasured + 2] = NAN;
    if (kind == 3) {
      for (std::size_t i = kMeasured + 91; i < curve.size(); ++i) curve.strain[i] += 0.003;
    }
    EXPECT_EQ(strain_end(curve).measured, kMeasured) << kind;
    EXPECT_FALSE(make_target("past", curve).characteristics.observed_break) << kind;
  }
}

/// A pause at a strain whose load is but noise is no step of a coarse strain.
TEST(StrainEnd, IsSeenAfterAPauseUnderANoisyLoad) {
  const Curve sparse = stands_at(0.3, 100, 2e6, rises_by_ten);
  Curve curve;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0.0, 2e6);
  for (std::size_t i = 0; i < sparse.size(); ++i) {
    curve.strain.push_back(sparse.strain[i]);
    curve.stress.push_back(sparse.stress[i]);
    for (int k = 0; i == 30 && k < 300; ++k) {
      curve.strain.push_back(sparse.strain[i]);
      curve.stress.push_back(sparse.stress[i] + normal(random));
    }
  }
  EXPECT_EQ(strain_end(curve).measured, kMeasured + 300);
}

/// A break at which the strain stands behind the specimen's, or that falls in near rows, is a
/// break.
TEST(StrainEnd, LeavesBreaksAlone) {
  Curve curve = stands_at(0.106, 90, 0.5e6, [](double) { return -315e6; });
  Target target = make_target("after", curve);
  EXPECT_TRUE(target.characteristics.observed_break);
  EXPECT_FALSE(std::ranges::any_of(target.warnings, [](const std::string& warning) {
    return warning.starts_with("the strain stands still");
  }));
  curve = stands_at(0.1007, 32, 0.5e6, [](double fraction) { return -485e6 * fraction; });
  EXPECT_EQ(strain_end(curve).measured, curve.size());
  EXPECT_TRUE(make_target("fast", curve).characteristics.observed_break);
}

/// What runs back under load up to the break hides it.
TEST(StrainEnd, OfAStrainThatFallsUnderLoadIsNoBreak) {
  Curve curve = stands_at(0.0, 0, 0.5e6, rises_by_ten);
  for (int i = 0; i < 25; ++i) {
    curve.strain.push_back(0.07 - 2e-4 * i);
    curve.stress.push_back(490e6);
  }
  curve.strain.push_back(0.065);
  curve.stress.push_back(0.0);
  const Target target = make_target("falls", curve);
  EXPECT_FALSE(target.characteristics.observed_break);
  EXPECT_TRUE(std::ranges::any_of(target.warnings, [](const std::string& warning) {
    return warning.starts_with("the strain runs back from 10 % for 25 samples before the break");
  }));
}

/// A record whose strain has steps of thirty rows ends like any other.
TEST(StrainEnd, IsNoStepOfACoarseStrain) {
  Curve curve = stands_at(0.1, 0, 0.0, rises_by_ten);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    curve.strain[i] = curve.strain[i / 30 * 30];
    curve.stress[i] = 400e6 + 1e6 * static_cast<double>(i);
  }
  EXPECT_EQ(strain_end(curve).measured, curve.size());
  EXPECT_EQ(strain_end(curve).unclear, 0U);
}

}  // namespace
}  // namespace plastica::calibrate
