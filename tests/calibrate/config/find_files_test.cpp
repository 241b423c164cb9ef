#include "calibrate/config/find_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace plastica::calibrate {
namespace {

class FindFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("find [a]*{x,y}_") + test->name() + std::to_string(getpid()));
    std::filesystem::create_directories(folder_ / "deep.csv");
    for (const char* name : {"b.csv", "a.csv", "c.txt", "deep.csv/d.csv"}) {
      std::ofstream(folder_ / name) << "1\n";
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::vector<std::string> names(const std::string& pattern) const {
    std::vector<std::string> found;
    for (const std::string& file : find_files(folder_.string(), pattern)) {
      found.push_back(std::filesystem::relative(file, folder_).string());
    }
    return found;
  }

  std::filesystem::path folder_;
};

using Names = std::vector<std::string>;

TEST_F(FindFiles, GivesFilesSortedByNameAndNoFolders) {
  EXPECT_EQ(names("*.csv"), (Names{"a.csv", "b.csv"}));
}

TEST_F(FindFiles, KnowsQuestionMarksSetsAndBraces) {
  EXPECT_EQ(names("?.[ct][sx]*"), (Names{"a.csv", "b.csv", "c.txt"}));
  EXPECT_EQ(names("{c.txt,a.csv,a.*}"), (Names{"a.csv", "c.txt"}));
  EXPECT_EQ(names("deep*/*.csv"), (Names{"deep.csv/d.csv"}));
}

TEST_F(FindFiles, GivesNothingIfNothingMatches) { EXPECT_TRUE(names("*.tsv").empty()); }

TEST_F(FindFiles, MatchesAnyNameToTheLetter) {
  const std::string name = "b{1,2}[x]*?\\.csv";
  std::ofstream(folder_ / name) << "1\n";
  EXPECT_EQ(names(literal_pattern(name)), Names{name});
}

TEST_F(FindFiles, LeavesAbsolutePatternsAlone) {
  EXPECT_EQ(find_files("elsewhere", "/dev/nul[l]*nothing"), Names{});
  EXPECT_EQ(find_files("elsewhere", PLASTICA_SOURCE_DIR "/LICENS?"),
            Names{PLASTICA_SOURCE_DIR "/LICENSE"});
}

}  // namespace
}  // namespace plastica::calibrate
