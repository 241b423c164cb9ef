#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

#include "tests/cli/command.hpp"

namespace plastica::testing {
namespace {

/// A shipped sweep, and what its user asks for.
struct Asked {
  std::string sweep;
  std::string within;
};

std::ostream& operator<<(std::ostream& out, const Asked& asked) { return out << asked.sweep; }

class Recommended : public ::testing::TestWithParam<Asked> {
 protected:
  /// A sweep of one case: the shipped one's error, of a scene that has its setting already.
  std::string one_case(const std::string& sweep, const std::string& scene) const {
    std::string text = place_.read(sweep);
    const std::size_t error = text.find("[error]");
    std::string rest = text.substr(error, text.find("[cost]") - error);
    return "scene = \"" + scene + "\"\n[[axis]]\nfield = \"solver.frames\"\nvalues = [1]\n" + rest;
  }
  /// Whether a fresh run of a scene is within what was asked for.
  bool meets(const std::string& scene) const {
    place_.write("one.toml", one_case("data/sweeps/" + GetParam().sweep + ".toml", scene));
    place_.write("check.toml",
                 "[[claim]]\nname = 'a'\nsweep = 'data/sweeps/one.toml'\nerror = { at_most = '" +
                     GetParam().within + "' }\n");
    std::filesystem::rename(place_.path("one.toml"), place_.path("data/sweeps/one.toml"));
    const CommandResult result = place_.run({"check", "check.toml"});
    EXPECT_LE(result.code, 1) << result.err;
    return result.code == 0;
  }

  Workplace place_;
};

TEST_P(Recommended, MeetsWhatWasAskedForAndTheNextCheaperDoesNot) {
  namespace fs = std::filesystem;
  const fs::path source = PLASTICA_SOURCE_DIR;
  for (const std::string folder :
       {"data/sweeps", "data/scenes", "tests/reference/w1-cantilever-history"}) {
    fs::create_directories(place_.path(folder));
    fs::copy(source / folder, place_.path(folder), fs::copy_options::recursive);
  }
  const std::string sweep = "data/sweeps/" + GetParam().sweep + ".toml";
  ASSERT_EQ(place_.run({"sweep", sweep, "--quiet", "-o", "out.h5"}).code, 0);
  const CommandResult result =
      place_.run({"recommend", "out.h5", "--within", GetParam().within, "--by", "work", "-o",
                  "data/sweeps/chosen.toml", "--next", "data/sweeps/next.toml"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(meets("chosen.toml")) << result.out;
  EXPECT_FALSE(meets("next.toml")) << result.out;
}

INSTANTIATE_TEST_SUITE_P(Sweeps, Recommended,
                         ::testing::Values(Asked{"cantilever_deflection", "0.1 %"},
                                           Asked{"cantilever_frequency", "0.2 %"},
                                           Asked{"clamp_moment", "1 %"}, Asked{"bend_45", "0.1 %"},
                                           Asked{"falling_cantilever_step", "1 %"}),
                         [](const auto& asked) { return asked.param.sweep; });

/// The robot's arm with other axes.
std::string arm_sweep(const std::string& axes) {
  return std::string("scene = '") + PLASTICA_SOURCE_DIR + "/data/scenes/robot_arm.toml'\n" + axes +
         "[error]\nprobe = 'gripper'\nagainst = 'finest'\n";
}

TEST(Recommend, RefusesWhereTheErrorOfAnAxisIsNotInTheNumbers) {
  const Workplace place;
  place.write("arm.toml",
              arm_sweep("[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8]\nzip = 'a'\n"
                        "[[axis]]\nfield = 'solver.time_step'\nvalues = ['1 ms', '2 ms']\n"
                        "zip = 'a'\n"));
  const CommandResult swept = place.run({"sweep", "arm.toml"});
  ASSERT_EQ(swept.code, 0) << swept.err;
  EXPECT_NE(swept.out.find("error of beam.segments alone; that of solver.time_step is not in it"),
            std::string::npos)
      << swept.out;
  const CommandResult result = place.run({"recommend", "arm.h5", "--within", "90 %"});
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.out,
            "nothing can be recommended: error of beam.segments alone; that of solver.time_step is "
            "not in it\n");
}

TEST(Recommend, SaysWhatIsNotRefined) {
  const Workplace place;
  place.write("arm.toml", arm_sweep("[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8, 16]\n"));
  ASSERT_EQ(place.run({"sweep", "arm.toml", "--quiet"}).code, 0);
  const CommandResult result = place.run({"recommend", "arm.h5", "--within", "50 %"});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.out.find(
                "note: the error of solver.time_step is not in it: it is not refined (0.001 s)\n"),
            std::string::npos)
      << result.out;
}

}  // namespace
}  // namespace plastica::testing
