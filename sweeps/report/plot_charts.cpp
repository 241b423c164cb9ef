#include "sweeps/report/plot_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "plastica/theory/convergence.hpp"
#include "sweeps/plan/refining.hpp"
#include "sweeps/report/case_rows.hpp"
#include "sweeps/report/spread.hpp"
#include "sweeps/trade/setting.hpp"

namespace plastica::sweeps {
namespace {

constexpr std::size_t kMaxPoints = 5000;  ///< of a cloud; a page shows no more
constexpr double kLogarithmic = 20.0;     ///< ratio of values from which an axis is logarithmic

[[noreturn]] void refuse_empty(std::string_view what) {
  throw InputError({}, "--case", "", fmt::format("picks no case with {}", what));
}

std::vector<double> column(const Points& points, std::size_t c) {
  std::vector<double> values;
  for (const auto& point : points) values.push_back(point[c]);
  return values;
}

/// All points of a chart, open ones included.
Points all_points(const Chart& chart) {
  Points all;
  for (const ChartSeries& series : chart.series) {
    all.insert(all.end(), series.points.begin(), series.points.end());
    all.insert(all.end(), series.hollow.begin(), series.hollow.end());
  }
  return all;
}

/// Errors of zero have no logarithm: they lie a decade below the least others, and the chart says
/// so. @param zeros  how many cases have none
void lift_zeros(Chart& chart, std::size_t zeros) {
  if (zeros == 0) return;
  double least = 0.0;
  for (const auto& point : all_points(chart)) {
    if (point[1] > 0.0 && (least == 0.0 || point[1] < least)) least = point[1];
  }
  const double lowest = least == 0.0 ? 1e-14 : 0.1 * least;  // all of them are exact
  for (ChartSeries& series : chart.series) {
    for (auto& point : series.hollow) point[1] = std::max(point[1], lowest);
    for (auto& point : series.points) point[1] = std::max(point[1], lowest);
  }
  chart.subtitle += fmt::format("; at the lower edge, open: {} without any error",
                                report::counted(zeros, "case"));
}

/// Points of one line of refinement: (what is refined, error in %).
struct ErrorLine {
  ChartSeries series;
  std::optional<double> order;
  std::size_t zeros = 0;  ///< points without any error
};

ErrorLine error_line(const SweepRecord& record, const CaseLine& line, bool count) {
  const RefinementGroup& group = record.groups[line.group];
  std::vector<double> sizes;
  std::vector<double> errors;
  bool stops = false;
  for (std::size_t k = 0; k < group.cases.size(); ++k) {
    const std::size_t i = group.cases[k];
    stops = stops || !record.comparison.coarser_in[i].empty();
    const bool picked = std::find(line.cases.begin(), line.cases.end(), i) != line.cases.end();
    if (!picked || !record.comparison.error[i]) continue;
    // Cases that come to one run are one.
    if (std::find(sizes.begin(), sizes.end(), group.size[k]) != sizes.end()) continue;
    sizes.push_back(group.size[k]);
    errors.push_back(*record.comparison.error[i]);
  }
  ErrorLine out;
  theory::OrderFit fit;
  // Errors that stop at those of other axes show no order.
  if (!stops) fit = theory::observed_order(sizes, errors);
  out.order = fit.order;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (errors[k] == 0.0) ++out.zeros;
    const bool floor = (fit.order && !fit.used[k]) || errors[k] == 0.0;
    (floor ? out.series.hollow : out.series.points)
        .push_back({count ? 1.0 / sizes[k] : sizes[k], 100.0 * std::abs(errors[k])});
  }
  return out;
}

/// What is refined, in SI: sizes are.
std::string convergence_label(const Axis& axis) {
  const std::string unit = shown_unit_of(si_unit(axis.field->dimension));
  const std::string path(axis.field->path);
  return unit.empty() ? path : fmt::format("{} [{}]", path, unit);
}

/// Dashed lines of orders 1 and 2 through the largest error, for groups without a name.
void add_order_guides(Chart& chart, bool count) {
  const Points all = all_points(chart);
  const std::vector<double> x = column(all, 0);
  const std::vector<double> y = column(all, 1);
  const auto [x_low, x_high] = std::minmax_element(x.begin(), x.end());
  const auto [y_low, y_high] = std::minmax_element(y.begin(), y.end());
  for (const int order : {1, 2}) {
    const double from = count ? *x_low : *x_high;
    // No further down than the errors go.
    const double ratio = std::min(*x_high / *x_low, std::pow(*y_high / *y_low, 1.0 / order));
    ChartSeries guide{
        fmt::format("order {}", order),
        {std::string(report::kDark), 7, true, false, order == 2, 1.0},
        {{from, *y_high}, {count ? from * ratio : from / ratio, *y_high * std::pow(ratio, -order)}},
        {}};
    chart.series.push_back(std::move(guide));
  }
}

/// How far the values go with an axis of numbers, 0 … 1.
double strength_of(const SweepRecord& record, std::size_t axis) {
  std::vector<double> numbers;
  std::vector<double> values;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const double number = number_on(record, i, axis);
    if (!std::isfinite(number) || !record.results[i].value) continue;
    numbers.push_back(number);
    values.push_back(*record.results[i].value);
  }
  return std::abs(rank_correlation(numbers, values).value_or(0.0));
}

