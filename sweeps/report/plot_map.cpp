#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "sweeps/report/case_rows.hpp"
#include "sweeps/report/plot_charts.hpp"
#include "sweeps/report/plot_classes.hpp"

namespace plastica::sweeps {
namespace {

using report::in_quotes;
using report::PlotScript;

constexpr std::size_t kMaxPanels = 9;
constexpr double kLogarithmicMap = 3.0;  ///< ratio of values from which an axis is logarithmic

/// What is drawn of a sweep: its axes and colours.
struct Map {
  std::size_t x = 0;
  std::size_t y = 0;
  double x_scale = 1.0;  ///< shown = SI value / scale
  double y_scale = 1.0;
  std::vector<std::size_t> others;  ///< axes whose values make panels
  CaseClasses colors;
};

/// The first two varied axes of numbers that are crossed.
std::vector<std::size_t> axes_of_map(const SweepRecord& record) {
  std::vector<std::size_t> axes;
  for (const std::size_t a : varied_axes(record)) {
    if (record.axes[a].field->kind == FieldKind::Choice) continue;
    const std::string& group = record.axes[a].group;
    if (group.starts_with(' ')) continue;  // a cloud
    if (axes.size() == 1 && !group.empty() && record.axes[axes[0]].group == group) continue;
    axes.push_back(a);
    if (axes.size() == 2) break;
  }
  return axes;
}

/// Coordinates as they are shown.
double x_of(const SweepRecord& record, std::size_t i, const Map& map) {
  return number_on(record, i, map.x) / map.x_scale;
}
double y_of(const SweepRecord& record, std::size_t i, const Map& map) {
  return number_on(record, i, map.y) / map.y_scale;
}

/// Whether the value on an axis of a map says where a case is on another axis: its own, or one that
/// moves together with it, if no value of the map's axis stands for several of that.
bool is_told_by(const SweepRecord& record, std::size_t other, std::size_t axis) {
  if (other == axis) return true;
  const Axis& told = record.axes[other];
  const Axis& by = record.axes[axis];
  if (by.group.empty() || told.group != by.group) return false;
  for (std::size_t a = 0; a < by.values.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (by.values[a] == by.values[b] && !(told.values[a] == told.values[b])) return false;
    }
  }
  return true;
}

/// The number of a case's value on an axis; equal values have the same.
std::size_t key_on(const SweepRecord& record, std::size_t i, std::size_t axis) {
  const auto& values = record.axes[axis].values;
  return static_cast<std::size_t>(std::find(values.begin(), values.end(), record.at(i, axis)) -
                                  values.begin());
}

Map map_of(const PlotCases& cases) {
  const SweepRecord& record = cases.record;
  const auto axes = axes_of_map(record);
  Map map;
  map.x = axes[0];
  map.y = axes[1];
  map.x_scale = shown_axis(record.axes[map.x]).scale;
  map.y_scale = shown_axis(record.axes[map.y]).scale;
  for (const std::size_t a : varied_axes(record)) {
    if (!is_told_by(record, a, map.x) && !is_told_by(record, a, map.y)) map.others.push_back(a);
  }
  map.colors = classify(cases);
  return map;
}

/// Cases of each panel, in the order of the other axes.
std::vector<std::vector<std::size_t>> panels_of(const PlotCases& cases, const Map& map) {
  const SweepRecord& record = cases.record;
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> panels;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    // A field needs both of its coordinates.
    const bool placed = std::isfinite(x_of(record, i, map)) && std::isfinite(y_of(record, i, map));
    if (!cases.picked[i] || !placed) continue;
    std::vector<std::size_t> key;
    key.reserve(map.others.size());
    for (const std::size_t a : map.others) {
      key.push_back(key_on(record, i, a));
    }
    panels[key].push_back(i);
  }
  if (panels.size() > kMaxPanels) {
    throw InputError({}, "--case", "",
                     fmt::format("is needed: a picture has at most {} maps, and there are {}; AXIS "
                                 "= VALUE, … picks some",
                                 kMaxPanels, panels.size()));
  }
  std::vector<std::vector<std::size_t>> all;
  all.reserve(panels.size());
  for (auto& [key, members] : panels) all.push_back(std::move(members));
  return all;
}

