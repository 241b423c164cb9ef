#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "calibrate/report/csv_export.hpp"
#include "calibrate/report/json.hpp"
#include "calibrate/report/plot.hpp"
#include "calibrate/report/scene_fit_text.hpp"
#include "tests/calibrate/report/scene_records.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"

// Intervals of profile and bootstrap in what people and scripts read.

namespace plastica::calibrate {
namespace {

using plastica::testing::has;
using Json = nlohmann::json;

using plastica::testing::message_of;
using testing::lone_scene_record;
using testing::record_with_intervals;
using testing::scene_record;

TEST(SceneIntervalsReport, PutsAllIntervalsSideBySide) {
  const std::string text = scene_fit_report(record_with_intervals());
  EXPECT_TRUE(has(text, "Intervals of 95 %\n")) << text;
  EXPECT_TRUE(has(text, "covariance")) << text;
  EXPECT_TRUE(has(text, "profile")) << text;
  EXPECT_TRUE(has(text, "bootstrap, residuals")) << text;
  EXPECT_TRUE(has(text, "202.0 … 209.0")) << text;
  EXPECT_TRUE(has(text, "375.0 … bound")) << text;
  EXPECT_TRUE(has(text, "open … open")) << text;
  EXPECT_TRUE(has(text,
                  "profile: where the least cost has risen by 4.00; bound: it has not, up "
                  "to the parameter's bound"))
      << text;
  EXPECT_TRUE(has(text, "percentiles of 5 resamples, residuals in blocks of 2; 1 failed")) << text;
  EXPECT_FALSE(has(scene_fit_report(scene_record()), "Intervals of"));
}

TEST(SceneIntervalsReport, WritesThemAsJson) {
  const Json fit = Json::parse(json_summary(std::vector{record_with_intervals()}))["fits"][0];
  const Json& profile = fit["intervals"]["profile"]["yield_stress"];
  EXPECT_EQ(profile["interval"], Json({375e6, 2e9}));
  EXPECT_EQ(profile["ends"], Json({"crossed", "bound"}));
  EXPECT_EQ(profile["value"].size(), 3U);
  const Json& bootstrap = fit["intervals"]["bootstrap"];
  EXPECT_EQ(bootstrap["resamples"], 5);
  EXPECT_EQ(bootstrap["failed"], 1);
  EXPECT_EQ(bootstrap["parameters"]["break_strain"]["interval"], Json({0.020, 0.022}));
  EXPECT_TRUE(fit["intervals"]["bootstrap_specimens"].is_null());
  const Json bare = Json::parse(json_summary(std::vector{scene_record()}))["fits"][0];
  EXPECT_FALSE(bare.contains("intervals"));
}

TEST(SceneIntervalsReport, WritesColumnsOfThoseThatAnyFitHas) {
  std::ostringstream out, bare;
  write_fits_csv(out, std::vector{record_with_intervals(), scene_record("b")});
  const std::string header = out.str().substr(0, out.str().find('\n'));
  EXPECT_TRUE(has(header,
                  "fit.youngs_modulus.segments_error [Pa],"
                  "fit.youngs_modulus.profile_low [Pa],"
                  "fit.youngs_modulus.profile_high [Pa],"
                  "fit.youngs_modulus.profile_low_end,"
                  "fit.youngs_modulus.profile_high_end,"
                  "fit.youngs_modulus.bootstrap_low [Pa],"
                  "fit.youngs_modulus.bootstrap_high [Pa],"))
      << header;
  EXPECT_FALSE(has(header, "specimens"));
  std::istringstream lines(out.str());
  std::string line;
  std::vector<std::ptrdiff_t> cells;
  while (std::getline(lines, line)) cells.push_back(std::ranges::count(line, ','));
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(cells[1], cells[0]);
  EXPECT_EQ(cells[2], cells[0]);
  EXPECT_TRUE(has(out.str(), ",crossed,bound,")) << out.str();
  write_fits_csv(bare, std::vector{scene_record()});
  EXPECT_FALSE(has(bare.str(), "profile"));
}

TEST(SceneIntervalsReport, SaysTheThresholdsOfAllParameters) {
  SceneFitRecord record = record_with_intervals();
  EXPECT_TRUE(has(scene_fit_report(record), "risen by 4.00;"));
  record.result.intervals.profiles[1].threshold = 5.0;
  EXPECT_TRUE(has(scene_fit_report(record), "risen by 4.00 to 5.00;"));
}

TEST(SceneIntervalsReport, DrawsProfiles) {
  const std::string script = plot_script(std::vector{record_with_intervals()}, {.what = "profile"});
  EXPECT_TRUE(has(script, "set title 'youngs_modulus [GPa]'"));
  EXPECT_TRUE(has(script, "set arrow from 202, graph 0"));
  EXPECT_TRUE(has(script, "set arrow from 209, graph 0"));
  EXPECT_FALSE(has(script, "set arrow from 2000, graph 0")) << "an end at a bound";
  for (const char* name : {"'least cost'", "'threshold'", "'parabola of the covariance'"}) {
    EXPECT_TRUE(has(script, std::string("title ") + name)) << name;
  }
  EXPECT_EQ(message_of([] { plot_script(std::vector{scene_record()}, {.what = "profile"}); }),
            "--what = profile: both has no profile: calibrate with --profile");
}

TEST(SceneIntervalsReport, DrawsBootstraps) {
  const std::string script =
      plot_script(std::vector{record_with_intervals()}, {.what = "bootstrap"});
  EXPECT_TRUE(has(script, "set title 'yield_stress [MPa] over'.\"\\n\".'youngs_modulus'"));
  EXPECT_TRUE(has(script, "204 379"));
  EXPECT_TRUE(has(script, "set arrow from 203, graph 0")) << "a percentile";
  EXPECT_EQ(message_of([] { plot_script(std::vector{scene_record()}, {.what = "bootstrap"}); }),
            "--what = bootstrap: both has no bootstrap: calibrate with --bootstrap 400");
}

TEST(SceneIntervalsReport, DrawsNoBootstrapOfWhatIsNotIdentified) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  SceneFitRecord record = record_with_intervals();
  record.result.intervals.residuals.intervals[2] = {kNan, kNan, kNan};
  const std::string script = plot_script(std::vector{record}, {.what = "bootstrap"});
  EXPECT_FALSE(has(script, "nan"));
  EXPECT_FALSE(has(script, "break_strain"));
}

TEST(SceneIntervalsReport, DrawsBandsWhereTheCurveHasErrors) {
  SceneFitRecord record = lone_scene_record("a", 2e11, 3e8);
  record.targets[0].abscissa = {0.25, 0.5};
  record.targets[0].ordinate = {10.0, 20.0};
  record.result.targets[0].fitted = {12.0, 19.0};
  for (TargetFit& of_target : record.result.targets) {
    of_target.degrees_of_freedom = std::numeric_limits<double>::infinity();
  }
  const auto script_of = [&] { return plot_script(std::vector{record}, {}); };
  EXPECT_FALSE(has(script_of(), "of the curve"));
  record.result.targets[0].fitted_error = {1.0, 2.0};
  record.result.targets[0].noise = 0.0;
  // 12 -+ 1.96
  EXPECT_TRUE(has(script_of(), "250 10.04003602 13.95996398")) << script_of();
  EXPECT_TRUE(has(script_of(), "with filledcurves"));
  record.targets[0].abscissa = {0.5, 0.25};
  EXPECT_FALSE(has(script_of(), "with filledcurves")) << "a path to and fro";
}

}  // namespace
}  // namespace plastica::calibrate