/// The axis that a value is drawn over: what is refined, or the first axis of numbers, of sampled
/// ones that which moves the value most, or the first of words.
std::size_t value_axis(const SweepRecord& record) {
  if (record.refined) return *record.refined;
  const auto axes = varied_axes(record);
  std::optional<std::size_t> best;
  double strength = 0.0;
  for (const std::size_t a : axes) {
    if (record.axes[a].field->kind == FieldKind::Choice) continue;
    if (!record.axes[a].group.starts_with(' ')) return a;
    const double its = strength_of(record, a);
    if (best && its <= strength) continue;
    best = a;
    strength = its;
  }
  return best.value_or(axes.front());
}

/// x of a case: its number as it is shown, or the number of its word.
double x_of(const SweepRecord& record, std::size_t i, std::size_t axis, double scale) {
  if (record.axes[axis].field->kind != FieldKind::Choice) return number_on(record, i, axis) / scale;
  return static_cast<double>(record.position[i * record.axes.size() + axis]);
}

ChartAxis x_axis_of(const SweepRecord& record, std::size_t axis, const std::vector<double>& x) {
  const Axis& one = record.axes[axis];
  const std::string label = shown_axis(one).label;
  if (one.field->kind == FieldKind::Choice) {
    const auto count = static_cast<double>(one.values.size());
    ChartAxis words{label, false, {-0.5, count - 0.5}, {}};
    for (std::size_t k = 0; k < one.values.size(); ++k) {
      words.ticks.push_back({static_cast<double>(k), value_text(*one.field, one.values[k])});
    }
    return words;
  }
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const bool logarithmic =
      *low > 0.0 && *high > *low &&
      (*high / *low >= kLogarithmic || (record.refined && *record.refined == axis));
  std::vector<double> distinct = x;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() <= 24) return axis_at_values(label, distinct, logarithmic);
  if (logarithmic) return logarithmic_axis(label, x);
  ChartAxis plain = axis_at_values(label, {*low, *high}, false);
  plain.ticks.clear();
  return plain;
}

/// The reference that all picked cases share.
std::optional<double> common_reference(const PlotCases& cases) {
  std::optional<double> common;
  for (std::size_t i = 0; i < cases.picked.size(); ++i) {
    const auto& reference = cases.record.comparison.reference[i];
    if (!cases.picked[i] || !reference) continue;
    if (common && std::abs(*common - *reference) > 1e-12 * std::abs(*common)) return std::nullopt;
    common = reference;
  }
  return common;
}

double largest_value(const PlotCases& cases) {
  double largest = 0.0;
  for (std::size_t i = 0; i < cases.picked.size(); ++i) {
    const auto& value = cases.record.results[i].value;
    if (cases.picked[i] && value) largest = std::max(largest, std::abs(*value));
  }
  return largest;
}

/// Whether the cases of a line differ on the axis alone, so that a line may join them.
bool joins(const SweepRecord& record, std::size_t axis) {
  const Axis& one = record.axes[axis];
  return one.field->kind != FieldKind::Choice && !one.group.starts_with(' ');
}

}  // namespace

bool has_convergence(const SweepRecord& record) { return record.refined && record.has_errors(); }

bool has_values(const SweepRecord& record) {
  return !varied_axes(record).empty() &&
         std::any_of(record.results.begin(), record.results.end(),
                     [](const CaseResult& result) { return result.value.has_value(); });
}

bool has_trade(const SweepRecord& record) { return record.has_errors(); }

Chart convergence_chart(const PlotCases& cases) {
  const SweepRecord& record = cases.record;
  const Axis& axis = record.axes[*record.refined];
  const bool count = refinement_of(*axis.field) == Refinement::Count;
  const std::vector<CaseLine> lines = refinement_lines(cases);
  LineLooks looks = looks_of(record, lines, *record.refined);
  Chart chart{report::printable(record.name), subtitle_of(record), {}, {}};
  std::size_t zeros = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    ErrorLine line = error_line(record, lines[k], count);
    line.series.look = looks.looks[k];
    line.series.name = looks.names[k];
    if (!line.series.name.empty() && line.order) {
      line.series.name = fmt::format("order {:.2f}: {}", *line.order, line.series.name);
    }
    zeros += line.zeros;
    chart.series.push_back(std::move(line.series));
  }
  const Points all = all_points(chart);
  if (all.empty()) refuse_empty("an error");
  lift_zeros(chart, zeros);
  if (!looks.entries.empty()) add_order_guides(chart, count);
  chart.entries = std::move(looks.entries);
  chart.x = axis_at_values(convergence_label(axis), column(all, 0), true);
  chart.y = logarithmic_axis("size of the error [%]", column(all_points(chart), 1));
  return chart;
}

