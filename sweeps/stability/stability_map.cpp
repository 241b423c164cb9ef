#include "sweeps/stability/stability_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/report/format.hpp"
#include "sweeps/stability/scan.hpp"
#include "sweeps/stability/summary.hpp"

namespace plastica::sweeps::stability {
namespace {

constexpr std::array<std::string_view, 4> kColours{report::kBlue, "#E69F00", report::kGrey,
                                                   report::kVermillion};

/// The scenes of a study from the top down, with a gap before each level and analysis.
struct Lines {
  std::vector<std::string> scene;
  std::vector<double> height;
  std::vector<std::pair<std::string, double>> groups;  ///< with the height of the group's middle
};

Lines lines_of(std::span<const StabilityRow> rows) {
  Lines lines;
  double height = 0.0;
  double first = 0.0;
  std::string group;
  const auto end_group = [&] {
    if (!group.empty()) lines.groups.emplace_back(group, 0.5 * (first + height));
  };
  for (const StabilityRow& row : rows) {
    if (!lines.scene.empty() && lines.scene.back() == row.scene) continue;
    const bool moves = row.analysis == Analysis::Dynamics;
    std::string now(word_of(row.level));
    if (moves) now += " (t)";
    const bool begins = now != group;
    if (begins) end_group();
    height -= begins && !group.empty() ? 2.5 : 1.0;
    if (begins) first = height;
    group = now;
    lines.scene.push_back(row.scene);
    lines.height.push_back(height);
  }
  end_group();
  return lines;
}

/// Where a value is on an axis: its logarithm; zero, infinity and what is below zero at the ends.
double place_of(const Axis& axis, double value) {
  const bool linear = axis.values.front() < 0.0 || axis.name == "scheme";
  if (linear) return value;
  double low = INFINITY;
  double high = -INFINITY;
  for (const double each : axis.values) {
    if (each <= 0.0 || !std::isfinite(each)) continue;
    low = std::min(low, std::log10(each));
    high = std::max(high, std::log10(each));
  }
  if (value <= 0.0) return low - 1.0;
  return std::isfinite(value) ? std::log10(value) : high + 1.0;
}

/// Decades from one label of a logarithmic axis to the next, so that there are some four.
double tic_decades(const Axis& axis) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : axis.values) {
    low = std::min(low, place_of(axis, value));
    high = std::max(high, place_of(axis, value));
  }
  return std::max(1.0, std::ceil((high - low) / 4.0));
}

void add_axis(const Axis& axis, std::span<const StabilityRow> rows, const Lines& lines,
              report::PlotScript& script) {
  std::array<std::vector<std::vector<double>>, 4> points;
  for (const StabilityRow& row : rows) {
    if (!row.begun || row.at.size() != 1 || row.at[0].axis != axis.name) continue;
    const auto line = std::find(lines.scene.begin(), lines.scene.end(), row.scene);
    points[static_cast<std::size_t>(row.verdict.validity)].push_back(
        {place_of(axis, row.at[0].value),
         lines.height[static_cast<std::size_t>(line - lines.scene.begin())]});
  }
  const std::string unit = axis.unit == "1" ? "" : " [" + std::string(axis.unit) + "]";
  script.begin_panel({std::string(axis.name) + unit});
  const bool linear = axis.values.front() < 0.0 || axis.name == "scheme";
  script.command(linear ? "set format x '%g'" : "set format x '1e%g'");
  script.command("set xtics " + report::brief(linear ? 0.5 : tic_decades(axis)));
  script.command("set autoscale x");
  script.command("set offsets graph 0.04, graph 0.04, 0, 0");
  script.command("set yrange [" + report::brief(lines.height.back() - 1.0) + ":0]");
  std::string tics = "set ytics (";
  for (std::size_t i = 0; i < lines.groups.size(); ++i) {
    const std::string name = script.at_left() ? lines.groups[i].first : "";
    tics +=
        (i > 0 ? ", " : "") + report::in_quotes(name) + " " + report::brief(lines.groups[i].second);
  }
  script.command(tics + ")");
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].empty()) continue;
    script.add_series(script.add_points(points[k]),
                      "using 1:2 with points pointtype 5 pointsize 0.35 linecolor rgb '" +
                          std::string(kColours[k]) + "'",
                      k == 3 ? "undetected error" : kValidity[k]);
  }
  script.end_panel();
}

}  // namespace

std::string_view class_colour(Validity validity) {
  return kColours[static_cast<std::size_t>(validity)];
}

int class_symbol(Validity validity) {
  constexpr std::array kSymbols{7, 9, 3, 5};
  return kSymbols[static_cast<std::size_t>(validity)];
}

report::PlotScript stability_map(std::span<const StabilityRow> rows) {
  report::PlotScript script;
  const Lines lines = lines_of(rows);
  std::vector<const Axis*> scanned;
  for (const Axis& axis : axes()) {
    const bool any = std::any_of(rows.begin(), rows.end(), [&](const StabilityRow& row) {
      return row.at.size() == 1 && row.at[0].axis == axis.name;
    });
    if (any) scanned.push_back(&axis);
  }
  script.begin_panels(scanned.size(), "each row a scene, (t) in motion; each point a run");
  for (const Axis* axis : scanned) add_axis(*axis, rows, lines, script);
  return script;
}

}  // namespace plastica::sweeps::stability
