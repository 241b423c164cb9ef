#include <gtest/gtest.h>

#include <string>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"
#include "tests/support/has.hpp"

namespace plastica::testing {
namespace {

class StabilityCommand : public ::testing::Test {
 protected:
  StabilityCommand() {
    place_.run({"init", "sweep"});  // cantilever.toml
  }
  CommandResult scan(std::vector<std::string> words) {
    words.insert(words.begin(), {"stability", "cantilever.toml"});
    return place_.run(words);
  }
  std::string refusal(const std::vector<std::string>& words) {
    const auto before = place_.contents();
    const CommandResult result = scan(words);
    EXPECT_EQ(result.code, 2) << result.out;
    EXPECT_EQ(place_.contents(), before);
    return result.err;
  }

  Workplace place_;
};

TEST_F(StabilityCommand, SaysHowFarANumberMayGo) {
  const CommandResult result =
      scan({"--vary", "beam.segments", "--within", "1 %", "-o", "points.csv"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(has(result.out, "\n  own values  valid: ")) << result.out;
  EXPECT_TRUE(has(result.out, "below: at 6 inaccurate: tip: history is off a finer run"))
      << result.out;
  EXPECT_TRUE(has(result.out, "above: then a run would take more than 64 times the work\n"));
  EXPECT_TRUE(has(result.out, " 0 undetected errors\n"));
  EXPECT_EQ(result.err, "wrote points.csv\n");
  const std::string csv = place_.read("points.csv");
  EXPECT_TRUE(has(csv, "\ncantilever/own,cantilever,planar,statics,,,,,valid,")) << csv;
  EXPECT_TRUE(has(csv, "\ncantilever/beam.segments=6,")) << csv;
}

TEST_F(StabilityCommand, ReadsTheOldNameOfAnOption) {
  const CommandResult result = scan({"--vary", "beam.segments", "--within", "1 %", "-o",
                                     "points.csv", "--most-work=4", "--quiet"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "plastica: --most-work is now --max-work\n")) << result.err;
}

TEST_F(StabilityCommand, DrawsTheMapOfTwoFields) {
  EXPECT_EQ(
      scan({"--vary", "beam.segments,scale.loads", "--reach", "10", "--map", "map.gp", "--quiet"})
          .code,
      0);
  EXPECT_TRUE(has(place_.read("map.gp"), "set logscale x"));
}

TEST_F(StabilityCommand, EndsWithOneWhereTheSceneItselfIsNotValid) {
  place_.write("cantilever.toml",
               changed(place_.read("cantilever.toml"), "segments = 32", "segments = 2"));
  const CommandResult result = scan({"--vary", "beam.segments"});
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(has(result.out, "own values  inaccurate: ")) << result.out;
  EXPECT_TRUE(has(result.out, "plastica advise says how fine the scene must be"));
}

TEST_F(StabilityCommand, RefusesInOneLine) {
  EXPECT_EQ(refusal({"--vary", "rules.end_rule"}),
            "plastica: --vary = rules.end_rule: is a word, which has no factors\n");
  EXPECT_EQ(refusal({"--vary", "beam.length,beam.length"}),
            "plastica: --vary = beam.length: is named twice\n");
  EXPECT_EQ(refusal({"--vary", "beam.segments,beam.segment_depth"}),
            "plastica: --vary = beam.segment_depth: sets the same number as beam.segments\n");
  EXPECT_EQ(refusal({"--vary", "beam.length", "--within", "1"}),
            "plastica: --within = 1: needs a unit: \"1 %\"\n");
  EXPECT_EQ(refusal({"--vary", "beam.length", "--map", "map.svg"}),
            "plastica: --map = map.svg: is of two fields: name them by --vary\n");
  EXPECT_EQ(refusal({"--vary", "beam.length", "-o", "cantilever.toml", "--force"}),
            "plastica: --output = cantilever.toml: is a file that this run reads\n");
  EXPECT_EQ(refusal({"--vary", "beam.length", "--report", "page.txt"}),
            "plastica: --report = page.txt: must end in .html: it is a page\n");
  EXPECT_EQ(refusal({"--vary", "beam.length", "--report", "cantilever.toml", "--force"}),
            "plastica: --report = cantilever.toml: is a file that this run reads\n");
  EXPECT_TRUE(has(refusal({"--reach", "1"}), "--reach"));
  EXPECT_TRUE(has(refusal({"--vary", "beam.length", "-o", "-"}), "plastica: -: is no file"));
  EXPECT_TRUE(has(refusal({"--vary", "beam.length", "-o", "p.svg"}),
                  "plastica: --output = p.svg: must end in .csv: it has the points\n"));
  EXPECT_TRUE(has(refusal({"--vary", "beam.length,beam.segments", "--map", "map.jpg"}),
                  "plastica: --map = map.jpg: must end in"));
  EXPECT_TRUE(refusal({"--vary", "beam.lenght"})
                  .starts_with("plastica: --vary = beam.lenght: is not a field"));
}

}  // namespace
}  // namespace plastica::testing