Chart value_chart(const PlotCases& cases) {
  const SweepRecord& record = cases.record;
  const std::size_t axis = value_axis(record);
  const std::vector<CaseLine> lines = lines_along(cases, axis);
  LineLooks looks = looks_of(record, lines, axis);
  Chart chart{report::printable(record.name), subtitle_of(record), {}, {}};
  const std::size_t every = (record.cases() + kMaxPoints - 1) / kMaxPoints;
  const double x_scale = shown_axis(record.axes[axis]).scale;
  const ShownNumbers shown = shown_value(record, largest_value(cases));
  for (std::size_t k = 0; k < lines.size(); ++k) {
    ChartSeries series{looks.names[k], looks.looks[k], {}, {}};
    if (!joins(record, axis)) series.look.line = false;
    for (const std::size_t i : lines[k].cases) {
      if (!record.results[i].value || i % every != 0) continue;
      const double x = x_of(record, i, axis, x_scale);
      if (std::isfinite(x)) series.points.push_back({x, *record.results[i].value / shown.scale});
    }
    chart.series.push_back(std::move(series));
  }
  const Points all = all_points(chart);
  if (all.empty()) refuse_empty("a value");
  if (every > 1) chart.subtitle += fmt::format(", {} of {} cases", all.size(), record.cases());
  chart.entries = std::move(looks.entries);
  chart.x = x_axis_of(record, axis, column(all, 0));
  std::vector<double> heights = column(all, 1);
  if (const auto reference = common_reference(cases)) {
    chart.series.push_back({"reference",
                            {std::string(report::kDark), 7, true, false, true, 1.2},
                            {{chart.x.range[0], *reference / shown.scale},
                             {chart.x.range[1], *reference / shown.scale}},
                            {}});
    heights.push_back(*reference / shown.scale);
  }
  chart.y = axis_at_values(shown.label, std::move(heights), false);
  chart.y.ticks.clear();
  return chart;
}

Chart trade_chart(const PlotCases& cases) {
  const SweepRecord& record = cases.record;
  const bool timed = record.timed_runs > 0;
  auto points = trade_points(record, timed ? CostKind::Seconds : CostKind::Work);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!cases.picked[i]) points[i].error = std::nan("");
  }
  const auto place = [&](std::size_t i) {
    return std::vector<double>{(timed ? 1e3 : 1.0) * points[i].cost, 100.0 * points[i].error};
  };
  const bool refined = record.refined.has_value();
  const std::size_t along =
      refined || varied_axes(record).empty() ? record.refined.value_or(0) : value_axis(record);
  const std::vector<CaseLine> lines = refined ? refinement_lines(cases) : lines_along(cases, along);
  LineLooks looks = looks_of(record, lines, along);
  Chart chart{report::printable(record.name), subtitle_of(record), {}, {}};
  const auto is_drawn = [&](std::size_t i) {
    return std::isfinite(points[i].error) && points[i].cost > 0.0;
  };
  // Behind the points; of several problems none is better than the other.
  ChartSeries front{"Pareto front", {"#C4C4C4", 7, true, false, false, 7.0}, {}, {}};
  if (!has_problems(record)) {
    for (const std::size_t i : pareto_front(points)) {
      if (is_drawn(i)) front.points.push_back(place(i));
    }
    chart.series.push_back(std::move(front));
  }
  std::size_t zeros = 0;
  std::size_t free = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    ChartSeries series{looks.names[k], looks.looks[k], {}, {}};
    series.look.line = refined && lines.size() <= 3 * kLooks;
    series.look.width = 0.8;
    for (const std::size_t i : lines[k].cases) {
      if (std::isfinite(points[i].error) && points[i].cost <= 0.0) ++free;
      if (!is_drawn(i)) continue;
      const bool exact = points[i].error == 0.0;
      if (exact) ++zeros;
      (exact ? series.hollow : series.points).push_back(place(i));
    }
    chart.series.push_back(std::move(series));
  }
  chart.entries = std::move(looks.entries);
  if (all_points(chart).empty()) refuse_empty("an error and a cost");
  if (free > 0) {
    chart.subtitle += "; without " + report::counted(free, "case") + " that cost nothing";
  }
  lift_zeros(chart, zeros);
  const Points all = all_points(chart);
  chart.x = logarithmic_axis(timed ? "time [ms]" : "work [segment-iterations]", column(all, 0));
  chart.y = logarithmic_axis("size of the error [%]", column(all, 1));
  for (const double guide : {1.0, 0.1, 0.01}) {
    if (guide > chart.y.range[0] && guide < chart.y.range[1]) chart.guides.push_back(guide);
  }
  return chart;
}

}  // namespace plastica::sweeps
