#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "tests/calibrate/engine/parse_engine_texts.hpp"
#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"

/// `plastica export` of beams that were fitted through scenes.
namespace plastica::testing {
namespace {

constexpr const char* kBar = R"([beam]
length = "400 mm"
segments = 6
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
[rules]
yield_model = "per_axis"
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = "end"
force = ["0 N", "-100 N", "0 N"]
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
)";

constexpr const char* kFit = R"([fit]
starts = 1
segments_error = false
[fit.parameters]
youngs_modulus = { bounds = ["50 GPa", "500 GPa"] }
material.density = { value = "2700 kg/m^3", fixed = true }
shear_yield_stress = { tie = "youngs_modulus", factor = 0.001 }
)";

constexpr const char* kTarget = R"([[target]]
files = "a.csv"
scene = "bar.toml"
abscissa = { drive = "load[1]", column = "Force" }
ordinate = { probe = "tip", column = "Displacement", factor = -1 }
beam = { segments = 8 }
)";

/// A folder with a fit through one scene, or two, of which the scene files are gone.
class ExportSceneFit : public ::testing::Test {
 protected:
  void fit(const std::string& text) const {
    place_.write("bar.toml", kBar);
    place_.write("long.toml", changed(kBar, "segments = 6", "segments = 4"));
    place_.write("a.csv", "Force (N),Displacement (mm)\n100,0.76\n200,1.53\n300,2.29\n");
    place_.write("fit.toml", text);
    const CommandResult result = place_.run({"calibrate", "fit.toml", "--quiet", "--force"});
    ASSERT_EQ(result.code, 0) << result.err;
    std::filesystem::remove(place_.path("bar.toml"));
    std::filesystem::remove(place_.path("long.toml"));
  }

  CommandResult beam(std::vector<std::string> more) const {
    more.insert(more.begin(), {"export", "fit.h5"});
    return place_.run(std::move(more));
  }

  Workplace place_;
};

TEST_F(ExportSceneFit, NeedsNoSceneFile) {
  fit(std::string(kFit) + kTarget);
  const CommandResult table = beam({"--what", "beam"});
  ASSERT_EQ(table.code, 0) << table.err;
  EXPECT_EQ(table.err, "");
  const ParsedBeam made = parse_csv(table.out);
  EXPECT_EQ(made.joints.size(), 8U);
  // F L^3/(3 w I)
  const double modulus = 100.0 * std::pow(0.4, 3) / (3.0 * 0.763e-3 * std::pow(0.02, 4) / 12.0);
  const double stiffness = modulus * std::pow(0.02, 4) / 12.0 / 0.05;
  EXPECT_NEAR(made.joints.at("joint_1").stiffness[0] / stiffness, 1.0, 0.02);
  // What the fit held and tied.
  EXPECT_NE(table.out.find("rho = 2700 kg/m^3"), std::string::npos);
  EXPECT_NE(table.out.find("material.density = 2700.0 kg/m^3, fixed"), std::string::npos);
  EXPECT_NE(table.out.find(", tied\n"), std::string::npos);
  EXPECT_NE(table.out.find("scene: bar.toml, as the fit has it"), std::string::npos);
}

TEST_F(ExportSceneFit, SaysInEachFormatWithHowManySegmentsTheFitWasMade) {
  fit(std::string(kFit) + kTarget);
  for (const char* format : {"csv", "mjcf", "agx", "chrono", "opensees"}) {
    SCOPED_TRACE(format);
    const CommandResult own = beam({"--what", "beam", "--to", format});
    EXPECT_NE(own.out.find("fitted with 8 segments"), std::string::npos) << own.out;
    EXPECT_EQ(own.err.find("warning"), std::string::npos) << own.err;
    const CommandResult other = beam({"--what", "beam", "--to", format, "--segments", "12"});
    EXPECT_NE(other.out.find("fitted with 8 segments"), std::string::npos) << other.out;
    EXPECT_TRUE(
        other.err.starts_with("warning: fit.h5: the fit was made with 8 segments, this "
                              "beam has 12: the numbers may be off\n"))
        << other.err;
  }
  // A scene file may be given as well, with segments of its own.
  place_.write("mine.toml", kBar);
  const CommandResult mine = beam({"--what", "beam", "--scene", "mine.toml"});
  EXPECT_EQ(parse_csv(mine.out).joints.size(), 6U);
  EXPECT_NE(mine.err.find("the fit was made with 8 segments, this beam has 6"), std::string::npos)
      << mine.err;
  EXPECT_EQ(mine.out.find("rho = 2700"), std::string::npos);
}

