#include "calibrate/target/scene_target.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "calibrate/target/samples.hpp"
#include "calibrate/target/scene_break.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/calibrate/target/scene_target_file.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using testing::bend_test;
using testing::message_of;
using testing::SceneTargetFile;

TEST_F(SceneTargetFile, IsReadInSi) {
  const SceneTarget target = read("Displacement (mm),Force (kN)\n0,0\n1,0.5\n2,0.75\n");
  EXPECT_EQ(target.name, "bar");
  EXPECT_EQ(target.abscissa, (std::vector<double>{0.0, 1e-3, 2e-3}));
  EXPECT_EQ(target.ordinate, (std::vector<double>{0.0, 500.0, 750.0}));
  EXPECT_EQ(target.ordinate_factor, -1.0);
  EXPECT_FALSE(target.broke);
}

TEST_F(SceneTargetFile, SaysThatTheBeamBrokeBeforeALastRowOfNoForce) {
  const SceneTarget target = read("Displacement (mm),Force (N)\n0,0\n1,500\n2,600\n2.5,0\n");
  EXPECT_EQ(target.ordinate.size(), 3U);
  ASSERT_TRUE(target.broke);
  EXPECT_DOUBLE_EQ(target.broke->at, 2.25e-3);
  EXPECT_DOUBLE_EQ(target.broke->half_interval, 0.25e-3);
}

/// The machine goes on, or holds: the force is what is left of the gauge's zero.
TEST_F(SceneTargetFile, BreaksWhereTheForceFallsToZeroAndStaysThere) {
  const std::string loaded = "Displacement (mm),Force (N)\n0,0\n1,500\n2,600\n";
  for (const std::string rest :
       {"2.5,0\n3,0\n3.5,0\n", "2.5,4\n", "2.5,-6\n3,5\n3.5,-3\n4,0\n", "2.5,0.1\n2.5,0.2\n"}) {
    const SceneTarget target = read(loaded + rest);
    EXPECT_EQ(target.ordinate, (std::vector<double>{0.0, 500.0, 600.0})) << rest;
    ASSERT_TRUE(target.broke) << rest;
    EXPECT_DOUBLE_EQ(target.broke->at, 2.25e-3) << rest;
    EXPECT_EQ(target.broke->cut, static_cast<std::size_t>(std::ranges::count(rest, '\n')));
  }
  for (const std::string rest :
       {"2.5,400\n3,250\n3.5,120\n4,20\n", "2.5,100\n3,0\n", "2.5,0\n3,300\n", "2.5,40\n3,45\n"}) {
    EXPECT_FALSE(read(loaded + rest).broke) << rest;
  }
}

TEST_F(SceneTargetFile, IsLetGoWhereItsAbscissaGoesBack) {
  const auto broke = [&](const std::string& rest) {
    return read_driven("Displacement (mm),Force (N)\n0,0\n1,500\n2,600\n" + rest).broke;
  };
  EXPECT_FALSE(broke("0.8,0\n"));
  EXPECT_FALSE(broke("0.9,10\n0.8,0\n"));
  ASSERT_TRUE(broke("2,0\n"));
  // What stands still says nothing of how far the beam went: a step at most.
  EXPECT_DOUBLE_EQ(broke("2,0\n")->half_interval, 0.5e-3);
  EXPECT_DOUBLE_EQ(broke("1.9999,0\n")->at, 2.5e-3);
  ASSERT_TRUE(broke("1.5,250\n2.1,0\n2.2,0\n"));
  // A cycle that ends on its way back through zero, and one that breaks on its way on.
  EXPECT_FALSE(broke("1,0\n-0.1,-500\n0.2,-10\n"));
  EXPECT_TRUE(broke("1,0\n-0.1,-500\n-0.2,-510\n-0.3,-10\n"));
}

TEST_F(SceneTargetFile, BreaksWhereTheUserSays) {
  SceneTarget probes;
  probes.abscissa_probe = "displacement";
  probes.ordinate_probe = "force";
  const auto read_with = [&](CorrectionChoice trim) {
    SceneTargetSource from = source("Displacement (mm),Force (N)\n0,0\n1,500\n2,600\n3,200\n4,0\n");
    from.trim = trim;
    return read_scene_target(from, bend_test(4).scene, probes);
  };
  EXPECT_EQ(read_with({CorrectionChoice::Mode::Off, 0.0}).ordinate.size(), 5U);
  EXPECT_DOUBLE_EQ(read_with({}).broke.value().at, 3.5e-3);
  const SceneTarget set = read_with({CorrectionChoice::Mode::Set, 2.0e-3});
  EXPECT_DOUBLE_EQ(set.broke.value().at, 2.5e-3);
  EXPECT_EQ(set.broke->cut, 2U);
  EXPECT_FALSE(read_with({CorrectionChoice::Mode::Set, 9.0e-3}).broke);
}

