#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "calibrate/report/scene_fit_text.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "tests/calibrate/report/scene_records.hpp"
#include "tests/cli/bad_input.hpp"

/// What reads a file of fits through scenes.
namespace plastica::testing {
namespace {

using calibrate::SceneFitRecord;
namespace made_up = calibrate::testing;

std::vector<SceneFitRecord> records() {
  return {made_up::scene_record("a"), made_up::scene_record("b", 210e9, 390e6),
          made_up::failed_scene_record("f", "no curve at the start")};
}

void write_results(const Workplace& place) {
  calibrate::write_scene_fit_store(place.path("x.h5"), {records(), 0.9, {}, {}});
}

/// The bytes of such a file.
std::string result() {
  const Workplace place;
  write_results(place);
  return place.read("x.h5");
}

std::string shown(const Workplace& place, std::vector<std::string> arguments) {
  const CommandResult result = place.run(std::move(arguments));
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return result.out;
}

TEST(SceneFitResult, IsShownAsAWholeOrByFit) {
  const Workplace place;
  write_results(place);
  EXPECT_EQ(shown(place, {"show", "x.h5"}),
            calibrate::scene_fits_report(records(), {.confidence = 0.9}));
  EXPECT_EQ(shown(place, {"show", "x.h5", "--case", "b"}),
            calibrate::scene_fit_report(records()[1], {.confidence = 0.9}));
  const std::string all = shown(place, {"show", "x.h5", "--all"});
  EXPECT_TRUE(all.starts_with("a: fitted\n")) << all;
  EXPECT_NE(all.find("\nb: fitted\n"), std::string::npos);
  EXPECT_TRUE(all.ends_with("\nfitted 2, failed 1\n"));
}

TEST(SceneFitResult, IsExportedAsTablesAndJson) {
  const Workplace place;
  write_results(place);
  const std::string fits = shown(place, {"export", "x.h5"});
  EXPECT_TRUE(fits.starts_with("name,law,status,reason,degrees_of_freedom [1],outcome,")) << fits;
  EXPECT_EQ(lines_of(fits), 1U + 2U + 1U);
  EXPECT_EQ(lines_of(shown(place, {"export", "x.h5", "--what", "targets"})), 1U + 2U + 2U + 1U);
  EXPECT_EQ(lines_of(shown(place, {"export", "x.h5", "--what", "curves"})), 1U + 50U + 50U + 30U);
  const auto json = nlohmann::json::parse(shown(place, {"export", "x.h5", "--to", "json"}));
  EXPECT_EQ(json.at("counts").at("failed"), 1);
}

TEST(SceneFitResult, IsDrawnInEveryPicture) {
  const Workplace place;
  write_results(place);
  const std::string kinds = shown(place, {"plot", "--list", "x.h5"});
  for (const char* what : {"fit", "residuals", "starts", "correlation", "segments", "population"}) {
    EXPECT_NE(kinds.find(what), std::string::npos) << what;
    const std::string picture = std::string(what) + ".svg";
    EXPECT_EQ(shown(place, {"plot", "x.h5", "--what", what, "-o", picture}),
              "wrote " + picture + "\n");
    EXPECT_TRUE(place.read(picture).starts_with("<?xml")) << what;
    EXPECT_GT(lines_of(shown(place, {"plot", "x.h5", "--what", what})), 15U) << what;
  }
  EXPECT_NE(shown(place, {"plot", "x.h5", "--case", "b"}).find("210.0 ± 1.2 GPa"),
            std::string::npos);
}

TEST(SceneFitResult, GivesItsNumbersToTheBeamOfAScene) {
  const Workplace place;
  write_results(place);
  place.write("scene.toml",
              "[beam]\nlength = \"1 m\"\nsegments = 4\n"
              "section = { shape = \"rectangle\", width = \"20 mm\", height = \"20 mm\" }\n"
              "[[support]]\nat = \"start\"\nkind = \"clamp\"\n"
              "[[load]]\nat = \"end\"\nforce = [\"0 N\", \"-10 N\", \"0 N\"]\n");
  const CommandResult beam =
      place.run({"export", "x.h5", "--case", "b", "--scene", "scene.toml", "--to", "csv"});
  EXPECT_EQ(beam.code, 0) << beam.err;
  EXPECT_NE(beam.out.find("210"), std::string::npos) << beam.out;
  EXPECT_NE(beam.out.find("What the fit held fixed or tied is the scene's"), std::string::npos)
      << beam.out;
}

TEST(SceneFitResult, RefusesWhatDoesNotGoWithItInOneLine) {
  const std::map<std::string, std::string> files{{"x.h5", result()}};
  const std::vector<std::pair<std::vector<std::string>, std::string>> requests = {
      {{"show", "x.h5", "--case", "c"}, "x.h5: --case = c: must be a fit of the file: a, b, f"},
      {{"plot", "x.h5", "--case", "c"}, "--case = c: is not a fit of this file; it has a, b, f"},
      {{"plot", "x.h5", "--joint", "1"},
       "--joint: is for simulated scenes; this is a result of fits through scenes"},
      {{"export", "x.h5", "--what", "specimens"},
       "--what = specimens: must be fits or targets or curves of this file"},
      {{"export", "x.h5", "--to", "latex"},
       "--to latex: is for sweeps; this is a result of fits through scenes"},
      {{"export", "x.h5", "--to", "mjcf", "--case", "a"},
       "--scene: is missing: a fit knows the material; a scene file has the beam"}};
  for (const auto& [arguments, line] : requests) expect_refusal({"", files, arguments, line});
}

}  // namespace
}  // namespace plastica::testing
