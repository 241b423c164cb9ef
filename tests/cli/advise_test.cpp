#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/command.hpp"

namespace plastica::testing {
namespace {

class Advise : public ::testing::Test {
 protected:
  const std::string scene_ = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/cantilever.toml";
  Workplace place_;
};

TEST_F(Advise, WritesTheSceneWithWhatItAdvises) {
  const CommandResult advised =
      place_.run({"advise", scene_, "--within", "1 %", "-o", "advised.toml"});
  ASSERT_EQ(advised.code, 0) << advised.err;
  EXPECT_NE(advised.out.find("cantilever.toml, within 1 %:"), std::string::npos) << advised.out;
  EXPECT_NE(advised.out.find("the file's own: "), std::string::npos);
  EXPECT_NE(place_.read("advised.toml"), place_.read(scene_));
  // What it wrote is within the error by itself.
  const CommandResult again = place_.run({"advise", "advised.toml", "--within", "1 %"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(place_.run({"simulate", "advised.toml", "-o", "advised.h5"}).code, 0);
}

TEST_F(Advise, WritesTheWordsThatItChooses) {
  // A quarter of a metre deep: shear is 0.3 % of the tip's displacement.
  std::string text = place_.read(scene_);
  const std::string size = "\"20 mm\"";
  for (std::size_t at = text.find(size); at != std::string::npos; at = text.find(size)) {
    text.replace(at, size.size(), "\"250 mm\"");
  }
  place_.write("stocky.toml", text);
  const CommandResult advised =
      place_.run({"advise", "stocky.toml", "--within", "0.2 %", "-o", "advised.toml", "--json",
                  "advice.json", "--plot", "advice.svg"});
  ASSERT_EQ(advised.code, 0) << advised.err;
  EXPECT_NE(advised.out.find("rigid would be "), std::string::npos) << advised.out;
  EXPECT_NE(place_.read("advised.toml").find("translation = \"elastic\""), std::string::npos);
  EXPECT_NE(place_.read("advice.json").find("\"word\": \"elastic\""), std::string::npos);
  EXPECT_NE(place_.read("advice.svg").find("Pareto front"), std::string::npos);
}

TEST_F(Advise, SaysWhereTheSceneHasWhatItRefuses) {
  place_.write("loose.toml", place_.read(scene_) + "[solver]\ntolerance = 1e-3\n");
  const std::string text = place_.read("loose.toml");
  const auto line = std::ranges::count(text, '\n');
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"advise", "loose.toml", "--within", "1 %"},
        std::vector<std::string>{"stability", "loose.toml"}}) {
    const CommandResult result = place_.run(words);
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(result.err.starts_with("plastica: loose.toml:" + std::to_string(line) +
                                       ": solver.tolerance = 0.001: must be at most 1e-6"))
        << result.err;
  }
}

TEST_F(Advise, WritesGradedSegments) {
  const std::string scene = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/bend_test.toml";
  const CommandResult advised = place_.run(
      {"advise", scene, "--within", "1 %", "-o", "graded.toml", "--json", "graded.json"});
  ASSERT_EQ(advised.code, 0) << advised.err;
  EXPECT_NE(advised.out.find("  beam.segment_lengths: graded, from "), std::string::npos)
      << advised.out;
  EXPECT_NE(place_.read("graded.toml").find("segment_lengths = [0."), std::string::npos);
  EXPECT_NE(place_.read("graded.json").find("\"segment_fractions\": ["), std::string::npos);
  EXPECT_EQ(place_.run({"simulate", "graded.toml", "-o", "graded.h5"}).code, 0);
  // Its segments are given now.
  const CommandResult again = place_.run({"advise", "graded.toml", "--within", "1 %"});
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.err.find("beam.segment_lengths: fixes the segments"), std::string::npos)
      << again.err;
}

TEST_F(Advise, WritesStepsWithoutTheirRounding) {
  const std::string arm = std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/robot_arm.toml";
  ASSERT_EQ(place_.run({"advise", arm, "--within", "1 %", "-o", "arm.toml"}).code, 0);
  const std::string text = place_.read("arm.toml");
  const std::size_t step = text.find("time_step = ");
  ASSERT_NE(step, std::string::npos);
  // Twelve digits, a point, an exponent.
  EXPECT_LE(text.substr(step + 12, text.find(" s", step) - step - 12).size(), 19) << text;
}

