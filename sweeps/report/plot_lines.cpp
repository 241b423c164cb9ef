#include "sweeps/report/plot_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "plastica/report/format.hpp"
#include "sweeps/report/case_rows.hpp"

namespace plastica::sweeps {
namespace {

bool moves_with(const SweepRecord& record, std::size_t axis, std::size_t other) {
  const std::string& group = record.axes[axis].group;
  return axis == other || (!group.empty() && record.axes[other].group == group);
}

/// How many different values some axes have together, which move together.
std::size_t count_together(const SweepRecord& record, const std::vector<std::size_t>& axes) {
  std::set<std::vector<FieldValue>> seen;
  for (std::size_t k = 0; k < record.axes[axes.front()].values.size(); ++k) {
    std::vector<FieldValue> values;
    values.reserve(axes.size());
    for (const std::size_t a : axes) values.push_back(record.axes[a].values[k]);
    seen.insert(std::move(values));
  }
  return seen.size();
}

/// Axes that tell lines along an axis apart; of those that move together only as many as it takes.
std::vector<std::size_t> other_axes(const SweepRecord& record, std::size_t along) {
  std::vector<std::size_t> axes;
  for (const std::size_t a : varied_axes(record)) {
    if (moves_with(record, along, a)) continue;
    std::vector<std::size_t> together;
    for (const std::size_t b : axes) {
      if (moves_with(record, a, b)) together.push_back(b);
    }
    if (!together.empty()) {
      const std::size_t before = count_together(record, together);
      together.push_back(a);
      if (count_together(record, together) == before) continue;
    }
    axes.push_back(a);
  }
  return axes;
}

std::size_t place_of(const SweepRecord& record, const CaseLine& line, std::size_t axis) {
  return record.position[line.cases.front() * record.axes.size() + axis];
}

/// Which values of an axis the lines have: words in their order, numbers by size.
std::vector<std::size_t> places_on(const SweepRecord& record, const std::vector<CaseLine>& lines,
                                   std::size_t axis) {
  std::vector<std::size_t> places;
  places.reserve(lines.size());
  for (const CaseLine& line : lines) places.push_back(place_of(record, line, axis));
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  if (record.axes[axis].field->kind != FieldKind::Choice) {
    const auto& values = record.axes[axis].values;
    // What is not set comes first.
    std::stable_sort(places.begin(), places.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  }
  return places;
}

/// By value, the number of each among those that there are.
std::map<std::size_t, std::size_t> ranks_of(const std::vector<std::size_t>& places) {
  std::map<std::size_t, std::size_t> ranks;
  for (std::size_t k = 0; k < places.size(); ++k) ranks[places[k]] = k;
  return ranks;
}

std::string value_name(const SweepRecord& record, std::size_t axis, std::size_t place) {
  const Axis& one = record.axes[axis];
  std::string value = value_text(*one.field, one.values[place]);
  if (one.field->kind == FieldKind::Choice) return value;
  const std::string_view path = one.field->path;
  return std::string(path.substr(path.rfind('.') + 1)) + " " + value;
}

ShownNumbers shown_numbers(const std::string& name, const report::DisplayUnit& unit) {
  const std::string shown = shown_unit_of(unit.name);
  return {shown.empty() ? name : fmt::format("{} [{}]", name, shown), unit.scale};
}

/// Looks of so many lines that not each has its own.
LineLooks shared_looks(const SweepRecord& record, const std::vector<CaseLine>& lines,
                       const std::vector<std::size_t>& axes) {
  LineLooks out;
  const std::vector<std::size_t> colors = places_on(record, lines, axes[0]);
  const bool scale = colors.size() > kLooks;
  const bool two = axes.size() > 1;
  const std::vector<std::size_t> symbols =
      two ? places_on(record, lines, axes[1]) : std::vector<std::size_t>{0};
  const auto color_of = [&](std::size_t k) {
    return scale ? ramp_color(static_cast<double>(k) / static_cast<double>(colors.size() - 1))
                 : chart_look(k).color;
  };
  const auto color_rank = ranks_of(colors);
  const auto symbol_rank = ranks_of(symbols);
  for (const CaseLine& line : lines) {
    ChartLook look;
    look.color = color_of(color_rank.at(place_of(record, line, axes[0])));
    if (two) look.symbol = chart_look(symbol_rank.at(place_of(record, line, axes[1]))).symbol;
    look.width = 1.0;
    out.looks.push_back(std::move(look));
    out.names.emplace_back();
  }
  const std::size_t every = scale ? (colors.size() + 5) / 6 : 1;
  for (std::size_t k = 0; k < colors.size(); k += every) {
    ChartLook look{color_of(k), 7, true, false, false, 3.0};
    out.entries.push_back({value_name(record, axes[0], colors[k]), look, {}, {}});
  }
  if (!two || symbols.size() > kLooks) return out;
  for (std::size_t k = 0; k < symbols.size(); ++k) {
    ChartLook look{std::string(report::kGrey), chart_look(k).symbol, false};
    out.entries.push_back({value_name(record, axes[1], symbols[k]), look, {}, {}});
  }
  return out;
}

}  // namespace

std::vector<CaseLine> refinement_lines(const PlotCases& cases) {
  std::vector<CaseLine> lines;
  for (std::size_t g = 0; g < cases.record.groups.size(); ++g) {
    CaseLine line{{}, g};
    for (const std::size_t i : cases.record.groups[g].cases) {
      if (cases.picked[i]) line.cases.push_back(i);
    }
    if (!line.cases.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<CaseLine> lines_along(const PlotCases& cases, std::size_t axis) {
  const SweepRecord& record = cases.record;
  const std::vector<std::size_t> others = other_axes(record, axis);
  std::map<std::vector<std::size_t>, std::size_t> line_at;
  std::vector<CaseLine> lines;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    if (!cases.picked[i]) continue;
    std::vector<std::size_t> key;
    key.reserve(others.size());
    for (const std::size_t a : others) key.push_back(record.position[i * record.axes.size() + a]);
    const auto [place, is_new] = line_at.emplace(std::move(key), lines.size());
    if (is_new) lines.emplace_back();
    lines[place->second].cases.push_back(i);
  }
  for (CaseLine& line : lines) {
    std::stable_sort(line.cases.begin(), line.cases.end(), [&](std::size_t a, std::size_t b) {
      return number_on(record, a, axis) < number_on(record, b, axis);
    });
  }
  return lines;
}

LineLooks looks_of(const SweepRecord& record, const std::vector<CaseLine>& lines,
                   std::size_t along) {
  const std::vector<std::size_t> axes = other_axes(record, along);
  if (lines.size() > kLooks && !axes.empty()) return shared_looks(record, lines, axes);
  LineLooks out;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    out.looks.push_back(chart_look(k));
    out.names.push_back(axes.empty() ? record.quantity.name
                                     : short_setting(record, lines[k].cases.front(), axes));
  }
  return out;
}

std::string short_setting(const SweepRecord& record, std::size_t index,
                          const std::vector<std::size_t>& axes) {
  std::string text;
  for (const std::size_t a : axes) {
    text += (text.empty() ? "" : ", ") +
            value_name(record, a, record.position[index * record.axes.size() + a]);
  }
  return report::printable(text);
}

double number_on(const SweepRecord& record, std::size_t index, std::size_t axis) {
  const auto* number = std::get_if<double>(&record.at(index, axis));
  return number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN();
}

ShownNumbers shown_axis(const Axis& axis) {
  double largest = 0.0;
  for (const FieldValue& value : axis.values) {
    if (const auto* number = std::get_if<double>(&value)) {
      largest = std::max(largest, std::abs(*number));
    }
  }
  const bool modulus = axis.field->path.ends_with("modulus");
  return shown_numbers(std::string(axis.field->path),
                       report::display_unit(axis.field->dimension, largest, modulus));
}

ShownNumbers shown_value(const SweepRecord& record, double largest) {
  report::DisplayUnit unit = report::display_unit(record.quantity.dimension, largest);
  // Files of older versions have energies and frequencies without a dimension.
  const bool plain = record.quantity.dimension == Dimension::None;
  if (plain && record.quantity.unit != "1") unit.name = record.quantity.unit;
  return shown_numbers(report::printable(record.quantity.name), unit);
}

std::string subtitle_of(const SweepRecord& record) {
  std::string text = record.quantity.name;
  const std::string limits = error_limits(record);
  // A line has no room for both: what is not in an error comes first.
  const bool alone = limits.starts_with("error of");
  if (!record.against.empty() && !alone) text += " against " + record.against;
  if (!limits.empty()) text += (alone ? ": " : "; ") + limits;
  return report::printable(text);
}

std::string error_limits(const SweepRecord& record) {
  const Comparison& comparison = record.comparison;
  double off = 0.0;
  for (std::size_t i = 0; i < record.cases(); ++i) {
    if (!comparison.lacks[i].empty()) {
      return error_alone(record.axes[*record.refined].field->path, comparison.lacks[i]);
    }
    off = std::max(off, comparison.reference_error[i].value_or(0.0));
  }
  return off > 0.0 ? fmt::format("the reference is off by about {:.2g} %", 100.0 * off)
                   : std::string();
}

}  // namespace plastica::sweeps
