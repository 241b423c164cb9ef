#include "calibrate/target/scene_target.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "calibrate/target/scene_break.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using testing::bend_test;
using testing::message_of;

class SceneTargetFile : public ::testing::Test {
 protected:
  SceneTarget read(const std::string& text, const std::string& probe = "force") {
    SceneTarget probes;
    probes.abscissa_probe = "displacement";
    probes.ordinate_probe = probe;
    probes.ordinate_where = {"fit.toml", 5};
    probes.ordinate_factor = -1.0;
    return read_scene_target(source(text), bend_test(4).scene, probes);
  }

  std::string refusal(const std::string& text, const std::string& probe = "force") {
    return message_of([&] { read(text, probe); });
  }

  SceneTargetSource source(const std::string& text) {
    SceneTargetSource source;
    source.file = folder_.write("bar.csv", text);
    source.abscissa = {"Way", {}, {"fit.toml", 4}};
    source.ordinate = {"Force", {}, {"fit.toml", 5}};
    source.where = {"fit.toml", 3};
    return source;
  }

  std::string file(const std::string& line) const { return folder_.file("bar.csv") + ":" + line; }

  io::ScratchFolder folder_;
};

TEST_F(SceneTargetFile, IsReadInSi) {
  const SceneTarget target = read("Way (mm),Force (kN)\n0,0\n1,0.5\n2,0.75\n");
  EXPECT_EQ(target.name, "bar");
  EXPECT_EQ(target.abscissa, (std::vector<double>{0.0, 1e-3, 2e-3}));
  EXPECT_EQ(target.ordinate, (std::vector<double>{0.0, 500.0, 750.0}));
  EXPECT_EQ(target.ordinate_factor, -1.0);
  EXPECT_FALSE(target.broke);
}

TEST_F(SceneTargetFile, SaysThatTheBeamBrokeBeforeALastRowOfNoForce) {
  const SceneTarget target = read("Way (mm),Force (N)\n0,0\n1,500\n2,600\n2.5,0\n");
  EXPECT_EQ(target.ordinate.size(), 3U);
  ASSERT_TRUE(target.broke);
  EXPECT_DOUBLE_EQ(target.broke->at, 2.25e-3);
  EXPECT_DOUBLE_EQ(target.broke->half_interval, 0.25e-3);
}

/// The machine goes on, or holds: the force is what is left of the gauge's zero.
TEST_F(SceneTargetFile, BreaksWhereTheForceFallsToZeroAndStaysThere) {
  const std::string loaded = "Way (mm),Force (N)\n0,0\n1,500\n2,600\n";
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
  SceneTarget driven;
  driven.kind = Abscissa::Support;
  driven.driven = 1;
  driven.ordinate_probe = "force";
  const auto broke = [&](const std::string& rest) {
    const std::string loaded = "Way (mm),Force (N)\n0,0\n1,500\n2,600\n";
    return read_scene_target(source(loaded + rest), bend_test(4).scene, driven).broke;
  };
  EXPECT_FALSE(broke("0.8,0\n"));
  EXPECT_FALSE(broke("0.9,10\n0.8,0\n"));
  ASSERT_TRUE(broke("2,0\n"));
  EXPECT_EQ(broke("2,0\n")->half_interval, 0.0);
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
    SceneTargetSource from = source("Way (mm),Force (N)\n0,0\n1,500\n2,600\n3,200\n4,0\n");
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

TEST_F(SceneTargetFile, RefusesWhatIsNoCurveOfTheScene) {
  EXPECT_EQ(refusal("Way (mm),Force (N)\n0,0\n2,5\n1,6\n"),
            file("4: Way = 1: goes back: a beam's curve is followed one way; a scene that this "
                 "column drives follows it to and fro"));
  EXPECT_EQ(refusal("Way (mm),Force (N)\n0,0\n2,NaN\n3,6\n"),
            file("3: Force = NaN: must be a number in every row of a measured beam"));
  EXPECT_EQ(refusal("Way (mm),Load (N)\n0,0\n2,1\n"),
            "fit.toml:5: ordinate = Force: is not a column of " + folder_.file("bar.csv") +
                ", which has 2 columns: Way, Load");
  EXPECT_EQ(refusal("Way (mm),Force (N)\n0,0\n2,1\n", "load"),
            "fit.toml:5: ordinate.probe = load: is not one of the scene's probes: displacement, "
            "force");
  EXPECT_NE(refusal("Way (mm),Force (MPa)\n0,0\n2,1\n").find("Force"), std::string::npos);
  EXPECT_NE(refusal("Way (mm),Force\n0,0\n2,1\n").find("Force"), std::string::npos);
}

}  // namespace
}  // namespace plastica::calibrate