/// A struck bar swings through zero, and a force that is taken away falls with the samples.
TEST_F(SceneTargetFile, OfAMotionBreaksByHalfOfTheLargestAtOnce) {
  SceneTarget timed;
  timed.kind = Abscissa::Time;
  const auto broke = [&](std::vector<double> y) {
    timed.ordinate = std::move(y);
    timed.abscissa.resize(timed.ordinate.size());
    std::iota(timed.abscissa.begin(), timed.abscissa.end(), 0.0);
    return intact_samples(timed, {});
  };
  EXPECT_EQ(broke({0.0, 60.0, 100.0, 0.1, 0.2, -0.1}), 3U);
  EXPECT_EQ(broke({0.0, 60.0, 100.0, 0.0}), 3U);
  EXPECT_FALSE(broke({0.0, 60.0, 100.0, 60.0, 2.0}));
  EXPECT_FALSE(broke({100.0, 75.0, 50.0, 25.0, 0.0, 0.0, 0.0}));
}

TEST_F(SceneTargetFile, IsRepairedInTheWordsOfACoupon) {
  const std::string rows = "0,0\n1,500\n1,500\n2,NaN\n,600\n3,700\n4,";
  const SceneTarget beam = read("Displacement (mm),Force (N)\n" + rows);
  EXPECT_EQ(beam.abscissa, (std::vector<double>{0.0, 1e-3, 3e-3}));
  EXPECT_EQ(beam.ordinate, (std::vector<double>{0.0, 500.0, 700.0}));
  EXPECT_EQ(repairs_of(beam.repairs),
            (std::vector<std::string>{"torn-last-row: the last row was cut off and is dropped",
                                      "nan-rows: 2 rows dropped that lack one of the two numbers",
                                      "duplicates: 1 samples equal to the one before dropped"}));
  TargetSource coupon;
  coupon.files = {folder_.write("coupon.csv", "Displacement (%),Force (MPa)\n" + rows)};
  coupon.strain = {"Displacement", {}, {}};
  coupon.stress = {"Force", {}, {}};
  EXPECT_EQ(repairs_of(import_targets(coupon).at(0).repairs), repairs_of(beam.repairs));
}

/// The load cell is lost: what it would have shown is not known.
TEST_F(SceneTargetFile, DoesNotBreakWhereItsForceIsNoLongerMeasured) {
  const SceneTarget target = read("Displacement (mm),Force (N)\n0,0\n1,500\n2,600\n3,NaN\n4,\n");
  EXPECT_FALSE(target.broke);
  EXPECT_EQ(target.ordinate, (std::vector<double>{0.0, 500.0, 600.0}));
  const SceneTarget later = read("Displacement (mm),Force (N)\n0,0\n1,500\n2,600\n3,NaN\n4,0\n");
  ASSERT_TRUE(later.broke) << "anywhere between the samples that are known";
  EXPECT_DOUBLE_EQ(later.broke->at, 3e-3);
  EXPECT_DOUBLE_EQ(later.broke->half_interval, 1e-3);
}

TEST_F(SceneTargetFile, LosesLoneOutliersIfItGoesOneWay) {
  /// A line of 12 samples with one zero.
  const auto line = [](int sign) {
    std::string rows;
    for (int i = 0; i < 12; ++i) {
      rows += std::to_string(sign * i) + ',' + std::to_string(i == 8 ? 0 : sign * (100 + 10 * i)) +
              '\n';
    }
    return rows;
  };
  const std::string header = "Displacement (mm),Force (N)\n";
  EXPECT_EQ(repairs_of(read(header + line(1)).repairs),
            (std::vector<std::string>{"outliers: 1 lone samples far off both neighbours dropped"}));
  EXPECT_EQ(read_driven(header + line(1)).ordinate.size(), 11U);
  EXPECT_EQ(read_driven(header + line(-1)).ordinate.size(), 11U);
  // To and fro it may be a corner of the path, and of a motion a blow.
  EXPECT_EQ(read_driven(header + line(1) + "0,5\n").ordinate.size(), 13U);
  SceneTarget timed;
  timed.kind = Abscissa::Time;
  timed.ordinate_probe = "force";
  EXPECT_EQ(
      read_scene_target(source("Displacement (s),Force (N)\n" + line(1)), bend_test(4).scene, timed)
          .ordinate.size(),
      12U);
}

