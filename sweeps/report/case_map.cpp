#include "sweeps/report/case_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "plastica/base/check.hpp"
#include "sweeps/report/case_rows.hpp"

namespace plastica::sweeps {
namespace {

constexpr std::size_t kMaxPanels = 9;
constexpr double kLogarithmicMap = 3.0;  ///< ratio of values from which an axis is logarithmic

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

/// Cases of each panel, in the order of the other axes.
std::vector<MapPanel> panels_of(const PlotCases& cases, const CaseMap& map) {
  const SweepRecord& record = cases.record;
  std::vector<std::size_t> others;
  for (const std::size_t a : varied_axes(record)) {
    if (!is_told_by(record, a, map.x.axis) && !is_told_by(record, a, map.y.axis)) {
      others.push_back(a);
    }
  }
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> panels;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    // A field needs both of its coordinates.
    const bool placed = std::isfinite(map.x.of(record, i)) && std::isfinite(map.y.of(record, i));
    if (!cases.picked[i] || !placed) continue;
    std::vector<std::size_t> key;
    key.reserve(others.size());
    for (const std::size_t a : others) key.push_back(key_on(record, i, a));
    panels[key].push_back(i);
  }
  if (panels.size() > kMaxPanels) {
    throw InputError({}, "--case", "",
                     fmt::format("is needed: a picture has at most {} maps, and there are {}; AXIS "
                                 "= VALUE, … picks some",
                                 kMaxPanels, panels.size()));
  }
  std::vector<MapPanel> all;
  all.reserve(panels.size());
  for (auto& [key, members] : panels) {
    const std::string title =
        others.empty() ? std::string() : short_setting(record, members.front(), others);
    all.push_back({title, std::move(members)});
  }
  return all;
}

MapAxis map_axis(const PlotCases& cases, std::size_t axis) {
  const ShownNumbers shown = shown_axis(cases.record.axes[axis]);
  MapAxis out{axis, shown.label, shown.scale, {}, {}};
  for (std::size_t i = 0; i < cases.record.cases(); ++i) {
    const double value = out.of(cases.record, i);
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

}  // namespace

std::size_t MapAxis::at(double value) const {
  return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) -
                                  values.begin());
}

double MapAxis::of(const SweepRecord& record, std::size_t index) const {
  return number_on(record, index, axis) / scale;
}

bool has_map(const SweepRecord& record) { return axes_of_map(record).size() == 2; }

CaseMap case_map(const PlotCases& cases) {
  const auto axes = axes_of_map(cases.record);
  CaseMap map{map_axis(cases, axes[0]), map_axis(cases, axes[1]), {}, classify(cases), {}};
  map.panels = panels_of(cases, map);
  if (map.classes.of_errors) map.limits = error_limits(cases.record);
  // Said wherever a map is drawn.
  std::size_t placed = 0;
  for (const MapPanel& panel : map.panels) placed += panel.cases.size();
  const auto picked = static_cast<std::size_t>(std::ranges::count(cases.picked, true));
  if (placed < picked) {
    const std::string rest =
        fmt::format("; {} of {} cases, the others have no number on an axis", placed, picked);
    map.classes.what += rest;
    if (!map.limits.empty()) map.limits += rest;
  }
  return map;
}

}  // namespace plastica::sweeps