/// Where fields begin and end along an axis.
struct Edges {
  std::vector<double> values;  ///< rising (n)
  std::vector<double> edges;   ///< (n + 1)
  bool logarithmic = false;
  std::size_t at(double value) const {
    return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) -
                                    values.begin());
  }
};

Edges edges_of(const PlotCases& cases, std::size_t axis) {
  Edges out;
  const double scale = shown_axis(cases.record.axes[axis]).scale;
  for (std::size_t i = 0; i < cases.record.cases(); ++i) {
    const double value = number_on(cases.record, i, axis) / scale;
    if (cases.picked[i] && std::isfinite(value)) out.values.push_back(value);
  }
  std::sort(out.values.begin(), out.values.end());
  out.values.erase(std::unique(out.values.begin(), out.values.end()), out.values.end());
  if (out.values.empty()) throw InputError({}, "--case", "", "picks no case of the map");
  out.logarithmic =
      out.values.front() > 0.0 && out.values.back() / out.values.front() >= kLogarithmicMap;
  std::vector<double> places;
  places.reserve(out.values.size());
  for (const double value : out.values) {
    places.push_back(out.logarithmic ? std::log(value) : value);
  }
  const std::size_t n = places.size();
  const double first = n > 1 ? 0.5 * (places[1] - places[0]) : 0.5;
  const double last = n > 1 ? 0.5 * (places[n - 1] - places[n - 2]) : 0.5;
  out.edges.push_back(places.front() - first);
  for (std::size_t k = 0; k + 1 < n; ++k) out.edges.push_back(0.5 * (places[k] + places[k + 1]));
  out.edges.push_back(places.back() + last);
  if (out.logarithmic) {
    for (double& edge : out.edges) edge = std::exp(edge);
  }
  return out;
}

ChartAxis axis_of(const SweepRecord& record, std::size_t axis, const Edges& edges) {
  ChartAxis out =
      axis_at_values(shown_axis(record.axes[axis]).label, edges.values, edges.logarithmic);
  out.range = {edges.edges.front(), edges.edges.back()};
  return out;
}

std::string panel_title(const SweepRecord& record, const Map& map,
                        const std::vector<std::size_t>& members) {
  return map.others.empty() ? std::string() : short_setting(record, members.front(), map.others);
}

std::string title_of(const SweepRecord& record, const Map& map) {
  return report::printable(record.name) + ": " + map.colors.what;
}

/// A dark field takes light numbers.
bool is_dark(const std::string& color) {
  const auto part = [&](std::size_t at) { return std::stoi(color.substr(at, 2), nullptr, 16); };
  return 0.3 * part(1) + 0.59 * part(3) + 0.11 * part(5) < 140.0;
}

void add_numbers(PlotScript& script, const SweepRecord& record, const Map& map,
                 const std::vector<std::size_t>& members) {
  for (const std::size_t i : members) {
    if (map.colors.number[i].empty() || !map.colors.class_of[i]) continue;
    script.command(fmt::format(
        "set label {} at {:.9g}, {:.9g} center front font ',10' textcolor rgb '{}'",
        in_quotes(map.colors.number[i]), x_of(record, i, map), y_of(record, i, map),
        is_dark(map.colors.classes[*map.colors.class_of[i]].color) ? "#FFFFFF" : "#222222"));
  }
}

/// @param wide  of the panel [units of a page]
bool numbers_have_room(const Map& map, const std::vector<std::size_t>& members, const Edges& x,
                       double wide) {
  constexpr double kLetter = 6.0;  // of their size
  std::size_t longest = 0;
  for (const std::size_t i : members) {
    longest = std::max(longest, report::width_of(map.colors.number[i]));
  }
  const double narrowest = wide / static_cast<double>(x.edges.size() - 1);
  return kLetter * static_cast<double>(longest + 1) <= narrowest;
}

