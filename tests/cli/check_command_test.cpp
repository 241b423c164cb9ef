#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"
#include "tests/support/has.hpp"

namespace plastica::testing {
namespace {

/// The files of `plastica init check`: a sweep of a cantilever, and claims that hold.
class CheckCommand : public ::testing::Test {
 protected:
  CheckCommand() { place_.run({"init", "check"}); }
  /// Makes a claim of theirs fail.
  void make_one_fail() {
    place_.write("check.toml", changed(place_.read("check.toml"), "\"0.05 %\"", "\"0.01 %\""));
  }

  Workplace place_;
};

const std::string kFailure =
    "error 0.03047 % at beam.segments = 40, rules.end_rule = half_joint (tip, end -0.735525 m, "
    "reference -0.735301 m); wanted at most 0.01 %";

TEST_F(CheckCommand, NamesCaseNumberLimitAndLineOfAFailure) {
  make_one_fail();
  const CommandResult result = place_.run({"check", "check.toml"});
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(std::regex_search(
      result.out, std::regex("\n  FAIL  forty segments are within 0.05 %  +" +
                             std::regex_replace(kFailure, std::regex(R"([().])"), R"(\$&)") +
                             R"(; check\.toml:\d+\n)")))
      << result.out;
  EXPECT_TRUE(has(result.out, "\n2 of 3 claims hold, "));
}

TEST_F(CheckCommand, PrintsNothingWhereAllHoldAndItIsToBeQuiet) {
  const CommandResult held = place_.run({"check", "check.toml", "--quiet"});
  EXPECT_EQ(held.code, 0);
  EXPECT_EQ(held.out + held.err, "");
  make_one_fail();
  const CommandResult failed = place_.run({"check", "check.toml", "--quiet"});
  EXPECT_EQ(failed.code, 1);
  EXPECT_EQ(failed.err, "");
  EXPECT_EQ(lines_of(failed.out), 1U);
  EXPECT_TRUE(failed.out.starts_with("  FAIL  forty segments are within 0.05 %  " + kFailure))
      << failed.out;
}

TEST_F(CheckCommand, AnnotatesFailuresForGitHub) {
  EXPECT_FALSE(has(place_.run({"check", "check.toml", "--annotate", "github"}).out, "::error"));
  make_one_fail();
  const CommandResult result =
      place_.run({"check", "check.toml", "--quiet", "--annotate", "github"});
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(std::regex_search(
      result.out,
      std::regex(R"(\n::error file=check\.toml,line=\d+,title=forty segments are within 0\.05 %25)"
                 "::error 0.03047 %25 at beam.segments = 40, ")))
      << result.out;
}

TEST_F(CheckCommand, WritesTimesAndLinesForJUnit) {
  make_one_fail();
  EXPECT_EQ(place_.run({"check", "check.toml", "--junit", "out.xml"}).code, 1);
  const std::string xml = place_.read("out.xml");
  EXPECT_TRUE(has(xml, "<failure message=\"" + kFailure + "\">")) << xml;
  EXPECT_TRUE(std::regex_search(
      xml, std::regex("name=\"forty segments are within 0.05 %\" file=\"check.toml\" "
                      "line=\"\\d+\" time=\"\\d+\\.\\d{3}\"")))
      << xml;
}

TEST_F(CheckCommand, RefusesABadPageInOneLineBeforeAnythingRuns) {
  place_.write("there.html", "mine");
  const auto before = place_.contents();
  const auto refusal = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"check", "check.toml"};
    all.insert(all.end(), words.begin(), words.end());
    const CommandResult result = place_.run(all);
    EXPECT_EQ(result.code, 2) << result.out;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(place_.contents(), before);
    return result.err;
  };
  EXPECT_EQ(refusal({"--report", "page.txt"}),
            "plastica: --report = page.txt: must end in .html: it is a page\n");
  for (const std::string read : {"check.toml", "sweep.toml", "cantilever.toml"}) {
    EXPECT_EQ(refusal({"--report", read, "--force"}),
              "plastica: --report = " + read + ": is a file that this run reads\n");
  }
  EXPECT_EQ(refusal({"--junit", "new.html", "--report", "./new.html"}),
            "plastica: --report = ./new.html: is the output, too\n");
  EXPECT_EQ(refusal({"--report", "there.html"}),
            "plastica: there.html: exists already: use --force to overwrite it\n");
  EXPECT_TRUE(has(refusal({"--report", "none/page.html"}), "plastica: none/page.html: "));
  EXPECT_EQ(place_.run({"check", "check.toml", "--report", "there.html", "--force"}).code, 0);
  EXPECT_TRUE(has(place_.read("there.html"), "<!doctype html>"));
}

TEST_F(CheckCommand, WritesAPageOfClaimsThatDoNotHold) {
  make_one_fail();
  const CommandResult quiet =
      place_.run({"check", "check.toml", "--quiet", "--report", "page.html"});
  EXPECT_EQ(quiet.code, 1);
  EXPECT_EQ(quiet.err, "");
  EXPECT_TRUE(has(place_.read("page.html"), "\"does not hold\""));
}

TEST_F(CheckCommand, RefusesAnUnknownCi) {
  const CommandResult result = place_.run({"check", "check.toml", "--annotate", "gitlab"});
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(has(result.err, "--annotate: gitlab not in {github}")) << result.err;
}

}  // namespace
}  // namespace plastica::testing
