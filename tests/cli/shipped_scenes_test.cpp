#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"

/// What users try first: the files of data/scenes, through the command.
namespace plastica::testing {
namespace {

const std::filesystem::path kData = std::filesystem::path(PLASTICA_SOURCE_DIR) / "data";

TEST(ShippedScenesCommand, RunEachToAnAnswer) {
  const Workplace place;
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kData / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const CommandResult result =
        place.run({"simulate", entry.path().string(), "-o", "out.h5", "--force"});
    EXPECT_EQ(result.code, 0) << entry.path() << "\n" << result.err;
    ++scenes;
  }
  EXPECT_GE(scenes, 42);
}

/// An IPE of this span tips out before its plastic moment: nobody is left to think that this is the
/// load of a real one, which warps.
TEST(ShippedScenesCommand, SayThatAnOpenSectionTipsOutLaterThanTorsionAlone) {
  const Workplace place;
  std::ifstream file(kData / "scenes/profile_limit_load.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  place.write("ipe.toml", changed(text, "section = \"HEB 200\"", "section = \"IPE 200\""));
  const CommandResult result = place.run({"simulate", "ipe.toml", "-o", "out.h5"});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.out.find("out of its plane"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("the beam leaves its plane, and its section is open"),
            std::string::npos)
      << result.out;
}

TEST(ShippedScenesCommand, AreAllInTheTableOfTheData) {
  std::ifstream file(kData / "README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const auto& entry : std::filesystem::directory_iterator(kData / "scenes")) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("report_")) continue;  // in rows of several
    EXPECT_NE(text.find("`" + name + "`"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace plastica::testing
