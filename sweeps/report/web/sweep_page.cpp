#include "sweeps/report/web/sweep_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "plastica/model/field.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/web/web_blocks.hpp"
#include "sweeps/report/case_map.hpp"
#include "sweeps/report/case_rows.hpp"
#include "sweeps/report/plot_charts.hpp"
#include "sweeps/report/text.hpp"
#include "sweeps/report/web/web_chart.hpp"
#include "sweeps/report/web/web_map.hpp"
#include "sweeps/trade/setting.hpp"

namespace plastica::sweeps {
namespace {

using report::Json;
using report::number;
using report::WebPage;
using report::WebTab;

/// Cases that a page shows at most, each with its report up to so many.
constexpr std::size_t kMostRows = 20'000;
constexpr std::size_t kMostReports = 2'000;

Json web_cell(const FieldValue& value) {
  if (const auto* amount = std::get_if<double>(&value)) return number(*amount);
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  return "unset";
}

bool is_number(const Axis& axis) { return axis.field->kind != FieldKind::Choice; }

std::string unit_of(const Axis& axis) { return shown_unit_of(si_unit(axis.field->dimension)); }

Json cases_block(const SweepRecord& record, std::size_t shown, bool details) {
  report::WebTable table("");
  if (details) table.open_details();
  table.add_words("case");
  for (const Axis& axis : record.axes) {
    const std::string name(axis.field->path);
    if (is_number(axis)) {
      table.add_numbers(name, unit_of(axis));
    } else {
      table.add_words(name);
    }
  }
  table.add_words("status");
  if (!record.quantity.is_curve()) {
    table.add_numbers(record.quantity.name, shown_unit_of(record.quantity.unit));
  }
  if (record.has_errors()) table.add_numbers("error", "%", "against " + record.against);
  table.add_numbers("work", "", "segments times iterations");
  table.add_numbers("time", "s", "CPU time of the run");
  table.add_words("remark");
  for (std::size_t i = 0; i < shown; ++i) {
    const CaseResult& result = record.results[i];
    Json cells = {std::to_string(i + 1)};
    for (std::size_t a = 0; a < record.axes.size(); ++a) cells.push_back(web_cell(record.at(i, a)));
    cells.push_back(name_of(result.status));
    if (!record.quantity.is_curve()) cells.push_back(number(result.value));
    const std::optional<double>& error = record.comparison.error[i];
    if (record.has_errors()) cells.push_back(error ? number(100.0 * *error) : Json(nullptr));
    cells.push_back(result.segment_iterations());
    cells.push_back(number(result.seconds));
    cells.push_back(remark_of(record, i));
    table.add_row(std::move(cells));
  }
  return table.block();
}

/// Error over cost, a point a case that says its setting; of one problem the front of those that
/// none beats.
Json trade_block(const SweepRecord& record) {
  const bool timed = record.timed_runs > 0;
  const auto points = trade_points(record, timed ? CostKind::Seconds : CostKind::Work);
  std::size_t exact = 0;
  std::size_t free = 0;
  report::FigureCurve all{{}, "cases", report::kBlue, report::Stroke::Points};
  std::vector<std::string> labels;
  const auto is_there = [](const TradePoint& p) {
    return std::isfinite(p.cost) && std::isfinite(p.error) && p.error > 0.0 && p.cost > 0.0;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].error == 0.0) ++exact;
    if (points[i].error > 0.0 && points[i].cost == 0.0) ++free;
    if (!is_there(points[i])) continue;
    all.points.push_back({points[i].cost, 100.0 * points[i].error});
    labels.push_back(setting_text(record, i));
  }
  report::FigureCurve front{{}, "Pareto front", report::kVermillion};
  for (const std::size_t i : pareto_front(points)) {
    if (is_there(points[i])) front.points.push_back({points[i].cost, 100.0 * points[i].error});
  }
  std::string without;
  if (exact > 0) without = report::counted(exact, "case") + " whose error is 0";
  if (free > 0) {
    without += (exact > 0 ? ", " : "") + report::counted(free, "case") + " that cost nothing";
  }
  const report::FigurePanel panel{without.empty() ? "" : "without " + without,
                                  timed ? "CPU time [s]" : "work: segments times iterations",
                                  "size of the error [%]"};
  const report::LogarithmicAxes logarithmic{true, true};
  Json curves = Json::array();
  if (!has_problems(record)) curves.push_back(report::web_curve(front, logarithmic, 0));
  curves.push_back(report::web_curve(all, logarithmic, 0, labels));
  Json panels = Json::array();
  panels.push_back(report::web_panel(panel, logarithmic, std::move(curves)));
  return report::web_panels("Error against cost", std::move(panels));
}

