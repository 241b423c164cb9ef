#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/bad_input.hpp"
#include "tests/cli/curves.hpp"
#include "tests/cli/results.hpp"
#include "tests/support/has.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::testing {
namespace {

/// Simulates beam.toml into beam.h5. @return what the command said
CommandResult simulate_beam(const Workplace& place, const std::string& text = cantilever_text()) {
  place.write("beam.toml", text);
  CommandResult result = place.run({"simulate", "beam.toml", "-o", "beam.h5"});
  EXPECT_EQ(result.code, 0) << result.err;
  return result;
}

TEST(SceneResult, IsShownAsItWasPrinted) {
  const Workplace place;
  const CommandResult result = simulate_beam(place);
  EXPECT_EQ(result.err, "wrote beam.h5\n");
  EXPECT_TRUE(result.out.starts_with("beam: completed\n  level           planar: ")) << result.out;
  const CommandResult shown = place.run({"show", "beam.h5"});
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_EQ(shown.out, result.out);
}

TEST(SceneResult, OfTwoRunsDiffersInMetaAlone) {
  const Workplace place;
  for (const std::string& text : {cantilever_text(), cantilever_text("-600 N"), coupon_text()}) {
    simulate_beam(place, text);
    EXPECT_EQ(place.run({"simulate", "beam.toml", "-o", "again.h5", "--quiet", "--force"}).code, 0);
    expect_same_bits(place, {"beam.h5", "again.h5"});
    std::filesystem::remove(place.path("beam.h5"));
  }
}

TEST(SceneResult, ExportsTheTableThatSimulateWrites) {
  const Workplace place;
  simulate_beam(place);
  const CommandResult table = place.run({"simulate", "beam.toml"});
  EXPECT_EQ(table.code, 0);
  EXPECT_TRUE(table.out.starts_with("sample,time [s],factor [1],tip [m],root [N m]\n"))
      << table.out;
  EXPECT_TRUE(table.err.starts_with("beam: completed\n")) << table.err;
  EXPECT_EQ(place.run({"export", "beam.h5", "--to", "csv"}).out, table.out);
  EXPECT_EQ(place.run({"simulate", "beam.toml", "-o", "beam.csv"}).err, "wrote beam.csv\n");
  EXPECT_EQ(place.read("beam.csv"), table.out);
  const CommandResult joints = place.run({"export", "beam.h5", "--what", "joints"});
  EXPECT_EQ(joints.code, 0) << joints.err;
  EXPECT_EQ(lines_of(joints.out), 6U);
  EXPECT_EQ(joints.err, "");
  // Between two frames it says which one it is.
  const CommandResult between =
      place.run({"export", "beam.h5", "--what", "joints", "--time", "987 ms"});
  EXPECT_EQ(between.out, joints.out);
  EXPECT_TRUE(between.err.starts_with("the joints are those at 1 s, the frame next to 0.987 s"))
      << between.err;
}

TEST(SceneResult, HasASummaryForScripts) {
  const Workplace place;
  place.write("beam.toml", cantilever_text());
  const CommandResult result =
      place.run({"simulate", "beam.toml", "-o", "beam.h5", "--json", "beam.json", "--quiet"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out + result.err, "");
  const auto json = nlohmann::json::parse(place.read("beam.json"));
  EXPECT_EQ(json.at("status"), "completed");
  EXPECT_EQ(json.at("samples"), 6);
  EXPECT_EQ(nlohmann::json::parse(place.run({"export", "beam.h5", "--to", "json"}).out), json);
}

TEST(SceneResult, IsWrittenEvenWhereNoEquilibriumIsFound) {
  const Workplace place;
  std::string text = cantilever_text("-400 N");
  text.replace(text.find("steps = 5"), 9, "steps = 1\nmax_iterations = 1\nsmallest_step = 0.9");
  place.write("beam.toml", text);
  const CommandResult result = place.run({"simulate", "beam.toml", "-o", "beam.h5"});
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(result.out.starts_with("beam: not-converged\n  advice          take more steps"))
      << result.out;
  EXPECT_EQ(result.err,
            "wrote beam.h5\nplastica: not-converged: take more steps, or control = arc_length\n");
  EXPECT_EQ(place.run({"show", "beam.h5"}).out, result.out);
}

TEST(SceneResult, IsForetoldWithoutARun) {
  const Workplace place;
  place.write("beam.toml", cantilever_text());
  const auto before = place.contents();
  const CommandResult result = place.run({"simulate", "beam.toml", "--dry-run", "-o", "beam.h5"});
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(has(result.out, "beam.toml: level planar: ")) << result.out;
  EXPECT_TRUE(has(result.out, "4 segments, 1 support, 1 load, 6 samples, 2 probes")) << result.out;
  EXPECT_TRUE(has(result.out, "nothing was run; the result would be beam.h5\n")) << result.out;
  EXPECT_EQ(place.contents(), before);
}

TEST(SceneResult, IsDrawnAsEachPictureThatItHas) {
  const Workplace place;
  simulate_beam(place);
  const CommandResult listed = place.run({"plot", "beam.h5", "--list"});
  EXPECT_EQ(listed.code, 0) << listed.err;
  for (const std::string what : {"shape", "film", "moment", "joint", "load", "history", "energy"}) {
    EXPECT_TRUE(has("\n" + listed.out, "\n" + what + " ")) << listed.out;
    const CommandResult drawn = place.run({"plot", "beam.h5", "--what", what, "-o", what + ".svg"});
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_EQ(drawn.out, "wrote " + what + ".svg\n");
    EXPECT_TRUE(has(place.read(what + ".svg"), "</svg>")) << what;
    EXPECT_GT(lines_of(place.run({"plot", "beam.h5", "--what", what}).out), 15U) << what;
  }
  EXPECT_EQ(place.run({"plot", "beam.h5", "-o", "again.svg"}).code, 0);
  EXPECT_EQ(place.read("again.svg"), place.read("shape.svg"));
  EXPECT_EQ(place.run({"plot", "beam.h5", "beam.h5", "--what", "moment"}).code, 0);
}

TEST(BadSceneRequest, IsRefusedInOneLine) {
  Workplace place;
  simulate_beam(place);
  const std::map<std::string, std::string> files{{"x.h5", place.read("beam.h5")},
                                                 {"beam.toml", cantilever_text()}};
  const std::vector<std::pair<std::vector<std::string>, std::string>> requests = {
      {{"show", "x.h5", "--case", "a"},
       "--case: is for results of fits and sweeps; this is a simulated scene"},
      {{"show", "x.h5", "--all"},
       "--all: is for results of fits and sweeps; this is a simulated scene"},
      {{"export", "x.h5", "--what", "curves"},
       "--what = curves: must be probes or joints or energies or events or fragments or spectrum "
       "of "
       "this "
       "file"},
      {{"export", "x.h5", "--time", "1 s"}, "--time: goes with --what joints only"},
      {{"export", "x.h5", "--what", "spectrum"},
       "--what = spectrum: needs a motion of at least 16 samples at even times"},
      {{"plot", "x.h5", "--time", "1 m"},
       "--time = 1 m: \"m\" is not a unit of time (examples: s, min, h)"},
      {{"plot", "x.h5", "--what", "film", "--from", "0.8 s", "--to", "0.5 s"},
       "--to = 0.5 s: must not be before --from 0.8 s"},
      {{"plot", "x.h5", "--what", "curve"},
       "--what = curve: must be one of shape, film, moment, joint, load, history, energy for this "
       "file"},
      {{"plot", "x.h5", "--case", "a"},
       "--case: is for results of fits and sweeps; this is a simulated scene"},
      {{"plot", "x.h5", "--what", "joint", "--joint", "7"}, "--joint = 7: must be from 0 to 4"},
      {{"plot", "x.h5", "-o", "x.h5", "--force"}, "--output = x.h5: is a file that this run reads"},
      {{"simulate", "beam.toml", "-o", "x.h5"},
       "x.h5: exists already: use --force to overwrite it"},
      {{"simulate", "beam.toml", "-o", "beam.toml", "--force"},
       "--output = beam.toml: is a file that this run reads"},
      {{"simulate", "beam.toml", "-o", "beam.txt"},
       "--output = beam.txt: must end in .h5 or .csv, or be -"},
      {{"simulate", "beam.toml", "-o", "y.h5", "--json", "beam.toml", "--force"},
       "--json = beam.toml: is a file that this run reads"},
      {{"simulate", "beam.toml", "-o", "y.csv", "--json", "./y.csv"},
       "--json = ./y.csv: is the output, too"},
      {{"simulate", "beam.toml", "-o", "none/y.h5"},
       "none/y.h5: cannot be written: there is no folder none"}};
  for (const auto& [arguments, line] : requests) {
    SCOPED_TRACE(line);
    expect_refusal({"", files, arguments, line});
  }
}

}  // namespace
}  // namespace plastica::testing
