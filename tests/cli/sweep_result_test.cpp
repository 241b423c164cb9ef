#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/command.hpp"
#include "tests/support/has.hpp"

namespace plastica::testing {
namespace {

/// The sweep that `plastica init sweep` writes, run.
class SweepResult : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(place_.run({"init", "sweep"}).code, 0);
    ran_ = place_.run({"sweep", "sweep.toml", "--json", "sweep.json"});
    ASSERT_EQ(ran_.code, 0) << ran_.err;
  }

  std::string output_of(std::vector<std::string> arguments) const {
    const CommandResult result = place_.run(std::move(arguments));
    EXPECT_EQ(result.code, 0) << result.err;
    return result.out;
  }

  Workplace place_;
  CommandResult ran_;
};

/// Each case ran, and none has a value that is an answer.
TEST(SweepOfFits, EndsWithOneWhereNoFitIsAnAnswer) {
  const Workplace place;
  const std::string data = std::string(PLASTICA_SOURCE_DIR) + "/data/";
  place.write("sweep.toml",
              "scene = '" + data +
                  "scenes/bend_test.toml'\n[set]\nsolver.steps = 40\n"
                  "rules.yield_model = 'interaction'\n[[axis]]\nfield = 'beam.segments'\n"
                  "values = [4]\n[error]\nquantity = 'fit'\nparameter = 'material.yield_stress'\n"
                  "[fit]\ntarget = '" +
                  data +
                  "targets/bend_test.csv'\n"
                  "abscissa = { probe = 'displacement', column = 'Displacement', factor = -1 }\n"
                  "ordinate = { probe = 'force', column = 'Force', factor = -1 }\n"
                  "parameters.yield_stress = { bounds = ['100 MPa', '300 MPa'] }\n");
  const CommandResult result = place.run({"sweep", "sweep.toml"});
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_TRUE(has(result.out, "yield_stress ended at its bound")) << result.out;
}

TEST_F(SweepResult, IsShownAsItWasReported) {
  EXPECT_EQ(output_of({"show", "sweep.h5"}), ran_.out);
  EXPECT_EQ(output_of({"show", "sweep.h5", "--all"}), ran_.out);
}

TEST_F(SweepResult, ShowsOneCaseByItsIdOrItsValues) {
  const auto rows = nlohmann::json::parse(place_.read("sweep.json"))["cases"];
  const std::string id = rows[1]["id"];
  const std::string shown = output_of({"show", "sweep.h5", "--case", id});
  EXPECT_TRUE(shown.starts_with("case " + id + " of sweep\n")) << shown;
  const std::string by_value = output_of({"show", "sweep.h5", "--case", "beam.segments = 10"});
  EXPECT_TRUE(has(by_value, "segments              10\n")) << by_value;
}

TEST_F(SweepResult, ExportsItsCasesAsCsvAndItsTableForDocuments) {
  const auto rows = nlohmann::json::parse(place_.read("sweep.json"))["cases"];
  const std::string csv = output_of({"export", "sweep.h5"});
  EXPECT_EQ(lines_of(csv), rows.size() + 1);
  EXPECT_TRUE(csv.starts_with("case,beam.segments,")) << csv;
  EXPECT_EQ(output_of({"export", "sweep.h5", "--what", "cases"}), csv);
  EXPECT_TRUE(has(output_of({"export", "sweep.h5", "--to", "markdown"}), "| --: | --: |"));
  EXPECT_TRUE(has(output_of({"export", "sweep.h5", "--to", "latex"}), "\\end{tabular}\n"));
}

TEST_F(SweepResult, ExportsTheJsonThatSweepWrites) {
  EXPECT_EQ(output_of({"export", "sweep.h5", "--to", "json"}), place_.read("sweep.json"));
}

TEST_F(SweepResult, IsDrawnAsEachPictureThatItHas) {
  const std::string listed = output_of({"plot", "sweep.h5", "--list"});
  for (const std::string what : {"convergence", "value", "trade"}) {
    EXPECT_TRUE(has("\n" + listed, "\n" + what + " ")) << listed;
    EXPECT_EQ(output_of({"plot", "sweep.h5", "--what", what, "-o", what + ".svg"}),
              "wrote " + what + ".svg\n");
    EXPECT_TRUE(has(place_.read(what + ".svg"), "</svg>")) << what;
    EXPECT_GT(lines_of(output_of({"plot", "sweep.h5", "--what", what})), 15U) << what;
  }
  output_of({"plot", "sweep.h5", "-o", "again.svg"});
  EXPECT_EQ(place_.read("again.svg"), place_.read("convergence.svg"));
  output_of({"plot", "sweep.h5", "--case", "end_rule = equal", "-o", "equal.png"});
  EXPECT_TRUE(place_.read("equal.png").starts_with("\x89PNG"));
}

TEST_F(SweepResult, IsDrawnAsAMapWithPanels) {
  place_.write("grid.toml", changed(place_.read("sweep.toml"), "[error]",
                                    "[[axis]]\nfield = \"scale.loads\"\nvalues = [1, 4]\n[error]"));
  ASSERT_EQ(place_.run({"sweep", "grid.toml", "--quiet"}).code, 0);
  output_of({"plot", "grid.h5", "--what", "map", "-o", "map.svg"});
  EXPECT_TRUE(has(place_.read("map.svg"), "half_joint"));
  EXPECT_GT(lines_of(output_of({"plot", "grid.h5", "--what", "map"})), 30U);
}

TEST_F(SweepResult, RefusesRequestsInOneLine) {
  const std::map<std::string, std::string> files{
      {"x.h5", place_.read("sweep.h5")},
      {"sweep.toml", place_.read("sweep.toml")},
      {"cantilever.toml", place_.read("cantilever.toml")}};
  const std::vector<std::pair<std::vector<std::string>, std::string>> requests = {
      {{"show", "x.h5", "--case", "xyz"},
       "--case = xyz: must be the id of a case of this sweep, as export has it, or AXIS = …"},
      {{"export", "x.h5", "--time", "1 s"}, "--time: is for simulated scenes; this is a sweep"},
      {{"export", "x.h5", "--what", "joints"},
       "--what = joints: must be cases or curves of this file"},
      {{"export", "x.h5", "--what", "curves"},
       "--what = curves: needs a sweep with error.take = \"curve\""},
      {{"export", "x.h5", "--to", "json", "--what", "cases"}, "--what: goes with --to csv"},
      {{"plot", "x.h5", "--what", "film"},
       "--what = film: must be one of convergence, value, trade for this file"},
      {{"plot", "x.h5", "x.h5"}, "plot = x.h5: must not be there: a sweep is drawn of one file"},
      {{"plot", "x.h5", "--joint", "1"}, "--joint: is for simulated scenes; this is a sweep"},
      {{"sweep", "sweep.toml", "-o", "y.csv"},
       "--output = y.csv: is written as HDF5: must end in .h5; plastica export and plot make other "
       "files of it"},
      {{"sweep", "sweep.toml", "-o", "y.h5", "--json", "./y.h5"},
       "--json = ./y.h5: is the output, too"},
      {{"sweep", "sweep.toml", "-o", "y.h5", "--json", "cantilever.toml", "--force"},
       "--json = cantilever.toml: is a file that this run reads"},
      {{"sweep", "sweep.toml", "-o", "cantilever.toml", "--force"},
       "--output = cantilever.toml: is a file that this run reads"}};
  for (const auto& [arguments, line] : requests) {
    SCOPED_TRACE(line);
    expect_refusal({"", files, arguments, line});
  }
}

}  // namespace
}  // namespace plastica::testing
