#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/report/csv_export.hpp"
#include "calibrate/report/json.hpp"
#include "tests/calibrate/report/scene_records.hpp"

/// JSON and CSV of fits through scenes.
namespace plastica::calibrate {
namespace {

using Json = nlohmann::json;
using testing::failed_scene_record;
using testing::lone_scene_record;
using testing::scene_record;

std::vector<std::vector<std::string>> rows_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line + ",");
    std::vector<std::string>& row = rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

/// A table of fits, whose columns have names.
struct Table {
  std::vector<std::vector<std::string>> rows;

  using Write = void (*)(std::ostream&, std::span<const SceneFitRecord>);
  Table(Write write, const std::vector<SceneFitRecord>& records) {
    std::ostringstream out;
    write(out, records);
    rows = rows_of(out.str());
  }
  std::size_t column(const std::string& title) const {
    return static_cast<std::size_t>(std::ranges::find(rows[0], title) - rows[0].begin());
  }
  /// The first row of data is 1.
  const std::string& at(std::size_t row, const std::string& title) const {
    return rows.at(row).at(column(title));
  }
};

TEST(SceneFitJson, HoldsParametersTargetsStartsAndCounts) {
  const Json all = Json::parse(
      json_summary(std::vector{scene_record(), failed_scene_record("f", "no curve at the start")}));
  const Json& fit = all["fits"][0];
  EXPECT_EQ(fit["name"], "both");
  EXPECT_EQ(fit["parameters"]["youngs_modulus"]["value"], 205e9);
  EXPECT_EQ(fit["parameters"]["youngs_modulus"]["unit"], "Pa");
  EXPECT_EQ(fit["parameters"]["break_strain"]["verdict"], "limited by sampling");
  EXPECT_EQ(fit["parameters"]["break_strain"]["path"], "material.break_strain");
  EXPECT_EQ(fit["correlation"]["matrix"][0][1], -0.42);
  EXPECT_EQ(fit["targets"][0]["abscissa"], "support 2");
  EXPECT_EQ(fit["targets"][0]["break_at"], 0.0605);
  EXPECT_EQ(fit["targets"][1]["level"], "twist");
  EXPECT_TRUE(fit["targets"][1]["break_at"].is_null());
  EXPECT_TRUE(fit["targets"][1]["runs_test_p"].is_null());
  EXPECT_EQ(fit["starts"].size(), 4U);
  EXPECT_TRUE(fit["starts"][1]["cost"].is_null()) << "infinite";
  EXPECT_EQ(all["fits"][1]["reason"], "no curve at the start");
  EXPECT_TRUE(all["fits"][1]["targets"][0]["level"].is_null());
  EXPECT_EQ(all["counts"], (Json{{"fitted", 1}, {"failed", 1}, {"unusable", 0}}));
}

TEST(SceneFitJson, HoldsThePopulation) {
  const Json all = Json::parse(json_summary(std::vector{lone_scene_record("a", 200e9, 380e6),
                                                        lone_scene_record("b", 210e9, 390e6),
                                                        lone_scene_record("c", 205e9, 370e6)}));
  const Json& modulus = all["population"]["parameters"]["youngs_modulus"];
  EXPECT_EQ(modulus["n"], 3);
  EXPECT_NEAR(modulus["mean"], 205e9, 1.0);
  EXPECT_NEAR(modulus["specimen_deviation"], 1e9 * std::sqrt(25.0 - 1.44), 1e3);
  EXPECT_EQ(all["population"]["specimen_covariance"].size(), 2U);
}

TEST(SceneFitJson, SaysWhatTheSegmentsDo) {
  SceneFitRecord record = scene_record();
  const auto fit_of = [&] { return Json::parse(json_summary(std::vector{record}))["fits"][0]; };
  const Json segments = fit_of()["segments"];
  EXPECT_EQ(segments["segments"], 32);
  EXPECT_TRUE(segments["note"].is_null());
  EXPECT_EQ(segments["parameters"]["youngs_modulus"]["trend"], "monotone");
  EXPECT_EQ(segments["parameters"]["yield_stress"]["error"], 3.0 * 0.04 * 380e6);
  EXPECT_TRUE(segments["parameters"]["break_strain"]["error"].is_null());
  EXPECT_EQ(fit_of()["parameters"]["break_strain"]["sampling_error"], 3.9e-4);
  EXPECT_EQ(fit_of()["parameters"]["break_strain"]["misfit_error"], 2e-4);
  record.result.segments.reset();
  EXPECT_TRUE(fit_of()["segments"].is_null());
}

TEST(SceneFitJson, SaysWhatWasMendedInEachTarget) {
  SceneFitRecord record = scene_record();
  record.targets[1].repairs = {{"nan-rows", 3, "3 rows dropped"}};
  const Json targets = Json::parse(json_summary(std::vector{record}))["fits"][0]["targets"];
  EXPECT_TRUE(targets[0]["repairs"].empty());
  EXPECT_EQ(targets[1]["repairs"],
            (Json{{{"kind", "nan-rows"}, {"count", 3}, {"text", "3 rows dropped"}}}));
}

TEST(SceneFitJson, IsWholeWhateverTheUsersText) {
  SceneFitRecord record = scene_record("\xff\"\n");
  record.result.warnings = {"\xc3"};
  EXPECT_EQ(Json::parse(json_summary(std::vector{record}))["counts"]["fitted"], 1);
}

TEST(SceneFitCsv, HasARowPerFitWithAllParametersThatAnyHas) {
  const Table table(write_fits_csv, {lone_scene_record("a", 2e11, 3e8), scene_record("b"),
                                     failed_scene_record("f", "no")});
  const SegmentsError record_of_a =
      lone_scene_record("a", 2e11, 3e8).result.segments->parameters[0];
  ASSERT_EQ(table.rows.size(), 4U);
  constexpr std::size_t kEach = 20;
  const std::size_t modulus = table.column("fit.youngs_modulus [Pa]");
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), modulus + 3U * kEach);
  EXPECT_EQ(table.at(1, "law"), "ideal");
  EXPECT_EQ(table.at(1, "usable"), "1");
  EXPECT_EQ(table.rows[1][modulus], "200000000000");
  EXPECT_EQ(std::stod(table.at(1, "fit.youngs_modulus.extrapolated [Pa]")),
            record_of_a.extrapolated);
  EXPECT_EQ(std::stod(table.at(1, "fit.youngs_modulus.segments_error [Pa]")), record_of_a.error);
  EXPECT_EQ(table.at(1, "fit.youngs_modulus.degrees_of_freedom [1]"), "28.8");
  EXPECT_EQ(table.at(1, "fit.youngs_modulus.verdict"), "identified");
  EXPECT_EQ(table.at(1, "fit.break_strain [1]"), "");
  EXPECT_EQ(table.at(1, "fit.break_strain.verdict"), "");
  EXPECT_EQ(table.at(2, "fit.break_strain.standard_error [1]"), "0.0004");
  EXPECT_EQ(table.at(2, "fit.break_strain.noise_error [1]"), "0.0001");
  EXPECT_EQ(table.at(2, "fit.break_strain.sampling_error [1]"), "0.00039");
  EXPECT_EQ(table.at(2, "fit.break_strain.misfit_error [1]"), "0.0002");
  EXPECT_EQ(table.at(2, "fit.break_strain.verdict_number"), "0.018");
  EXPECT_EQ(table.at(2, "fit.break_strain.extrapolated [1]"), "") << "not known";
  EXPECT_EQ(table.at(2, "cost [1]"), "49.1");
  EXPECT_EQ(table.at(2, "starts"), "4");
  EXPECT_EQ(table.at(2, "segments [1]"), "32");
  EXPECT_EQ(table.at(3, "status"), "failed");
  EXPECT_EQ(table.at(3, "reason"), "no");
  EXPECT_EQ(table.rows[3][modulus], "");
}

