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

TEST_F(FindFiles, GivesLinksThatLeadNowhereSoThatTheyAreMissed) {
  std::filesystem::create_symlink("none", folder_ / "e.csv");
  std::filesystem::create_symlink("f.csv", folder_ / "f.csv");
  std::filesystem::create_symlink("a.csv", folder_ / "g.csv");
  std::filesystem::create_symlink("deep.csv", folder_ / "h.csv");
  std::vector<std::string> found = find_files(folder_.string(), "[e-h].csv");
  for (std::string& file : found) file = std::filesystem::path(file).filename().string();
  EXPECT_EQ(found, (Names{"e.csv", "f.csv", "g.csv"}));
}

TEST_F(FindFiles, RefusesBracesThatStandForTooMany) {
  std::string pairs;
  for (int i = 0; i < 13; ++i) pairs += "{a,b}";
  EXPECT_EQ(too_many_braces(pairs), "");
  EXPECT_NE(too_many_braces(pairs + "{a,b}").find("more than 10000 patterns"), std::string::npos);
  EXPECT_EQ(too_many_braces(pairs + "\\{a,b}"), "");
  EXPECT_EQ(too_many_braces(pairs + ",,,{a}"), "");
  std::string alternatives = "a";
  for (int i = 1; i < 100; ++i) alternatives += ",a";
  const std::string hundred = "{" + alternatives + "}";
  EXPECT_EQ(too_many_braces(hundred + hundred), "");
  EXPECT_NE(too_many_braces(hundred + hundred + "{a,b}"), "");
  EXPECT_NE(too_many_braces("{" + hundred + hundred + ",b}"), "");
  EXPECT_EQ(too_many_braces("{" + hundred + "," + hundred + "}"), "");
  EXPECT_NE(too_many_braces(std::string(200, '{') + std::string(200, '}')).find("100 braces"),
            std::string::npos);
  EXPECT_EQ(too_many_braces("}}},{"), "");
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
