#include "sweeps/report/web/web_chart.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "plastica/report/scene_figure.hpp"
#include "plastica/report/web/web_blocks.hpp"

namespace plastica::sweeps {
namespace {

using report::FigureCurve;
using report::Json;
using report::Stroke;

Stroke stroke_of(const ChartLook& look) {
  if (look.line && look.symbols) return Stroke::Symbols;
  return look.line ? Stroke::Line : Stroke::Points;
}

/// Least and largest x of all points.
std::array<double, 2> reach_of(const Chart& chart) {
  std::array<double, 2> reach{std::numeric_limits<double>::infinity(), 0.0};
  reach[1] = -reach[0];
  for (const ChartSeries& series : chart.series) {
    for (const Points* points : {&series.points, &series.hollow}) {
      for (const auto& point : *points) {
        reach = {std::min(reach[0], point[0]), std::max(reach[1], point[0])};
      }
    }
  }
  return reach;
}

void add_ticks(Json& panel, const char* name, const ChartAxis& axis) {
  for (const ChartTick& tick : axis.ticks) panel[name].push_back({tick.at, tick.text});
}

}  // namespace

Json web_chart(std::string title, const Chart& chart) {
  const report::LogarithmicAxes logarithmic{chart.x.logarithmic, chart.y.logarithmic};
  Json curves = Json::array();
  const auto add = [&](const FigureCurve& curve) {
    curves.push_back(report::web_curve(curve, logarithmic));
  };
  for (const ChartSeries& series : chart.series) {
    const ChartLook& look = series.look;
    const int dashes = look.dashed ? std::max(1, look.dashes) : look.dashes;
    if (!series.points.empty()) {
      add({series.points, series.name, look.color, stroke_of(look), look.symbol, dashes});
    }
    // Open symbols, at the round-off floor.
    const std::string name = series.points.empty() ? series.name : std::string();
    if (!series.hollow.empty()) {
      add({series.hollow, name, look.color, Stroke::Points, look.symbol - 1});
    }
  }
  const auto reach = reach_of(chart);
  for (const double y : chart.guides) {
    add({{{reach[0], y}, {reach[1], y}}, "", report::kGrey, Stroke::Line, 7, 2});
  }
  report::FigurePanel panel{chart.subtitle, chart.x.label, chart.y.label};
  panel.x_range = chart.x.range;
  panel.y_range = chart.y.range;
  // What stands in the legend alone.
  for (const ChartSeries& entry : chart.entries) {
    const ChartLook& look = entry.look;
    add({{}, entry.name, look.color, stroke_of(look), look.symbol, look.dashes});
  }
  Json json = report::web_panel(panel, logarithmic, std::move(curves));
  add_ticks(json, "x_ticks", chart.x);
  add_ticks(json, "y_ticks", chart.y);
  Json panels = Json::array();
  panels.push_back(std::move(json));
  return report::web_panels(std::move(title), std::move(panels));
}

}  // namespace plastica::sweeps