TEST(SceneFitCsv, HasARowPerTarget) {
  const Table table(write_targets_csv, {scene_record("b"), failed_scene_record("f", "no")});
  ASSERT_EQ(table.rows.size(), 4U);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.rows[0].size());
  const std::vector<std::pair<std::string, std::string>> bent{{"fit", "b"},
                                                              {"name", "bent"},
                                                              {"abscissa", "support 2"},
                                                              {"abscissa_unit", "m"},
                                                              {"ordinate_probe", "force"},
                                                              {"ordinate_unit", "N"},
                                                              {"samples_measured [1]", "30"},
                                                              {"weight [1]", "1"},
                                                              {"break_at", "0.0605"},
                                                              {"break_half_interval", "0.0005"},
                                                              {"law", "ideal"},
                                                              {"level", "planar"},
                                                              {"noise", "5"},
                                                              {"stated_noise", ""},
                                                              {"degrees_of_freedom [1]", "28.8"},
                                                              {"misfit_fraction [1]", "0.0083"},
                                                              {"runs_test_p [1]", "0.41"},
                                                              {"break_strain [1]", "0.021"}};
  for (const auto& [title, value] : bent) EXPECT_EQ(table.at(1, title), value) << title;
  EXPECT_NE(table.at(2, "stated_noise"), "");
  EXPECT_EQ(table.at(2, "degrees_of_freedom [1]"), "") << "known";
  EXPECT_EQ(table.at(2, "runs_test_p [1]"), "");
  EXPECT_EQ(table.at(3, "law"), "");
}

TEST(SceneFitCsv, HasARowPerSample) {
  const auto rows =
      Table(write_curves_csv, {scene_record("b"), failed_scene_record("f", "no")}).rows;
  ASSERT_EQ(rows.size(), 1U + 30U + 20U + 30U);
  EXPECT_EQ(rows[1], (std::vector<std::string>{"b", "bent", "0.002", "m", "20", "20", "1", "N"}));
  EXPECT_EQ(rows[31][3], "rad");
  EXPECT_EQ(rows[51][5], "") << "not fitted";
}

// Both are made of the same entries.
TEST(SceneFitCsv, SaysWhatJsonSays) {
  const Table table(write_fits_csv, {scene_record("b")});
  const Json fit = Json::parse(json_summary(std::vector{scene_record("b")}))["fits"][0];
  std::size_t compared = 0;
  for (std::size_t c = 0; c < table.rows[0].size(); ++c) {
    const std::string name = table.rows[0][c].substr(0, table.rows[0][c].find(" ["));
    if (!fit.contains(name) || !fit[name].is_number()) continue;
    EXPECT_EQ(std::stod(table.rows[1][c]), fit[name].get<double>()) << name;
    ++compared;
  }
  EXPECT_GT(compared, 5U);
}

}  // namespace
}  // namespace plastica::calibrate
