#include "calibrate/target/several_specimens.hpp"

#include <gtest/gtest.h>

#include <string>

#include "calibrate/target/make.hpp"
#include "tests/calibrate/target/curves.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::smooth_curve;

void append(Curve& curve, const Curve& more) {
  curve.strain.insert(curve.strain.end(), more.strain.begin(), more.strain.end());
  curve.stress.insert(curve.stress.end(), more.stress.begin(), more.stress.end());
}

TEST(NextSpecimen, BeginsWhereStrainAndStressBeginAnew) {
  Curve curve = smooth_curve(100);
  append(curve, smooth_curve(120));
  EXPECT_EQ(find_next_specimen(curve.strain, curve.stress), 100U);
  const Target target = make_target("two", curve);
  EXPECT_EQ(target.status, TargetStatus::Rejected);
  EXPECT_TRUE(target.reason.starts_with("another specimen begins at sample 101, "))
      << target.reason;
  for (double& strain : curve.strain) strain *= -1e3;
  EXPECT_EQ(find_next_specimen(curve.strain, curve.stress), 100U) << "in any sign and unit";
}

TEST(NextSpecimen, BeginsAfterABreakToo) {
  Curve curve = plastica::testing::IdealPlastic{}.curve();
  const std::size_t first = curve.size();
  append(curve, plastica::testing::IdealPlastic{}.curve());
  EXPECT_EQ(find_next_specimen(curve.strain, curve.stress), first);
}

TEST(NextSpecimen, IsNoneInOneTest) {
  Curve curve = smooth_curve(200);
  EXPECT_FALSE(find_next_specimen(curve.strain, curve.stress).has_value());
  // Unloaded at once: what is permanent stays.
  for (int i = 0; i < 3; ++i) {
    append(curve, {{0.0957, 0.1}, {0.0, 350e6}});
    EXPECT_FALSE(find_next_specimen(curve.strain, curve.stress).has_value());
  }
  // The extensometer is set to zero, or taken off, under load.
  Curve held = smooth_curve(200);
  Curve rest = smooth_curve(200, 0.02);
  for (double& stress : rest.stress) stress = 350e6;
  append(held, rest);
  EXPECT_FALSE(find_next_specimen(held.strain, held.stress).has_value());
  // The sensor falls back after the break, and nothing is loaded again.
  append(curve, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}});
  EXPECT_FALSE(find_next_specimen(curve.strain, curve.stress).has_value());
}

/// Cycles of few samples turn in steps that are as long as all others.
TEST(NextSpecimen, IsNoneInCycles) {
  Curve cycles;
  for (int i = 0; i < 40; ++i) {
    cycles.strain.push_back(i % 2 == 0 ? 0.0 : 1e-3);
    cycles.stress.push_back(i % 2 == 0 ? 0.0 : 200e6);
  }
  EXPECT_FALSE(find_next_specimen(cycles.strain, cycles.stress).has_value());
}

TEST(NextSpecimen, IsNoneWhereASensorDropsOutOrIsZeroed) {
  Curve dropout = smooth_curve(400);
  dropout.strain[200] = dropout.stress[200] = 0.0;
  EXPECT_FALSE(find_next_specimen(dropout.strain, dropout.stress).has_value());
  Curve zeroed;
  for (int i = 0; i < 10; ++i) {
    zeroed.strain.push_back(0.02);
    zeroed.stress.push_back(1e5);
  }
  append(zeroed, smooth_curve(200));
  EXPECT_FALSE(find_next_specimen(zeroed.strain, zeroed.stress).has_value());
}

}  // namespace
}  // namespace plastica::calibrate
