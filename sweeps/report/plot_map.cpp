#include <fmt/format.h>

#include <utility>

#include "plastica/report/format.hpp"
#include "sweeps/report/case_map.hpp"
#include "sweeps/report/plot_charts.hpp"

namespace plastica::sweeps {
namespace {

using report::in_quotes;
using report::PlotScript;

ChartAxis chart_axis(const MapAxis& axis) {
  ChartAxis out = axis_at_values(axis.label, axis.values, axis.logarithmic);
  out.range = {axis.edges.front(), axis.edges.back()};
  return out;
}

std::string title_of(const SweepRecord& record, const CaseMap& map) {
  return report::printable(record.name) + ": " + map.classes.what;
}

/// A dark field takes light numbers.
bool is_dark(const std::string& color) {
  const auto part = [&](std::size_t at) { return std::stoi(color.substr(at, 2), nullptr, 16); };
  return 0.3 * part(1) + 0.59 * part(3) + 0.11 * part(5) < 140.0;
}

void add_numbers(PlotScript& script, const SweepRecord& record, const CaseMap& map,
                 const std::vector<std::size_t>& members) {
  for (const std::size_t i : members) {
    if (map.classes.number[i].empty() || !map.classes.class_of[i]) continue;
    script.command(fmt::format(
        "set label {} at {:.9g}, {:.9g} center front font ',10' textcolor rgb '{}'",
        in_quotes(map.classes.number[i]), map.x.of(record, i), map.y.of(record, i),
        is_dark(map.classes.classes[*map.classes.class_of[i]].color) ? "#FFFFFF" : "#222222"));
  }
}

/// @param wide  of the panel [units of a page]
bool numbers_have_room(const CaseMap& map, const std::vector<std::size_t>& members, double wide) {
  constexpr double kLetter = 6.0;  // of their size
  std::size_t longest = 0;
  for (const std::size_t i : members) {
    longest = std::max(longest, report::width_of(map.classes.number[i]));
  }
  const double narrowest = wide / static_cast<double>(map.x.edges.size() - 1);
  return kLetter * static_cast<double>(longest + 1) <= narrowest;
}

void add_fields(PlotScript& script, const SweepRecord& record, const CaseMap& map,
                const std::vector<std::size_t>& members) {
  for (std::size_t c = 0; c < map.classes.classes.size(); ++c) {
    Points boxes;
    for (const std::size_t i : members) {
      if (map.classes.class_of[i] != c) continue;
      const double at_x = map.x.of(record, i);
      const double at_y = map.y.of(record, i);
      const std::size_t column = map.x.at(at_x);
      const std::size_t row = map.y.at(at_y);
      boxes.push_back({at_x, at_y, map.x.edges[column], map.x.edges[column + 1], map.y.edges[row],
                       map.y.edges[row + 1]});
    }
    const std::string color = fmt::format("linecolor rgb '{}'", map.classes.classes[c].color);
    if (!boxes.empty()) {
      script.add_unnamed(script.add_points(boxes),
                         "using 1:2:3:4:5:6 with boxxyerror fillstyle solid 1.0 noborder " + color);
    }
  }
}

}  // namespace

PlotScript map_page(const PlotCases& cases, const report::Sheet& sheet) {
  const SweepRecord& record = cases.record;
  const CaseMap map = case_map(cases);
  PlotScript script(sheet);
  const bool single = map.panels.size() == 1;
  std::string title = title_of(record, map);
  if (!single && map.limits.starts_with("error of")) {
    title = report::printable(record.name) + ": " + map.limits;
  }
  script.begin_panels(map.panels.size(), single ? std::string() : title);
  script.command("unset grid");
  for (std::size_t p = 0; p < map.panels.size(); ++p) {
    ChartAxis x_axis = chart_axis(map.x);
    ChartAxis y_axis = chart_axis(map.y);
    if (!single && !script.at_left()) y_axis.label.clear();
    if (!single && !script.at_bottom()) x_axis.label.clear();
    script.command(axis_commands(x_axis, 'x', script.panel_width()) + axis_commands(y_axis, 'y') +
                   "unset label");
    script.set_x_label(x_axis.label);
    script.set_y_label(y_axis.label);
    const std::string& name = map.panels[p].title;
    const std::string below = single && !map.limits.empty() ? map.limits : name;
    script.begin_panel(single ? std::vector{title, below} : std::vector{name});
    if (numbers_have_room(map, map.panels[p].cases, script.panel_width())) {
      add_numbers(script, record, map, map.panels[p].cases);
    }
    add_fields(script, record, map, map.panels[p].cases);
    if (p + 1 == map.panels.size()) {
      for (const CaseClass& one : map.classes.classes) {
        script.add_entry(fmt::format("with lines linewidth 9 linecolor rgb '{}'", one.color),
                         one.name);
      }
    }
    script.end_panel();
  }
  return script;
}

PlotScript map_terminal(const PlotCases& cases) {
  const SweepRecord& record = cases.record;
  const CaseMap map = case_map(cases);
  PlotScript script;
  script.command(
      "unset grid\nset border 3\nset tics scale 0.5\nset key outside bottom center horizontal "
      "samplen 3");
  script.terminal_rows = 22 * static_cast<int>(map.panels.size());
  if (map.panels.size() > 1)
    script.command(fmt::format("set multiplot layout {},1", map.panels.size()));
  ChartAxis y_axis = chart_axis(map.y);
  const std::string y_label = std::exchange(y_axis.label, "");
  script.command(axis_commands(chart_axis(map.x), 'x') + axis_commands(y_axis, 'y'));
  for (const MapPanel& panel : map.panels) {
    const std::string& name = panel.title;
    std::string below = fmt::format("{}{}over {}", name, name.empty() ? "" : "; ", y_label);
    if (!map.limits.empty() && name.empty()) {
      below = fmt::format("{}, over {}", map.limits, y_label);
    }
    script.command("set title " + in_quotes({title_of(record, map), below}, 76));
    std::string plot;
    for (std::size_t c = 0; c < map.classes.classes.size(); ++c) {
      Points points;
      for (const std::size_t i : panel.cases) {
        if (map.classes.class_of[i] == c) {
          points.push_back({map.x.of(record, i), map.y.of(record, i)});
        }
      }
      if (points.empty()) continue;
      plot += fmt::format("{}{} using 1:2 with points pointtype '{}' title {}",
                          plot.empty() ? "plot " : ", \\\n     ", script.add_points(points),
                          map.classes.classes[c].letter, in_quotes(map.classes.classes[c].name));
    }
    script.command(plot);
  }
  if (map.panels.size() > 1) script.command("unset multiplot");
  return script;
}

}  // namespace plastica::sweeps
