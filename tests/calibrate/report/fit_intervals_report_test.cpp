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
#include "calibrate/report/text.hpp"
#include "tests/calibrate/report/records.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"

// Intervals of profile and bootstrap of coupons in what people and scripts read.

namespace plastica::calibrate {
namespace {

using plastica::testing::has;
using Json = nlohmann::json;

using plastica::testing::message_of;
using testing::fitted_record;

/// Profiles: of the modulus crossed, of the yield stress open upwards, of all else none; five
/// resamples.
FitRecord with_intervals() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  FitRecord record = fitted_record();
  const std::size_t free = record.result.free_parameters().size();
  FitIntervals& all = record.result.intervals;
  all.profiles.assign(free, {kNan, kNan, ProfileEnd::Open, ProfileEnd::Open, 4.0, {}, {}, {}});
  all.profiles[0] = {
      69.1e9,          70.9e9, ProfileEnd::Crossed, ProfileEnd::Crossed, 4.0, {69e9, 70e9, 71e9},
      {4.1, 0.0, 4.1}, {}};
  all.profiles[1] = {276e6,      2e9, ProfileEnd::Crossed, ProfileEnd::Bound, 4.0, {275e6, 280e6},
                     {4.1, 0.0}, {}};
  all.residuals.resamples = 6;
  all.residuals.failed = 1;
  all.residuals.block = 2;
  for (int b = 0; b < 5; ++b) {
    for (std::size_t i = 0; i < free; ++i) {
      const double value = record.result.free_parameters()[i]->value;
      all.residuals.values.push_back(value * (1.0 + 0.01 * (b - 2)));
    }
  }
  all.residuals.intervals.assign(free, {kNan, kNan, kNan});
  all.residuals.intervals[0] = {0.5e9, 69.2e9, 70.8e9};
  return record;
}

TEST(FitIntervalsReport, PutsAllIntervalsSideBySide) {
  const std::string text = fit_report(with_intervals());
  EXPECT_TRUE(has(text, "Intervals of 95 %\n")) << text;
  EXPECT_TRUE(has(text, "bootstrap, residuals")) << text;
  EXPECT_TRUE(has(text, "69.10 … 70.90")) << text;
  EXPECT_TRUE(has(text, "276.0 … bound")) << text;
  EXPECT_TRUE(has(text, "69.20 … 70.80")) << text;
  EXPECT_TRUE(has(text, "percentiles of 6 resamples, residuals in blocks of 2; 1 failed")) << text;
  EXPECT_FALSE(has(fit_report(fitted_record()), "Intervals of"));
}

TEST(FitIntervalsReport, WritesThemAsJson) {
  const Json fit = Json::parse(json_summary(std::vector{with_intervals()}))["fits"][0];
  const Json& profile = fit["intervals"]["profile"]["yield_stress"];
  EXPECT_EQ(profile["interval"], Json({276e6, 2e9}));
  EXPECT_EQ(profile["ends"], Json({"crossed", "bound"}));
  EXPECT_EQ(profile["rise"], Json({4.1, 0.0}));
  EXPECT_EQ(fit["intervals"]["bootstrap"]["failed"], 1);
  EXPECT_EQ(fit["intervals"]["bootstrap"]["parameters"]["youngs_modulus"]["interval"],
            Json({69.2e9, 70.8e9}));
  EXPECT_TRUE(fit["intervals"]["bootstrap_specimens"].is_null());
  const Json bare = Json::parse(json_summary(std::vector{fitted_record()}))["fits"][0];
  EXPECT_FALSE(bare.contains("intervals"));
}

TEST(FitIntervalsReport, WritesMeansOfSpecimensAsJsonAndText) {
  const std::vector records{fitted_record("a", 276e6), fitted_record("b", 284e6)};
  const Json group = Json::parse(json_summary(records))["groups"][0];
  const Json& yield = group["parameters"]["yield_stress"];
  // t(0.975; 1) = 12.7062 of 4 MPa.
  EXPECT_NEAR(yield["mean_interval"][0].get<double>(), 280e6 - 50.825e6, 1e4);
  EXPECT_NEAR(yield["mean_standard_error"].get<double>(), 4e6, 1.0);
  EXPECT_TRUE(group["characteristics"]["rm"].contains("mean_interval"));
  ReportOptions options;
  const std::string text = batch_report(records, options);
  EXPECT_TRUE(has(text, "95 % of the mean")) << text;
  EXPECT_TRUE(has(text, "229 … 331")) << text;
  EXPECT_TRUE(has(text, "of the mean: Student's t\n")) << text;
  EXPECT_FALSE(has(batch_report(std::vector{fitted_record()}), "of the mean:"));
  std::vector<FitRecord> many;
  for (int i = 0; i < 10; ++i)
    many.push_back(fitted_record("x" + std::to_string(i), 2e8 + i * 1e6));
  options.specimen_resamples = 100;
  EXPECT_TRUE(has(batch_report(records, options),
                  "Student's t: no group has the 10 values that a bootstrap takes\n"));
  EXPECT_TRUE(
      has(batch_report(many, options), "of 10 values and more bootstrap-t of 100 resamples"));
}

TEST(FitIntervalsReport, WritesColumnsOfThoseThatAnySpecimenHas) {
  std::ostringstream out, bare;
  write_fits_csv(out, std::vector{with_intervals(), fitted_record("b")});
  const std::string header = out.str().substr(0, out.str().find('\n'));
  EXPECT_TRUE(has(header,
                  "fit.youngs_modulus.verdict_number,fit.youngs_modulus.profile_low [Pa],"
                  "fit.youngs_modulus.profile_high [Pa],fit.youngs_modulus.profile_low_end,"
                  "fit.youngs_modulus.profile_high_end,fit.youngs_modulus.bootstrap_low [Pa],"
                  "fit.youngs_modulus.bootstrap_high [Pa],"))
      << header;
  EXPECT_FALSE(has(header, "specimens_low"));
  EXPECT_TRUE(has(out.str(), "69100000000,70900000000,crossed,crossed,69200000000,70800000000"))
      << out.str();
  std::istringstream lines(out.str());
  std::string line;
  std::vector<std::ptrdiff_t> cells;
  while (std::getline(lines, line)) cells.push_back(std::ranges::count(line, ','));
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(cells[1], cells[0]);
  EXPECT_EQ(cells[2], cells[0]);
  write_fits_csv(bare, std::vector{fitted_record()});
  EXPECT_FALSE(has(bare.str(), "profile"));
}

TEST(FitIntervalsReport, DrawsThem) {
  const std::vector records{with_intervals()};
  const std::string profile = plot_script(records, {.what = "profile"});
  EXPECT_TRUE(has(profile, "set title 'youngs_modulus [GPa]'"));
  EXPECT_TRUE(has(profile, "set arrow from 69.1, graph 0"));
  // The others have no interval.
  const std::string bootstrap = plot_script(records, {.what = "bootstrap", .specimen = "bar-01"});
  EXPECT_TRUE(has(bootstrap, "youngs_modulus [GPa]"));
  EXPECT_FALSE(has(bootstrap, "yield_stress [MPa]"));
  EXPECT_FALSE(has(bootstrap, "nan"));
  std::vector all{with_intervals()};
  for (BootstrapInterval& interval : all[0].result.intervals.residuals.intervals) {
    interval = {1e6, 200e6, 300e6};
  }
  EXPECT_TRUE(has(plot_script(all, {.what = "bootstrap"}),
                  "set title 'yield_stress [MPa] over'.\"\\n\".'youngs_modulus'"));
  EXPECT_EQ(message_of([] { plot_script(std::vector{fitted_record()}, {.what = "profile"}); }),
            "--what = profile: bar-01 has no profile: calibrate with --profile");
  EXPECT_EQ(message_of([] { plot_script(std::vector{fitted_record()}, {.what = "bootstrap"}); }),
            "--what = bootstrap: bar-01 has no bootstrap: calibrate with --bootstrap 400");
}

}  // namespace
}  // namespace plastica::calibrate
