#include "sweeps/report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>

#include "plastica/base/check.hpp"
#include "plastica/report/picture.hpp"
#include "sweeps/report/case_map.hpp"
#include "sweeps/report/plot_charts.hpp"
#include "sweeps/report/select.hpp"

namespace plastica::sweeps {
namespace {

using report::PlotScript;

struct Kind {
  SweepPlotKind words;
  bool (*there)(const SweepRecord& record);
  Chart (*chart)(const PlotCases& cases);  ///< null: a map
};

constexpr std::array<Kind, 5> kKinds{{
    {{"convergence", "error over what is refined, a line a group, with its order"},
     has_convergence,
     convergence_chart},
    {{"value", "what is compared over the refined axis, or the first one"},
     has_values,
     value_chart},
    {{"curve", "the curves that are compared (--case ID, or AXIS = VALUE)"},
     has_curves,
     curve_chart},
    {{"trade", "error over cost, with the Pareto front"}, has_trade, trade_chart},
    {{"map", "error, value or status over two axes (--case AXIS = VALUE)"}, has_map, nullptr},
}};

std::vector<const Kind*> kinds_of(const SweepRecord& record) {
  std::vector<const Kind*> kinds;
  for (const Kind& kind : kKinds) {
    if (kind.there(record)) kinds.push_back(&kind);
  }
  return kinds;
}

const Kind& find_kind(const SweepRecord& record, const std::string& what) {
  const auto kinds = kinds_of(record);
  if (kinds.empty()) throw InputError({}, "plot", what, "there is no value to draw");
  if (what.empty()) return *kinds.front();
  std::string names;
  for (const Kind* kind : kinds) {
    if (kind->words.name == what) return *kind;
    names += (names.empty() ? "" : ", ") + std::string(kind->words.name);
  }
  throw InputError({}, "--what", what, "must be one of " + names + " for this file");
}

PlotScript make(const SweepRecord& record, const SweepPlotRequest& request) {
  const Kind& kind = find_kind(record, request.what);
  PlotCases cases{record, std::vector<bool>(record.cases(), request.cases.empty())};
  if (!request.cases.empty()) {
    for (const std::size_t i : select_cases(record, request.cases)) cases.picked[i] = true;
  }
  const report::Sheet sheet = report::sheet_of(request.output, request.width);
  if (kind.chart == nullptr) return sheet.terminal ? map_terminal(cases) : map_page(cases, sheet);
  const Chart chart = kind.chart(cases);
  return sheet.terminal ? chart_terminal(chart) : chart_page(chart, sheet);
}

}  // namespace

std::span<const SweepPlotKind> sweep_plot_kinds() {
  static const auto words = [] {
    std::array<SweepPlotKind, kKinds.size()> all;
    std::transform(kKinds.begin(), kKinds.end(), all.begin(),
                   [](const Kind& kind) { return kind.words; });
    return all;
  }();
  return words;
}

std::vector<SweepPlotKind> sweep_plot_kinds_of(const SweepRecord& record) {
  std::vector<SweepPlotKind> words;
  for (const Kind* kind : kinds_of(record)) words.push_back(kind->words);
  return words;
}

std::string sweep_plot_script(const SweepRecord& record, const SweepPlotRequest& request) {
  return make(record, request).text();
}

void draw_sweep_plot(const SweepRecord& record, const SweepPlotRequest& request,
                     std::ostream& standard_output) {
  report::check_picture_output(request.output);
  report::draw_picture(make(record, request), request.output, standard_output, request.overwrite);
}

}  // namespace plastica::sweeps
