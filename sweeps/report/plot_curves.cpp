#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_figure.hpp"
#include "sweeps/report/case_rows.hpp"
#include "sweeps/report/plot_charts.hpp"

namespace plastica::sweeps {
namespace {

/// The cases that are drawn.
std::vector<std::size_t> shown_cases(const PlotCases& cases) {
  const SweepRecord& record = cases.record;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    if (cases.picked[i] && !record.results[i].curve.empty()) shown.push_back(i);
  }
  const std::size_t curves = shown.size();
  if (curves == 0) throw InputError({}, "--case", "", "picks no case with a curve");
  if (curves <= kLooks) return shown;
  // The finest of each group.
  shown.clear();
  for (const CaseLine& line : refinement_lines(cases)) {
    const auto finest = std::find_if(line.cases.rbegin(), line.cases.rend(), [&](std::size_t i) {
      return !record.results[i].curve.empty();
    });
    if (finest != line.cases.rend()) shown.push_back(*finest);
  }
  if (!shown.empty() && shown.size() <= kLooks) return shown;
  throw InputError({}, "--case", "",
                   fmt::format("is needed: a picture has at most {} curves, and there are {}; "
                               "AXIS = VALUE, … picks some",
                               kLooks, curves));
}

/// What the shown cases are compared with, each at its own times: they lie over each other where
/// all have the same. @return whether there is any
bool add_references(const SweepRecord& record, const std::vector<std::size_t>& shown, double scale,
                    Chart& chart) {
  bool is_first = true;
  for (const std::size_t i : shown) {
    const std::vector<double>& reference = record.comparison.reference_curve[i];
    if (reference.empty()) continue;
    ChartSeries series{is_first ? "reference" : "",
                       {std::string(report::kDark), 7, true, false, true, 1.2},
                       {},
                       {}};
    for (std::size_t s = 0; s < reference.size(); ++s) {
      series.points.push_back({record.results[i].time[s], reference[s] / scale});
    }
    series.points = report::thinned(series.points);
    const auto is_same = [&](const ChartSeries& other) {
      return other.look.dashed && other.points == series.points;
    };
    if (std::any_of(chart.series.begin(), chart.series.end(), is_same)) continue;
    chart.series.push_back(std::move(series));
    is_first = false;
  }
  return !is_first;
}

}  // namespace

bool has_curves(const SweepRecord& record) {
  return std::any_of(record.results.begin(), record.results.end(),
                     [](const CaseResult& result) { return !result.curve.empty(); });
}

Chart curve_chart(const PlotCases& cases) {
  const SweepRecord& record = cases.record;
  Chart chart{report::printable(record.name), {}, {}, {}};
  const std::vector<std::size_t> shown = shown_cases(cases);
  // Axes on which these differ.
  std::vector<std::size_t> axes;
  for (const std::size_t a : varied_axes(record)) {
    const auto same = [&](std::size_t i) { return record.at(i, a) == record.at(shown.front(), a); };
    if (shown.size() == 1 || !std::all_of(shown.begin(), shown.end(), same)) axes.push_back(a);
  }
  double largest = 0.0;
  for (const std::size_t i : shown) {
    for (const double value : record.results[i].curve) largest = std::max(largest, std::abs(value));
  }
  const ShownNumbers numbers = shown_value(record, largest);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const CaseResult& result = record.results[shown[k]];
    ChartSeries series{short_setting(record, shown[k], axes), chart_look(k), {}, {}};
    series.look.symbols = false;
    series.look.dashes = static_cast<int>(k);  // curves that converge lie over each other
    for (std::size_t s = 0; s < result.curve.size(); ++s) {
      series.points.push_back({result.time[s], result.curve[s] / numbers.scale});
    }
    series.points = report::thinned(series.points);
    chart.series.push_back(std::move(series));
  }
  const bool has_reference = add_references(record, shown, numbers.scale, chart);
  chart.subtitle = has_reference ? subtitle_of(record) : report::printable(record.quantity.name);
  chart.x.label = record.results[shown.front()].level == Level::Coupon ? "sample" : "time [s]";
  std::vector<double> heights;
  for (const ChartSeries& series : chart.series) {
    for (const auto& point : series.points) heights.push_back(point[1]);
  }
  chart.y = axis_at_values(numbers.label, std::move(heights), false);
  chart.y.ticks.clear();
  return chart;
}

}  // namespace plastica::sweeps
