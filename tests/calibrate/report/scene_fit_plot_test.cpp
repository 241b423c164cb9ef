#include "calibrate/report/plot.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "plastica/base/check.hpp"
#include "tests/calibrate/report/scene_records.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::has;

using plastica::testing::message_of;
using testing::failed_scene_record;
using testing::lone_scene_record;
using testing::scene_record;

std::string script_of(const SceneFitRecord& record, const std::string& what) {
  return plot_script(std::vector{record}, {.what = what});
}

TEST(SceneFitPlot, OfAFitHasAPanelPerTargetWithTheBreakMarked) {
  const std::string script = script_of(scene_record(), "");
  EXPECT_TRUE(has(script, "set title 'bent'"));
  EXPECT_TRUE(has(script, "set title 'twisted'"));
  EXPECT_TRUE(has(script, "set xlabel 'support 2 [mm]'"));
  EXPECT_TRUE(has(script, "'torque [N m]' at screen"));
  EXPECT_TRUE(has(script, "set arrow from 60.5, graph 0 to 60.5, graph 1"));
  for (const char* name : {"'measured'", "'fitted'", "'break, measured'"}) {
    EXPECT_TRUE(has(script, std::string("title ") + name)) << name;
  }
  EXPECT_TRUE(has(script, "youngs_modulus 205.0 ± 1.2 GPa"));
}

TEST(SceneFitPlot, OfAFailedFitShowsWhatWasMeasuredAndWhy) {
  const std::string script = script_of(failed_scene_record("f", "no curve at the start"), "fit");
  EXPECT_TRUE(has(script, "failed: no curve at the start"));
  EXPECT_TRUE(has(script, "title 'measured'"));
  EXPECT_FALSE(has(script, "title 'fitted'"));
}

TEST(SceneFitPlot, OfResidualsShowsMeasuredMinusFitted) {
  SceneFitRecord record = lone_scene_record("a", 2e11, 3e8);
  record.targets[0].abscissa = {0.25, 0.5};
  record.targets[0].ordinate = {10.0, 20.0};
  record.result.targets[0].fitted = {12.0, 19.0};
  const std::string script = script_of(record, "residuals");
  EXPECT_TRUE(has(script, "\n250 -2 \n500 1 \n") || has(script, "\n250 -2\n500 1\n"));
  EXPECT_TRUE(has(script, "force, measured - fitted [N]"));
  EXPECT_TRUE(has(script, "\n250 -5\n500 -5\n") || has(script, "\n250 -5 \n500 -5 \n"))
      << "the noise";
}

TEST(SceneFitPlot, OfOneTargetHasItsResidualsBelow) {
  SceneFitRecord record = lone_scene_record("a", 2e11, 3e8);
  record.targets[0].abscissa = {0.25, 0.5};
  record.targets[0].ordinate = {10.0, 20.0};
  record.result.targets[0].fitted = {12.0, 19.0};
  EXPECT_TRUE(has(script_of(record, "fit"), "'residual [N]' at screen"));
  record.targets[0].broke = SceneBreak{.at = 0.8};
  EXPECT_TRUE(has(script_of(record, "fit"), "set xrange [0:816]")) << script_of(record, "fit");
  // A factor has no unit, and a name may have brackets.
  record.targets[0].ordinate_is = Dimension::None;
  record.targets[0].ordinate_probe = "factor [of the load]";
  EXPECT_TRUE(has(script_of(record, "fit"), "'residual' at screen"));
}

TEST(SceneFitPlot, OfStartsIsTheirWaterfall) {
  const std::string script = script_of(scene_record(), "starts");
  EXPECT_TRUE(has(script, "the best cost from 2 of 4 starts, 1 without a curve"));
  EXPECT_TRUE(has(script, "set logscale y"));
  EXPECT_TRUE(has(script, "\n1 49.1\n2 49.1\n") || has(script, "\n1 49.1 \n2 49.1 \n"));
  EXPECT_TRUE(has(script, "\n3 733"));
}

