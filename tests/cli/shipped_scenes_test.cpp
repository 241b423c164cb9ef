#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

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