TEST_F(SceneTargetFile, AveragesWhatRunsBackWithinTheNoiseOfItsAbscissa) {
  // A thousandth of 10 mm.
  const std::string text =
      "Displacement (mm),Force (N)\n0,0\n5,500\n4.995,510\n4.9999,505\n10,600\n";
  const SceneTarget target = read(text);
  ASSERT_EQ(target.abscissa.size(), 4U);
  EXPECT_DOUBLE_EQ(target.abscissa[1], 4.9975e-3);
  EXPECT_DOUBLE_EQ(target.ordinate[1], 505.0);
  EXPECT_DOUBLE_EQ(target.abscissa[2], 4.9999e-3);
  EXPECT_EQ(repairs_of(target.repairs),
            (std::vector<std::string>{
                "abscissa-reversals: 2 samples averaged where the abscissa ran backwards"}));
  EXPECT_EQ(read_driven(text).ordinate.size(), 5U) << "a scene that follows it goes back, too";
}

TEST_F(SceneTargetFile, IsNotShiftedByTheNoiseOfItsAbscissa) {
  // 2000 samples of a straight line, the noise of whose abscissa is four times their spacing.
  constexpr double kSpacing = 0.025, kNoise = 0.1;  // mm
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0.0, kNoise);
  std::string text = "Displacement (mm),Force (N)\n";
  for (int i = 0; i < 2000; ++i) {
    const double x = kSpacing * i;
    text += std::to_string(x + normal(random)) + ',' + std::to_string(100.0 + x) + '\n';
  }
  SceneTargetSource from = source(text);
  from.reversal_tolerance = 1e-3;
  SceneTarget probes;
  probes.abscissa_probe = "displacement";
  probes.ordinate_probe = "force";
  const SceneTarget target = read_scene_target(from, bend_test(4).scene, probes);
  EXPECT_TRUE(std::ranges::is_sorted(target.abscissa));
  ASSERT_GT(target.abscissa.size(), 200U);
  double shift = 0.0;
  for (std::size_t i = 0; i < target.abscissa.size(); ++i) {
    shift += 1e3 * target.abscissa[i] - (target.ordinate[i] - 100.0);
  }
  EXPECT_NEAR(shift / static_cast<double>(target.abscissa.size()), 0.0, 0.15 * kNoise);
}

TEST_F(SceneTargetFile, ThatAScenesPathFollowsMayNotLoseACorner) {
  const auto turned = [&](const std::string& rows) {
    return message_of([&] { read_driven("Displacement (mm),Force (N)\n" + rows); });
  };
  const std::string rule =
      "has no ordinate where the path turns: a scene that follows this column would not go there";
  EXPECT_EQ(turned("0,0\n10,500\n20,NaN\n10,300\n"), file("4: Displacement = 20: " + rule));
  EXPECT_EQ(turned("0,0\n10,500\n20,NaN\n25,NaN\n22,300\n"), file("5: Displacement = 25: " + rule));
  EXPECT_EQ(turned("-5,NaN\n1,0\n10,500\n"), file("2: Displacement = -5: " + rule));
  for (const std::string rows : {"0,0\n10,500\n20,NaN\n30,300\n", "0,0\n10,500\n20,NaN\n",
                                 "0,NaN\n1,0\n10,500\n", "0,0\n10,500\nNaN,7\n30,300\n"}) {
    EXPECT_EQ(read_driven("Displacement (mm),Force (N)\n" + rows).repairs.front().kind, "nan-rows")
        << rows;
  }
}

TEST_F(SceneTargetFile, MayRunBackByAPartOfItsRangeUnderLoad) {
  // A sensor that falls off at the break.
  EXPECT_EQ(refusal("Displacement (mm),Force (N)\n0,0\n5,500\n4,450\n10,600\n5000,0\n"),
            refusal("Displacement (mm),Force (N)\n0,0\n5,500\n4,450\n10,600\n11,0\n"));
  EXPECT_NE(refusal("Displacement (mm),Force (N)\n0,0\n5,500\n4,450\n10,600\n5000,0\n"), "");
}

TEST_F(SceneTargetFile, ThatFallsAllTheWayIsToBeTurned) {
  EXPECT_EQ(refusal("Displacement (mm),Force (N)\n0,0\n-1,500\n-2,600\n"),
            file("3: Displacement = -1: falls all the way, and must rise: turn its sign, and set "
                 "its factor "
                 "to -1"));
}

TEST_F(SceneTargetFile, SaysWhichCommentsMayBeRows) {
  const auto repairs = [&](const std::string& rows) {
    return repairs_of(read("Displacement (mm),Force (N)\n" + rows).repairs);
  };
  EXPECT_EQ(repairs("0,0\n# paused, at noon\n1,500\n2,600\n"), std::vector<std::string>());
  EXPECT_EQ(repairs("0,0\n#1,500\n2,600\n# 3,700\n4,800\n"),
            (std::vector<std::string>{
                "comment-rows: 2 rows that begin with #, % or // are taken for comments"}));
  // A comment at the end does not hide that the row before it was cut off.
  EXPECT_EQ(repairs("0,0\n1,500\n2\n# end\n"),
            (std::vector<std::string>{"torn-last-row: the last row was cut off and is dropped"}));
}

