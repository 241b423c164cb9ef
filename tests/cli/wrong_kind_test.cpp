#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/cli/bad_input.hpp"

/// Files that are sound, but not of the kind that a command takes.
namespace plastica::testing {
namespace {

/// One of each kind, as `init` writes it: scene.toml, sweep.toml, check.toml, fit.toml, and the
/// result of the scene.
class WrongKind : public ::testing::Test {
 protected:
  WrongKind() {
    for (const char* kind : {"scene", "check", "fit"}) {
      EXPECT_EQ(place_.run({"init", kind, "--force"}).code, 0) << kind;
    }
    EXPECT_EQ(place_.run({"simulate", "scene.toml", "-o", "result.h5", "--quiet"}).code, 0);
  }

  void expect_line(const std::vector<std::string>& arguments, const std::string& line) const {
    const auto before = place_.contents();
    const CommandResult ran = place_.run(arguments);
    EXPECT_EQ(ran.code, 2) << arguments.front();
    EXPECT_EQ(ran.err, "plastica: " + line + "\n");
    EXPECT_EQ(place_.contents(), before);
  }

  Workplace place_;
};

TEST_F(WrongKind, IsNamedAsWhatItIsWithTheCommandThatTakesIt) {
  expect_line(
      {"calibrate", "scene.toml"},
      "scene.toml: is a scene, which plastica simulate takes: must be a fit file or a file of "
      "curves");
  expect_line(
      {"calibrate", "result.h5"},
      "result.h5: is a result file, which plastica show takes: must be a fit file or a file "
      "of curves");
  for (const char* command : {"simulate", "stability"}) {
    expect_line({command, "sweep.toml"},
                "sweep.toml: is a sweep, which plastica sweep takes: must be a scene");
  }
  expect_line({"advise", "fit.toml", "--within", "1 %"},
              "fit.toml: is a fit file, which plastica calibrate takes: must be a scene");
  expect_line({"advise", "check.toml", "--within", "1 %", "--for", "mujoco"},
              "check.toml: is a file of claims, which plastica check takes: must be a scene");
  expect_line({"sweep", "scene.toml"},
              "scene.toml: is a scene, which plastica simulate takes: must be a sweep");
  expect_line({"check", "sweep.toml"},
              "sweep.toml: is a sweep, which plastica sweep takes: must be a file of claims");
  for (const char* command : {"show", "plot", "recommend"}) {
    expect_line({command, "scene.toml"},
                "scene.toml: is a scene, which plastica simulate takes: must be a result file");
  }
  expect_line({"export", "fit.toml"},
              "fit.toml: is a fit file, which plastica calibrate takes: must be a result file or a "
              "scene");
  expect_line({"inspect", "fit.toml"},
              "fit.toml: is a fit file, which plastica calibrate takes: must be a file of curves");
}

TEST_F(WrongKind, WithKeysOfTwoKindsIsLeftToItsReader) {
  place_.write("two.toml", place_.read("scene.toml") + "\n[[axis]]\nfield = 'beam.segments'\n");
  const CommandResult ran = place_.run({"simulate", "two.toml"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("axis: is not a key"), std::string::npos) << ran.err;
  place_.write("half.toml", "[fit]\nseed = 1\n[beam]\nlength = '1 m'\n");
  expect_line({"calibrate", "half.toml"},
              "half.toml: target: is missing: a fit needs at least one [[target]]");
}

TEST_F(WrongKind, OfItsOwnCommandPasses) {
  EXPECT_EQ(place_.run({"simulate", "scene.toml", "--dry-run"}).code, 0);
  EXPECT_EQ(place_.run({"sweep", "sweep.toml", "--dry-run"}).code, 0);
  EXPECT_EQ(place_.run({"check", "check.toml", "--dry-run"}).code, 0);
  EXPECT_EQ(place_.run({"calibrate", "fit.toml", "--dry-run"}).code, 0);
  EXPECT_EQ(place_.run({"show", "result.h5"}).code, 0);
}

TEST_F(WrongKind, OrAnotherFaultOfTheInputIsSaidBeforeThatTheOutputIsThere) {
  expect_line({"advise", "sweep.toml", "--within", "1 %", "-o", "scene.toml"},
              "sweep.toml: is a sweep, which plastica sweep takes: must be a scene");
  place_.write("there.xml", "");
  place_.write("there.svg", "");
  place_.write("there.csv", "");
  expect_line({"advise", "check.toml", "--within", "1 %", "--for", "mujoco", "-o", "there.xml"},
              "check.toml: is a file of claims, which plastica check takes: must be a scene");
  for (const auto& [command, output] :
       {std::pair{"plot", "there.svg"}, std::pair{"export", "there.csv"}}) {
    expect_line({command, "missing.h5", "-o", output},
                "missing.h5: cannot be read: No such file or directory");
  }
  expect_line(
      {"calibrate", "example-curve.csv", "--strain", "Weg:%", "--stress", "Stress:MPa", "-o",
       "result.h5"},
      "strain = Weg: is not a column of example-curve.csv, which has 2 columns: Strain, Stress");
}

}  // namespace
}  // namespace plastica::testing