TEST(SceneFitPlot, OfCorrelationsWritesEachNumber) {
  SceneFitRecord record = scene_record();
  record.result.correlation[5] = record.result.correlation[7] =
      std::numeric_limits<double>::quiet_NaN();
  for (const char* output : {"", "-"}) {
    const std::string script =
        plot_script(std::vector{record}, {.what = "correlation", .output = output});
    EXPECT_TRUE(has(script, "set label '-0.42' at 2, 3 center"));
    EXPECT_TRUE(has(script, "set label '-' at 3, 2 center"));
    EXPECT_TRUE(has(script, "'yield_stress' 2"));
  }
}

TEST(SceneFitPlot, OfSegmentsLeadsToTheContinuousBeam) {
  SceneFitRecord record = lone_scene_record("a", 200e9, 400e6);
  record.result.segments->segments = 20;
  record.result.segments->parameters[0] = segments_error(220e9, 200e9, 195e9, 2.0);
  const std::string script = script_of(record, "segments");
  EXPECT_TRUE(has(script, "a: fits with half, once and twice 20 segments"));
  EXPECT_TRUE(has(script, "set title 'youngs_modulus [GPa], order 2.00'"));
  EXPECT_TRUE(has(script, "set title 'yield_stress [MPa], oscillates'"));
  // Extrapolated by 5/3 beyond 195, and 1.25 times as much to both sides.
  EXPECT_TRUE(has(script, "\n0 193.3333333 "));
  EXPECT_TRUE(has(script, "\n2 220 \n1 200 \n0.5 195 \n"));
}

TEST(SceneFitPlot, OfThePopulationHasAPanelPerParameter) {
  const std::string script =
      plot_script(std::vector{lone_scene_record("a", 200e9, 380e6), failed_scene_record("b", "no"),
                              lone_scene_record("c", 210e9, 390e6)},
                  {.what = "population"});
  EXPECT_TRUE(has(script, "set title 'youngs_modulus [GPa]'"));
  EXPECT_TRUE(has(script, "set title 'yield_stress [MPa]'"));
  EXPECT_TRUE(has(script, "\n3 210 207.6 212.4"));
  EXPECT_TRUE(has(script, "title 'mean'"));
  EXPECT_TRUE(has(script, "title 'specimens'' standard deviation, without noise'"));
}

TEST(SceneFitPlot, RefusesWhatThereIsNot) {
  const std::vector<SceneFitRecord> records{scene_record("a"), failed_scene_record("f", "no")};
  const auto message = [&](const PlotRequest& request) {
    return message_of([&] { plot_script(records, request); });
  };
  EXPECT_EQ(
      message({.what = "pie"}),
      "--what = pie: must be fit, residuals, quantiles, starts, correlation, segments, profile, "
      "bootstrap, laws or population");
  EXPECT_EQ(message({.specimen = "x"}), "--case = x: is not a fit of this file; it has a, f");
  EXPECT_EQ(message({.what = "population", .specimen = "a"}),
            "--case = a: does not go with the picture 'population'");
  EXPECT_EQ(message({.what = "residuals", .specimen = "f"}),
            "--what = residuals: f was not fitted");
  EXPECT_EQ(message({.what = "starts", .specimen = "f"}),
            "--what = starts: f has no search that ended anywhere");
  EXPECT_EQ(message({.what = "correlation", .specimen = "f"}),
            "--what = correlation: f has no correlations");
  EXPECT_EQ(message({.what = "segments", .specimen = "f"}),
            "--what = segments: f was not repeated with other segments");
  EXPECT_EQ(message_of([] { plot_script(std::vector<SceneFitRecord>(), {}); }),
            "plot: there is no fit to draw");
}

TEST(SceneFitPlot, LetsNoTextOfAUserLeaveItsQuotes) {
  SceneFitRecord record = scene_record("it's `id`\nsystem('id')");
  record.targets[0].name = "x'y\nplot 1";
  record.targets[0].ordinate_probe = "p'q";
  record.result.intervals = testing::record_with_intervals().result.intervals;
  SceneFitRecord other = record;
  other.result.law = Law::Voce;
  for (const PlotKind& kind : scene_fit_plot_kinds()) {
    const std::string script =
        plot_script(std::vector{record, other}, {.what = std::string(kind.name)});
    EXPECT_FALSE(has(script, "\nsystem(")) << kind.name;
    EXPECT_FALSE(has(script, "\nplot 1")) << kind.name;
    EXPECT_FALSE(has(script, "p'q")) << kind.name;
  }
}

}  // namespace
}  // namespace plastica::calibrate