TEST_F(SceneTargetFile, GoesBackAsFarAsTheUserSays) {
  SceneTarget probes;
  probes.abscissa_probe = "displacement";
  probes.ordinate_probe = "force";
  SceneTargetSource from = source("Displacement (mm),Force (N)\n0,0\n5,500\n4.9,510\n10,600\n");
  const auto read_within = [&](double tolerance) {
    from.reversal_tolerance = tolerance;
    return read_scene_target(from, bend_test(4).scene, probes).ordinate.size();
  };
  EXPECT_EQ(read_within(0.2e-3), 3U);
  EXPECT_THROW(read_within(0.05e-3), InputError);
}

TEST_F(SceneTargetFile, BreaksWhereItsAbscissaIsNoisyAndGoesBackAfterwards) {
  const std::string loaded = "Displacement (mm),Force (N)\n0,0\n5,500\n10,600\n";
  for (const std::string rest : {"9.995,0\n", "9.995,0\n10.2,0\n4,0\n", "10.002,0\n0,0\n"}) {
    const SceneTarget target = read(loaded + rest);
    EXPECT_EQ(target.abscissa, (std::vector<double>{0.0, 5e-3, 10e-3})) << rest;
    ASSERT_TRUE(target.broke) << rest;
    EXPECT_NEAR(target.broke->at - target.broke->half_interval, 10e-3, 1e-15) << rest;
    EXPECT_NEAR(target.broke->at + target.broke->half_interval, 15e-3, 1e-15) << rest;
  }
}

TEST_F(SceneTargetFile, WarnsOfStrainsAbove100PercentWithoutAUnit) {
  SceneTarget coupon;
  coupon.kind = Abscissa::Strain;
  coupon.ordinate_probe = "force";
  const auto warnings = [&](const std::string& header) {
    return read_scene_target(source(header + ",Force (N)\n0,0\n2,500\n"), bend_test(4).scene,
                             coupon)
        .warnings;
  };
  EXPECT_EQ(warnings("Displacement"),
            (std::vector<std::string>{
                "strains above 100 %: if they are in percent, write unit = \"%\""}));
  EXPECT_TRUE(warnings("Displacement (%)").empty());
}

TEST_F(SceneTargetFile, RefusesWhatIsNoCurveOfTheScene) {
  // The line of the row stays the file's where rows before it were dropped.
  EXPECT_EQ(
      refusal("Displacement (mm),Force (N)\n0,NaN\n0,0\n2,5\n2,5\n1,6\n"),
      file("6: Displacement = 1: goes back by more than reversal_tolerance: a beam's curve is "
           "followed one way; a scene that this column drives follows it to and fro"));
  SceneTarget probes;
  probes.abscissa_probe = "displacement";
  probes.ordinate_probe = "force";
  SceneTargetSource numbered = source("0,0\n2,5\n1,6\n");
  numbered.abscissa = {"1", "mm", {}};
  numbered.ordinate = {"2", "N", {}};
  EXPECT_TRUE(message_of([&] {
                read_scene_target(numbered, bend_test(4).scene, probes);
              }).starts_with(file("3: column 1 = 1: goes back by more than reversal_tolerance: ")));
  EXPECT_EQ(refusal("Displacement (mm),Force (N)\n0,NaN\n1,NaN\n"),
            folder_.file("bar.csv") + ": Force: no row has both numbers");
  EXPECT_EQ(refusal("Displacement (mm),Force (N)\n0,0\n1,much\n2,1\n"),
            file("3: Force = much: is not a number"));
  EXPECT_EQ(refusal("Displacement (mm),Load (N)\n0,0\n2,1\n"),
            "fit.toml:5: ordinate = Force: is not a column of " + folder_.file("bar.csv") +
                ", which has 2 columns: Displacement, Load");
  EXPECT_EQ(refusal("Displacement (mm),Force (N)\n0,0\n2,1\n", "load"),
            "fit.toml:5: ordinate.probe = load: is not one of the scene's probes: displacement, "
            "force");
  EXPECT_EQ(refusal("Displacement (mm),Force (MPa)\n0,0\n2,1\n"),
            folder_.file("bar.csv") +
                ": unit of Force = MPa: is not a unit of force (examples: N, kN, lbf)");
  EXPECT_EQ(
      refusal("Displacement (mm),Force\n0,0\n2,1\n"),
      "fit.toml:5: ordinate = Force: needs a unit, as " + folder_.file("bar.csv") + " gives none");
}

}  // namespace
}  // namespace plastica::calibrate
