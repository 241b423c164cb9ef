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
  std::normal_distribution<double> normal(0.0, noise);
  Curve curve;
  double last = 0.0;
  for (std::size_t i = 0; i < kMeasured; ++i) {
    const double total = 0.1 * static_cast<double>(i) / static_cast<double>(kMeasured - 1);
    const double hardening = 180e6 * (1.0 - std::exp(-14.0 * total));
    last = std::min(200e9 * total, 350e6 + hardening);
    curve.strain.push_back(total);
    curve.stress.push_back(last + normal(random));
  }
  for (std::size_t i = 0; i < rows; ++i) {
    const double fraction = static_cast<double>(i + 1) / static_cast<double>(rows);
    curve.strain.push_back(strain);
    curve.stress.push_back(last + further(fraction) + normal(random));
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

/// A record whose strain has steps of ten rows ends like any other.
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