TEST_F(ExportSceneFit, TakesOneOfSeveralScenesByItsName) {
  fit(std::string(kFit) + kTarget +
      changed(changed(kTarget, "bar.toml", "long.toml"), "beam = { segments = 8 }\n", ""));
  const std::map<std::string, std::string> files{{"fit.h5", place_.read("fit.h5")}};
  expect_refusal({"",
                  files,
                  {"export", "fit.h5", "--to", "mjcf"},
                  "--scene: must be one of those that the fit went through: bar.toml (8 segments), "
                  "long.toml (4 segments)"});
  expect_refusal({"",
                  files,
                  {"export", "fit.h5", "--to", "mjcf", "--scene", "none.toml"},
                  "--scene = none.toml: is no file, nor a scene that the fit went through: "
                  "bar.toml (8 segments), long.toml (4 segments)"});
  const CommandResult one = beam({"--what", "beam", "--scene", "long.toml"});
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.err, "");
  EXPECT_EQ(parse_csv(one.out).joints.size(), 4U);
  EXPECT_NE(one.out.find("fitted with 4 segments"), std::string::npos);
  // It is what was fitted, whatever stands in a file of its name by now.
  place_.write("long.toml", kBar);
  EXPECT_EQ(beam({"--what", "beam", "--scene", "long.toml"}).out, one.out);
  const CommandResult file = beam({"--what", "beam", "--scene", "./long.toml"});
  EXPECT_EQ(parse_csv(file.out).joints.size(), 6U);
}

// The numbers of a fit hold with the law that each target's scene had, not with the first one's.
TEST_F(ExportSceneFit, ASceneKeepsTheLawThatItWasFittedWith) {
  place_.write("hard.toml", changed(kBar, "segments = 6", "segments = 4") +
                                "[material.hardening]\nlaw = \"linear\"\n"
                                "tangent_modulus = \"2 GPa\"\n");
  fit(std::string(kFit) + kTarget +
      changed(changed(kTarget, "bar.toml", "hard.toml"), "beam = { segments = 8 }\n", ""));
  EXPECT_EQ(beam({"--what", "beam", "--scene", "bar.toml"}).out.find("linear hardening"),
            std::string::npos);
  const std::string hard = beam({"--what", "beam", "--scene", "hard.toml"}).out;
  EXPECT_NE(hard.find("linear hardening"), std::string::npos) << hard;
  EXPECT_NE(hard.find("the fit's targets have several laws"), std::string::npos);
  const std::string targets = beam({"--what", "targets"}).out;
  EXPECT_NE(targets.find(",ideal,planar,"), std::string::npos) << targets;
  EXPECT_NE(targets.find(",linear,planar,"), std::string::npos) << targets;
}

TEST_F(ExportSceneFit, CannotChooseBetweenScenesOfOneName) {
  fit(std::string(kFit) + kTarget + changed(kTarget, "segments = 8", "segments = 4"));
  expect_refusal({"",
                  {{"fit.h5", place_.read("fit.h5")}},
                  {"export", "fit.h5", "--to", "mjcf", "--scene", "bar.toml"},
                  "--scene = bar.toml: is several in the fit; take a scene file: bar.toml (8 "
                  "segments), bar.toml (4 segments)"});
}

}  // namespace
}  // namespace plastica::testing