TEST_F(Advise, TakesABudgetOfTime) {
  const CommandResult advised = place_.run({"advise", scene_, "--budget", "20 ms"});
  ASSERT_EQ(advised.code, 0) << advised.err;
  EXPECT_NE(advised.out.find("cantilever.toml, for 20 ms:"), std::string::npos) << advised.out;
  const CommandResult none = place_.run({"advise", scene_, "--budget", "1 ns"});
  EXPECT_EQ(none.code, 1) << none.out;
}

/// The shipped arm of a robot, which moves.
std::string arm() { return std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/robot_arm.toml"; }

TEST_F(Advise, WritesTheBeamForMujoco) {
  const CommandResult advised = place_.run({"advise", arm(), "--within", "2 %", "--for", "mujoco",
                                            "-o", "beam.xml", "--json", "advice.json"});
  ASSERT_EQ(advised.code, 0) << advised.err;
  EXPECT_NE(advised.out.find("robot_arm.toml for mujoco, within 2 %:\n  segments         = "),
            std::string::npos)
      << advised.out;
  EXPECT_NE(advised.err.find("the step is 0.004 s, as advised"), std::string::npos) << advised.err;
  const std::string beam = place_.read("beam.xml");
  EXPECT_NE(beam.find("<option timestep=\"0.004\" integrator=\"Euler\""), std::string::npos);
  EXPECT_NE(beam.find("Note: segments and step are advised for gripper"), std::string::npos);
  EXPECT_NE(place_.read("advice.json").find("\"engine\": \"mujoco\""), std::string::npos);
  // It does not write over what is there.
  EXPECT_EQ(
      place_.run({"advise", arm(), "--within", "2 %", "--for", "mujoco", "-o", "beam.xml"}).code,
      2);
}

TEST_F(Advise, TakesMoreRunsByMujocosRuleThanOfOurs) {
  const CommandResult advised =
      place_.run({"advise", arm(), "--within", "0.5 %", "--for", "mujoco", "--max-runs", "18"});
  EXPECT_EQ(advised.code, 0) << advised.err;
  EXPECT_NE(advised.out.find("the advice took 18 runs of ours and "), std::string::npos)
      << advised.out;
}

TEST_F(Advise, SaysWhereItFindsNothingForMujoco) {
  const CommandResult none = place_.run({"advise", arm(), "--within", "0.5 %", "--for", "mujoco",
                                         "--max-runs", "8", "-o", "beam.xml"});
  EXPECT_EQ(none.code, 1) << none.out;
  EXPECT_NE(none.out.find("robot_arm.toml for mujoco: nothing within 0.5 %: "), std::string::npos)
      << none.out;
  EXPECT_FALSE(place_.has("beam.xml"));
}

TEST_F(Advise, WritesTheBeamForChronoAndSaysThatItWasNotRunThere) {
  const CommandResult advised = place_.run({"advise", arm(), "--within", "5 %", "--for", "chrono",
                                            "-o", "beam.hpp", "--json", "advice.json"});
  ASSERT_EQ(advised.code, 0) << advised.err;
  constexpr std::string_view kNotRun = "which was not verified in Chrono itself";
  for (const std::string& text :
       {advised.out, place_.read("beam.hpp"), place_.read("advice.json")}) {
    EXPECT_NE(text.find(kNotRun), std::string::npos) << text;
  }
  EXPECT_NE(advised.out.find("robot_arm.toml for chrono, within 5 %:\n"), std::string::npos)
      << advised.out;
  const std::string beam = place_.read("beam.hpp");
  EXPECT_NE(beam.find("Note: segments and step are advised for gripper"), std::string::npos);
  EXPECT_NE(beam.find("\nconstexpr double kTimeStep = "), std::string::npos);
  EXPECT_NE(place_.read("advice.json").find("\"rule_held_against\": null"), std::string::npos);
  const CommandResult help = place_.run({"advise", "--help"});
  EXPECT_NE(help.out.find("verified in Chrono)"), std::string::npos) << help.out;
}

TEST_F(Advise, RefusesForMujocoInOneLine) {
  const auto refusal = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"advise", arm()});
    const CommandResult result = place_.run(words);
    EXPECT_EQ(result.code, 2) << result.out;
    return result.err;
  };
  EXPECT_EQ(
      refusal({"--within", "1 %", "--for", "mujco"}),
      "plastica: --for = mujco: must be one of mujoco, bullet, chrono; did you mean mujoco?\n");
  EXPECT_EQ(refusal({"--within", "1 %", "--for", "mujoco", "-o", "advised.toml"}),
            "plastica: -o = advised.toml: must end in .xml: with --for mujoco it is the beam\n");
  EXPECT_EQ(refusal({"--within", "1 %", "--for", "chrono", "-o", "beam.xml"}),
            "plastica: -o = beam.xml: must end in .hpp: with --for chrono it is the beam\n");
  EXPECT_EQ(refusal({"--within", "1 %", "--for", "chrono", "--plot", "a.svg"}),
            "plastica: --plot: does not go with --for\n");
  EXPECT_EQ(refusal({"--budget", "2 ms", "--for", "chrono"}),
            "plastica: --budget: does not go with --for: what a step takes is the engine's "
            "affair\n");
  EXPECT_EQ(refusal({"--budget", "2 ms", "--for", "mujoco"}),
            "plastica: --budget: does not go with --for: what a step takes is the engine's "
            "affair\n");
  EXPECT_EQ(refusal({"--within", "1 %", "--for", "mujoco", "--plot", "a.svg"}),
            "plastica: --plot: does not go with --for\n");
  EXPECT_EQ(refusal({"--for", "mujoco"}), "plastica: advise: needs one of --within and --budget\n");
  const CommandResult rests = place_.run({"advise", scene_, "--within", "1 %", "--for", "mujoco"});
  EXPECT_EQ(rests.code, 2);
  EXPECT_EQ(rests.err,
            "plastica: solver.analysis: must be \"dynamics\" with --for: it advises the step of a "
            "motion\n");
}

