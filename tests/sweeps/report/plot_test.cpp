#include "sweeps/report/plot.hpp"

#include <gtest/gtest.h>

#include "sweeps/report/plot_charts.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/run_record.hpp"

namespace plastica::sweeps {
namespace {

using plastica::testing::has;

std::vector<std::string> kinds_of(const SweepRecord& record) {
  std::vector<std::string> names;
  for (const SweepPlotKind& kind : sweep_plot_kinds_of(record)) names.emplace_back(kind.name);
  return names;
}

PlotCases every_case(const SweepRecord& record) {
  return {record, std::vector<bool>(record.cases(), true)};
}

SweepRecord curves(const std::string& values) {
  return record_of("[set]\nsolver.steps = 2\n" + segments_axis(values) +
                   "[error]\nprobe = 'tip'\ntake = 'curve'\n");
}

using Names = std::vector<std::string>;

TEST(SweepPlotKinds, AreThoseThatASweepHas) {
  EXPECT_EQ(kinds_of(two_groups()), (Names{"convergence", "value", "trade"}));
  EXPECT_EQ(kinds_of(curves("[2, 3]")), Names{"curve"});
  EXPECT_EQ(kinds_of(record_of("[[axis]]\nfield = 'rules.end_rule'\nvalues = ['equal', 'half']\n"
                               "[error]\nprobe = 'tip'\n")),
            Names{"value"});
}

TEST(ConvergenceChart, HasALineAndAnOrderForEachGroup) {
  const SweepRecord record = two_groups();
  const Chart chart = convergence_chart(every_case(record));
  ASSERT_EQ(chart.series.size(), 2U);
  EXPECT_TRUE(has(chart.series[0].name, ": half_joint")) << chart.series[0].name;
  EXPECT_TRUE(chart.series[1].name.starts_with("order 0.9")) << chart.series[1].name;
  ASSERT_EQ(chart.series[0].points.size(), 3U);
  EXPECT_DOUBLE_EQ(chart.series[0].points[0][0], 4.0);
  EXPECT_DOUBLE_EQ(chart.series[0].points[0][1], 100.0 * std::abs(*record.comparison.error[0]));
  EXPECT_EQ(chart.x.label, "beam.segments");
}

TEST(ConvergenceChart, SaysWhatErrorsDoNotHaveInThem) {
  SweepRecord record = two_groups();
  EXPECT_EQ(subtitle_of(record), "tip, end against theory:elastica");
  record.comparison.reference_error[2] = 0.0027;
  EXPECT_EQ(subtitle_of(record),
            "tip, end against theory:elastica; the reference is off by about 0.27 %");
  record.comparison.coarser_in[1] = "solver.time_step";  // a case of the second group
  const Chart chart = convergence_chart(every_case(record));
  EXPECT_TRUE(chart.series[0].name.starts_with("order")) << chart.series[0].name;
  EXPECT_EQ(chart.series[1].name, "equal");
  record.comparison.lacks[1] = "solver.time_step";
  EXPECT_EQ(subtitle_of(record),
            "tip, end: error of beam.segments alone; that of solver.time_step is not in it");
}

TEST(ConvergenceChart, LeavesTheRoundOffFloorOpen) {
  SweepRecord record = record_of(segments_axis("[4, 8, 16, 32]") + kTipError);
  const std::vector<double> errors{1e-2, 1e-4, 1e-6, 0.0};
  for (std::size_t i = 0; i < 4; ++i) record.comparison.error[i] = errors[i];
  const Chart chart = convergence_chart(every_case(record));
  EXPECT_EQ(chart.series[0].points.size(), 3U);
  ASSERT_EQ(chart.series[0].hollow.size(), 1U);
  EXPECT_DOUBLE_EQ(chart.series[0].hollow[0][0], 32.0);
  EXPECT_DOUBLE_EQ(chart.series[0].hollow[0][1], 1e-5) << "an exact zero, below all others";
  EXPECT_TRUE(has(chart.subtitle, "; at the lower edge, open: 1 case without any error"));
}

TEST(ConvergenceChart, DrawsCasesOfOneRunOnce) {
  // Two of the four values come to the same number of segments.
  const SweepRecord record = record_of(
      "[set]\nbeam.length = '1 m'\n[[axis]]\nfield = 'beam.segment_depth'\n"
      "values = [10, 9.9, 5, 2.5]\n" +
      kTipError);
  ASSERT_EQ(record.results[0].segments, record.results[1].segments);
  const Chart chart = convergence_chart(every_case(record));
  EXPECT_EQ(chart.series.front().points.size(), 3U);
}

TEST(ConvergenceChart, TellsManyGroupsApartByColourAndSymbol) {
  const SweepRecord record =
      record_of(segments_axis("[4, 8]") +
                "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal', 'half']\n"
                "[[axis]]\nfield = 'scale.loads'\nvalues = [0.5, 1, 2]\n" +
                kTipError);
  const Chart chart = convergence_chart(every_case(record));
  ASSERT_EQ(chart.series.size(), 9U + 2U) << "and lines of orders 1 and 2";
  EXPECT_EQ(chart.series[0].look.color, chart.series[2].look.color);
  EXPECT_NE(chart.series[0].look.symbol, chart.series[2].look.symbol);
  EXPECT_EQ(chart.series[0].look.symbol, chart.series[3].look.symbol);
  EXPECT_NE(chart.series[0].look.color, chart.series[3].look.color);
  Names names;
  for (const ChartSeries& entry : chart.entries) names.push_back(entry.name);
  EXPECT_EQ(names, (Names{"half_joint", "equal", "half", "loads 0.5", "loads 1", "loads 2"}));
}

TEST(ConvergenceChart, HoldsTheDifferenceOfAxesThatMoveTogether) {
  const SweepRecord record = record_of(
      segments_axis("[4, 8]") +
      "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half', 'half', 'equal']\nzip = 'a'\n"
      "[[axis]]\nfield = 'scale.loads'\nvalues = [1, 2, 2]\nzip = 'a'\n"
      "[[axis]]\nfield = 'beam.length'\nvalues = ['1 m', '2 m', '3 m']\nzip = 'a'\n" +
      kTipError);
  const auto lines = refinement_lines(every_case(record));
  EXPECT_EQ(looks_of(record, lines, 0).names,
            (Names{"half, loads 1", "half, loads 2", "equal, loads 2"}));
}

TEST(ValueChart, ShowsTheReferenceThatAllShare) {
  const Chart chart = value_chart(every_case(two_groups()));
  ASSERT_EQ(chart.series.size(), 3U);
  EXPECT_EQ(chart.series[2].name, "reference");
  EXPECT_NEAR(chart.series[2].points[0][1], -0.7353, 1e-4);
  EXPECT_EQ(chart.y.label, "tip, end [m]");
}

TEST(ValueChart, IsInAUnitThatCanBeRead) {
  const SweepRecord record = record_of(
      "[[axis]]\nfield = 'material.youngs_modulus'\nvalues = ['200 GPa', '210 GPa']\n"
      "[error]\nprobe = 'tip'\n");
  const Chart chart = value_chart(every_case(record));
  EXPECT_EQ(chart.x.label, "material.youngs_modulus [GPa]");
  EXPECT_DOUBLE_EQ(chart.series[0].points[1][0], 210.0);
}

TEST(ValueChart, OfWordsHasAPlaceForEach) {
  const SweepRecord record = record_of(
      "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['equal', 'half']\n[error]\nprobe = 'tip'\n");
  const Chart chart = value_chart(every_case(record));
  ASSERT_EQ(chart.x.ticks.size(), 2U);
  EXPECT_EQ(chart.x.ticks[1].text, "half");
  EXPECT_FALSE(chart.series[0].look.line);
}

TEST(ValueChart, OfASampleIsACloudOverWhatMovesItMost) {
  const SweepRecord record = record_of(
      "[[axis]]\nfield = 'beam.length'\nsampled = ['1 m', '1.01 m']\n"
      "[[axis]]\nfield = 'material.youngs_modulus'\nsampled = ['100 GPa', '300 GPa']\n"
      "[sample]\nmethod = 'latin_hypercube'\ncount = 30\n[error]\nprobe = 'tip'\n");
  const Chart chart = value_chart(every_case(record));
  EXPECT_EQ(chart.x.label, "material.youngs_modulus [GPa]");
  ASSERT_EQ(chart.series.size(), 1U);
  EXPECT_FALSE(chart.series[0].look.line);
  EXPECT_EQ(chart.series[0].points.size(), 30U);
}

TEST(TradeChart, HasTheFrontAndGuides) {
  SweepRecord record = two_groups();
  const std::vector<double> errors{0.05, 0.5, 0.005, 0.4, 0.00005, 0.3};
  for (std::size_t i = 0; i < 6; ++i) record.comparison.error[i] = errors[i];
  const Chart chart = trade_chart(every_case(record));
  EXPECT_EQ(chart.x.label, "work [segment-iterations]");
  EXPECT_EQ(chart.guides, (std::vector<double>{1.0, 0.1, 0.01}));
  EXPECT_EQ(chart.series[0].name, "Pareto front");
  EXPECT_GE(chart.series[0].points.size(), 3U);
  for (std::size_t k = 1; k < chart.series[0].points.size(); ++k) {
    EXPECT_LT(chart.series[0].points[k][1], chart.series[0].points[k - 1][1]);
  }
}

TEST(TradeChart, SetsCasesWithoutAnyErrorApart) {
  SweepRecord record = two_groups();
  const std::vector<double> errors{0.05, 0.5, 0.0, 0.4, 0.01, 0.3};
  for (std::size_t i = 0; i < 6; ++i) record.comparison.error[i] = errors[i];
  record.results[1].iterations = 0;
  const Chart chart = trade_chart(every_case(record));
  ASSERT_EQ(chart.series.at(1).hollow.size(), 1U);
  EXPECT_DOUBLE_EQ(chart.series[1].hollow[0][1], 0.1) << "a tenth of the least other";
  EXPECT_EQ(chart.series[1].points.size(), 2U);
  EXPECT_TRUE(has(chart.subtitle,
                  "; without 1 case that cost nothing; at the lower edge, open: "
                  "1 case without any error"))
      << chart.subtitle;
}

TEST(TradeChart, HasNoFrontThroughSeveralProblems) {
  const SweepRecord record = record_of(
      segments_axis("[4, 8]") + "[[axis]]\nfield = 'scale.loads'\nvalues = [0.5, 1]\n" + kTipError);
  for (const ChartSeries& series : trade_chart(every_case(record)).series) {
    EXPECT_NE(series.name, "Pareto front");
  }
}

TEST(TradeChart, CostsTimeWhereCasesWereTimed) {
  SweepRecord record = two_groups();
  record.timed_runs = 1;
  for (CaseResult& result : record.results) result.seconds = 0.002;
  const Chart chart = trade_chart(every_case(record));
  EXPECT_EQ(chart.x.label, "time [ms]");
  EXPECT_DOUBLE_EQ(chart.series[1].points[0][0], 2.0);
}

TEST(CurveChart, NamesCurvesByWhatTheyDifferIn) {
  const Chart chart = curve_chart(every_case(curves("[2, 3]")));
  ASSERT_EQ(chart.series.size(), 2U);
  EXPECT_EQ(chart.series[1].name, "segments 3");
  EXPECT_EQ(chart.series[1].points.size(), 3U);
}

TEST(CurveChart, DrawsTheReferenceThatItsTitleNames) {
  const auto chart_of = [](const std::string& against) {
    return curve_chart(
        every_case(record_of("[set]\nsolver.steps = 2\n" + segments_axis("[2, 3, 4]") +
                             "[error]\nprobe = 'tip'\ntake = 'curve'\n" + against)));
  };
  const Chart chart = chart_of("against = 'finest'\n");
  EXPECT_TRUE(chart.subtitle.starts_with("tip, curve against finest")) << chart.subtitle;
  ASSERT_EQ(chart.series.size(), 4U) << "one reference of two cases";
  EXPECT_EQ(chart.series[3].name, "reference");
  EXPECT_EQ(chart.series[3].points, chart.series[2].points);
  EXPECT_NE(chart.series[0].look.dashes, chart.series[1].look.dashes);
  EXPECT_EQ(chart_of("").subtitle, "tip, curve");
}

TEST(CurveChart, TakesTheFinestOfEachGroupOfMany) {
  const Chart chart = curve_chart(every_case(curves("[2, 3, 4, 5, 6, 7, 8, 9, 10]")));
  ASSERT_EQ(chart.series.size(), 1U);
  EXPECT_EQ(chart.series[0].name, "segments 10");
}

TEST(SweepPlot, DrawsPickedCasesAlone) {
  const std::string script = sweep_plot_script(two_groups(), {"", "end_rule = equal", "x.svg"});
  EXPECT_TRUE(has(script, ": equal'")) << script;
  EXPECT_FALSE(has(script, "half_joint"));
}

TEST(SweepPlot, LetsNoTextOfAUserLeaveItsQuotes) {
  SweepRecord record = two_groups();
  record.name = "'; system 'x";
  record.quantity.name = "'; system 'y";
  for (const char* what : {"convergence", "value", "trade"}) {
    for (const char* output : {"x.svg", "-"}) {
      const std::string script = sweep_plot_script(record, {what, "", output});
      EXPECT_TRUE(has(script, "'''; system ''x'")) << what;
      EXPECT_FALSE(has(script, " '; system 'y'")) << what;
    }
  }
}

TEST(SweepPlot, SaysWhatThereIsToDraw) {
  const auto refusal = [](const SweepRecord& record, const SweepPlotRequest& request) {
    return plastica::testing::message_of([&] { sweep_plot_script(record, request); });
  };
  EXPECT_EQ(refusal(two_groups(), {"pie", "", "-"}),
            "--what = pie: must be one of convergence, value, trade for this file");
  EXPECT_EQ(refusal(two_groups(), {"", "xyz", "-"}).substr(0, 12), "--case = xyz");
  SweepRecord failed = two_groups();
  for (std::size_t i = 0; i < 6; ++i) {
    failed.results[i] = CaseResult{};
    failed.comparison.error[i].reset();
  }
  EXPECT_EQ(refusal(failed, {}), "plot: there is no value to draw");
  SweepRecord half = two_groups();
  for (const std::size_t i : {0U, 2U, 4U}) half.comparison.error[i].reset();
  EXPECT_EQ(refusal(half, {"convergence", "end_rule = half_joint", "-"}),
            "--case: picks no case with an error");
}

}  // namespace
}  // namespace plastica::sweeps