bool has_trade_points(const SweepRecord& record) {
  return std::ranges::any_of(record.comparison.error,
                             [](const auto& error) { return error && *error != 0.0; });
}

/// What a page of so many cases has not.
Json left_out(const SweepRecord& record, std::size_t shown) {
  std::vector<std::string> notes{fmt::format(
      "the report of each case, of more than {}: plastica show --case has it", kMostReports)};
  if (shown < record.cases()) {
    notes.push_back(
        fmt::format("{} of {} cases, the picture of error against cost and the map: plastica show "
                    "--all and plastica plot --what trade and map have them",
                    record.cases() - shown, record.cases()));
  }
  return report::web_notes("Left out", notes, "note");
}

/// Of more curves than a picture has, what to do: all that `curve_chart` refuses where there are
/// any.
Json curves_block(const PlotCases& cases) {
  try {
    return web_chart("Curves", curve_chart(cases));
  } catch (const InputError&) {
    return report::web_notes(
        "Curves", {"of all cases there are too many: plastica plot --case draws some"}, "note");
  }
}

/// The same of maps.
Json map_block(const PlotCases& cases) {
  const bool opens = cases.record.cases() <= kMostReports;
  try {
    return web_map("Map", case_map(cases), cases.record, opens);
  } catch (const InputError&) {
    return report::web_notes(
        "Map", {"there are too many: plastica plot --what map --case draws some"}, "note");
  }
}

WebTab pictures_tab(const SweepRecord& record) {
  WebTab tab{"Pictures", Json::array()};
  const PlotCases cases{record, std::vector<bool>(record.cases(), true)};
  if (has_trade_points(record) && record.cases() <= kMostRows) {
    tab.blocks.push_back(trade_block(record));
  }
  if (has_convergence(record)) {
    tab.blocks.push_back(web_chart("Convergence", convergence_chart(cases)));
  }
  if (has_map(record) && record.cases() <= kMostRows) tab.blocks.push_back(map_block(cases));
  if (has_values(record)) tab.blocks.push_back(web_chart("Values", value_chart(cases)));
  if (has_curves(record)) tab.blocks.push_back(curves_block(cases));
  return tab;
}

}  // namespace

WebPage sweep_page(const SweepRecord& record, const std::string& file) {
  WebPage page{report::printable(record.name), what_was_swept(record)};
  const std::size_t shown = std::min(record.cases(), kMostRows);
  const bool details = record.cases() <= kMostReports;
  WebTab cases{"Cases", Json::array()};
  if (!record.warnings.empty()) {
    cases.blocks.push_back(report::web_notes("Warnings", record.warnings, "warning"));
  }
  if (!record.comparison.notes.empty()) {
    cases.blocks.push_back(report::web_notes("About the errors", record.comparison.notes, "note"));
  }
  cases.blocks.push_back(cases_block(record, shown, details));
  if (!details) cases.blocks.push_back(left_out(record, shown));
  page.tabs.push_back(std::move(cases));
  WebTab pictures = pictures_tab(record);
  if (!pictures.blocks.empty()) page.tabs.push_back(std::move(pictures));
  WebTab text{"Report", Json::array()};
  text.blocks.push_back(report::web_text("Report", sweep_report(record)));
  page.tabs.push_back(std::move(text));
  page.tabs.push_back(report::provenance_tab(file, record.meta, record.inputs));
  for (std::size_t i = 0; details && i < shown; ++i) {
    WebTab detail{fmt::format("Case {}: {}", i + 1, setting_text(record, i)), Json::array()};
    detail.blocks.push_back(report::web_text("Report", case_report(record, i)));
    page.details.push_back(report::part_text(detail));
  }
  return page;
}

}  // namespace plastica::sweeps