void add_fields(PlotScript& script, const SweepRecord& record, const Map& map,
                const std::vector<std::size_t>& members, const Edges& x, const Edges& y) {
  for (std::size_t c = 0; c < map.colors.classes.size(); ++c) {
    Points boxes;
    for (const std::size_t i : members) {
      if (map.colors.class_of[i] != c) continue;
      const double at_x = x_of(record, i, map);
      const double at_y = y_of(record, i, map);
      const std::size_t column = x.at(at_x);
      const std::size_t row = y.at(at_y);
      boxes.push_back(
          {at_x, at_y, x.edges[column], x.edges[column + 1], y.edges[row], y.edges[row + 1]});
    }
    const std::string color = fmt::format("linecolor rgb '{}'", map.colors.classes[c].color);
    if (!boxes.empty()) {
      script.add_unnamed(script.add_points(boxes),
                         "using 1:2:3:4:5:6 with boxxyerror fillstyle solid 1.0 noborder " + color);
    }
  }
}

}  // namespace

bool has_map(const SweepRecord& record) { return axes_of_map(record).size() == 2; }

PlotScript map_page(const PlotCases& cases, const report::Sheet& sheet) {
  const SweepRecord& record = cases.record;
  const Map map = map_of(cases);
  const auto panels = panels_of(cases, map);
  const Edges x = edges_of(cases, map.x);
  const Edges y = edges_of(cases, map.y);
  PlotScript script(sheet);
  const bool single = panels.size() == 1;
  std::string title = title_of(record, map);
  const std::string limits = map.colors.of_errors ? error_limits(record) : std::string();
  if (!single && limits.starts_with("error of")) {
    title = report::printable(record.name) + ": " + limits;
  }
  script.begin_panels(panels.size(), single ? std::string() : title);
  script.command("unset grid");
  for (std::size_t p = 0; p < panels.size(); ++p) {
    ChartAxis x_axis = axis_of(record, map.x, x);
    ChartAxis y_axis = axis_of(record, map.y, y);
    if (!single && !script.at_left()) y_axis.label.clear();
    if (!single && !script.at_bottom()) x_axis.label.clear();
    script.command(axis_commands(x_axis, 'x', script.panel_width()) + axis_commands(y_axis, 'y') +
                   "unset label");
    script.set_y_label(y_axis.label);
    const std::string name = panel_title(record, map, panels[p]);
    const std::string below = single && !limits.empty() ? limits : name;
    script.begin_panel(single ? std::vector{title, below} : std::vector{name});
    if (numbers_have_room(map, panels[p], x, script.panel_width())) {
      add_numbers(script, record, map, panels[p]);
    }
    add_fields(script, record, map, panels[p], x, y);
    if (p + 1 == panels.size()) {
      for (const CaseClass& one : map.colors.classes) {
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
  const Map map = map_of(cases);
  const auto panels = panels_of(cases, map);
  const Edges x = edges_of(cases, map.x);
  const Edges y = edges_of(cases, map.y);
  PlotScript script;
  script.command(
      "unset grid\nset border 3\nset tics scale 0.5\nset key outside bottom center horizontal "
      "samplen 3");
  script.terminal_rows = 22 * static_cast<int>(panels.size());
  if (panels.size() > 1) script.command(fmt::format("set multiplot layout {},1", panels.size()));
  ChartAxis y_axis = axis_of(record, map.y, y);
  const std::string y_label = std::exchange(y_axis.label, "");
  script.command(axis_commands(axis_of(record, map.x, x), 'x') + axis_commands(y_axis, 'y'));
  for (const auto& members : panels) {
    const std::string name = panel_title(record, map, members);
    std::string below = fmt::format("{}{}over {}", name, name.empty() ? "" : "; ", y_label);
    const std::string limits = map.colors.of_errors ? error_limits(record) : std::string();
    if (!limits.empty() && name.empty()) below = fmt::format("{}, over {}", limits, y_label);
    script.command("set title " + in_quotes({title_of(record, map), below}, 76));
    std::string plot;
    for (std::size_t c = 0; c < map.colors.classes.size(); ++c) {
      Points points;
      for (const std::size_t i : members) {
        if (map.colors.class_of[i] == c) {
          points.push_back({x_of(record, i, map), y_of(record, i, map)});
        }
      }
      if (points.empty()) continue;
      plot += fmt::format("{}{} using 1:2 with points pointtype '{}' title {}",
                          plot.empty() ? "plot " : ", \\\n     ", script.add_points(points),
                          map.colors.classes[c].letter, in_quotes(map.colors.classes[c].name));
    }
    script.command(plot);
  }
  if (panels.size() > 1) script.command("unset multiplot");
  return script;
}

}  // namespace plastica::sweeps