TEST_F(Advise, RefusesInOneLine) {
  const auto refusal = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"advise", scene_});
    const CommandResult result = place_.run(words);
    EXPECT_EQ(result.code, 2) << result.out;
    return result.err;
  };
  EXPECT_EQ(refusal({"--within", "1"}), "plastica: --within = 1: needs a unit: \"1 %\"\n");
  EXPECT_EQ(refusal({"--within", "100 %"}), "plastica: --within = 100 %: must be below 100 %\n");
  EXPECT_EQ(refusal({"--within", "1 %", "--of", "top"}),
            "plastica: --of = top: is no probe of the scene\n");
  EXPECT_NE(refusal({"--within", "1 %", "-o", scene_}).find("-o"), std::string::npos);
  EXPECT_EQ(refusal({}), "plastica: advise: needs one of --within and --budget\n");
  EXPECT_EQ(refusal({"--within", "1 %", "--budget", "2 ms"}),
            "plastica: advise: needs one of --within and --budget\n");
  EXPECT_EQ(refusal({"--budget", "0 s"}), "plastica: --budget = 0 s: must be above 0 s\n");
  EXPECT_EQ(refusal({"--within", "1 %", "--plot", "a.txt"}),
            "plastica: --plot = a.txt: must end in .svg, .png, .pdf or .gp, or be -\n");
  EXPECT_EQ(refusal({"--within", "1 %", "-o", "a.h5"}),
            "plastica: -o = a.h5: must end in .toml: it is the scene\n");
  EXPECT_EQ(refusal({"--within", "1 %", "--json", "-"}),
            "plastica: -: is no file: standard output is not taken here\n");
  EXPECT_NE(refusal({"--within", "1 %", "--json", "a.svg", "--plot", "a.svg"}).find("--plot"),
            std::string::npos);
}

}  // namespace
}  // namespace plastica::testing
