#include "calibrate/target/scene_target.hpp"

#include <gtest/gtest.h>

#include <string>

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
