#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/format.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/plot_kinds.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/summary.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate::report {
namespace {

constexpr std::size_t kTitleWidth = 76;
constexpr int kPanelRows = 15;
/// Letters of the groups; those behind the last are not drawn.
constexpr std::string_view kLetters = "ABCDEFGH";

/// One thing drawn, as points of one letter.
struct Layer {
  std::string points;  ///< name of the block, "$data3"
  char letter;
  std::string title;
};

std::string plot_command(const std::vector<Layer>& layers) {
  std::string plot;
  for (const Layer& layer : layers) {
    plot += fmt::format("{}{} using 1:2 with points pointtype '{}' title {}",
                        plot.empty() ? "plot " : ", \\\n     ", layer.points, layer.letter,
                        in_quotes(layer.title));
  }
  return plot;
}

/// What a picture of characters has no room for is switched off.
void begin(PlotScript& script) {
  script.command(
      "unset grid\nunset border\nset border 3\nset tics scale 0.5\nset key outside bottom center "
      "horizontal samplen 3");
}

/// Title lines as one gnuplot string.
std::string title_of(const std::vector<std::string>& title) {
  std::string text;
  for (const std::string& line : title) {
    text += (text.empty() ? "" : ".\"\\n\".") + in_quotes(cut(line, kTitleWidth));
  }
  return "set title " + text;
}

void set_ranges(PlotScript& script, std::span<const FitRecord> records) {
  const auto [strain, stress] = largest_of(records);
  if (any_cyclic(records) || !(strain > 0.0) || !(stress > 0.0)) return;
  script.command(fmt::format("set xrange [0:{:.6g}]\nset yrange [0:{:.6g}]", 104.0 * strain,
                             1.08e-6 * stress));
}

/// A line between the points of a curve that shows as one letter: points dense enough for it.
std::string add_dense(PlotScript& script, const Curve& curve, double strain, double stress) {
  Curve dense;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double dx = i == 0 ? 0.0 : curve.strain[i] - curve.strain[i - 1];
    const double dy = i == 0 ? 0.0 : curve.stress[i] - curve.stress[i - 1];
    const double steps = 120.0 * std::max(strain > 0.0 ? std::fabs(dx) / strain : 0.0,
                                          stress > 0.0 ? std::fabs(dy) / stress : 0.0);
    const int count = std::isfinite(steps) ? std::clamp(static_cast<int>(steps), 0, 500) + 1 : 1;
    for (int k = count - 1; k >= 0; --k) {
      const double back = static_cast<double>(k) / count;
      dense.strain.push_back(curve.strain[i] - back * dx);
      dense.stress.push_back(curve.stress[i] - back * dy);
    }
  }
  return add_curve(script, dense);
}

/// The axis over groups: the keys as its title, the values as labels; or no title and both in the
/// labels where the groups have different keys.
struct TerminalAxis {
  std::string title;
  std::vector<std::string> labels;
};

TerminalAxis group_axis(std::span<const FitRecord> records,
                        const std::vector<std::vector<std::size_t>>& groups) {
  const auto keys_of = [](const Target& target) {
    std::string keys;
    for (const auto& [key, value] : target.group) keys += (keys.empty() ? "" : ", ") + key;
    return keys;
  };
  TerminalAxis axis;
  axis.title = keys_of(records[groups.front().front()].target);
  for (const std::vector<std::size_t>& members : groups) {
    if (keys_of(records[members.front()].target) != axis.title) axis.title.clear();
  }
  for (const std::vector<std::size_t>& members : groups) {
    const Target& target = records[members.front()].target;
    std::string label;
    for (const auto& [key, value] : target.group) label += (label.empty() ? "" : ", ") + value;
    if (target.group.empty()) label = "all";
    axis.labels.push_back(axis.title.empty() && !target.group.empty() ? group_label(target.group)
                                                                      : label);
  }
  return axis;
}

}  // namespace

PlotScript curve_terminal(const FitRecord& record) {
  const Target& target = record.target;
  const Curve& measured = measured_of(record);
  if (measured.size() == 0) {
    throw InputError({}, "--case", target.name, "has no curve to draw: " + reason_of(record));
  }
  PlotScript script;
  begin(script);
  std::vector<std::string> title = {target.name + ": " + stress_label(target)};
  std::string line;
  for (const std::string& fact : facts_of(record)) {
    if (!line.empty() && width_of(line) + 3 + width_of(fact) > kTitleWidth) {
      title.push_back(std::move(line));
      line.clear();
    }
    line += (line.empty() ? "" : "   ") + fact;
  }
  title.push_back(std::move(line));
  script.command(title_of(title));
  script.command("set xlabel " + in_quotes(strain_label(target)));
  set_ranges(script, {&record, 1});
  const auto [strain, stress] = largest_of({&record, 1});
  // What is drawn last covers what was there: the measured samples stay visible.
  std::vector<Layer> layers;
  if (is_fitted(record) && record.result.fitted.size() > 0) {
    layers.push_back(
        {add_dense(script, fitted_with_break(record.result), strain, stress), '#', "fitted"});
  }
  layers.push_back({add_dense(script, measured, strain, stress), '.', "measured"});
  std::vector<std::vector<double>> breaks;
  add_break(record, breaks);
  if (!breaks.empty()) {
    layers.push_back({script.add_points(breaks), 'x', "break, measured"});
  }
  script.command(plot_command(layers));
  return script;
}

PlotScript overview_terminal(std::span<const FitRecord> records) {
  const std::vector<std::vector<std::size_t>> groups = drawable_groups(records);
  const std::size_t shown = std::min(groups.size(), kLetters.size());
  PlotScript script;
  begin(script);
  std::vector<std::size_t> all;
  for (std::size_t g = 0; g < shown; ++g) all.insert(all.end(), groups[g].begin(), groups[g].end());
  std::string title = counted(records.size(), "specimen");
  if (groups.size() > 1) title += " in " + counted(groups.size(), "group");
  if (shown < groups.size()) title += fmt::format(", the first {} shown", shown);
  script.command(title_of({title + ": " + label_of_all(records, all, stress_label)}));
  script.command("set xlabel " + in_quotes(label_of_all(records, all, strain_label)));
  set_ranges(script, records);
  const auto [strain, stress] = largest_of(records);
  std::vector<Layer> layers;
  std::vector<std::vector<double>> breaks;
  for (std::size_t g = 0; g < shown; ++g) {
    const GroupCurves curves = curves_of(records, groups[g]);
    const Curve mean = mean_curve(curves.measured);
    const Curve& curve = mean.size() > 0 ? mean : *curves.measured.front();
    const std::string_view what = mean.size() > 0               ? "mean"
                                  : curves.measured.size() == 1 ? "measured"
                                                                : "first";
    std::vector<Curve> fits;
    for (const FitRecord* record : curves.drawn) {
      add_break(*record, breaks);
      if (is_fitted(*record) && record->result.fitted.size() > 1) {
        fits.push_back(fitted_until_break(record->result));
      }
    }
    if (groups.size() == 1) {
      std::vector<const Curve*> pointers;
      pointers.reserve(fits.size());
      for (const Curve& fit : fits) pointers.push_back(&fit);
      const Curve fitted = fits.size() == 1 ? fits.front() : mean_curve(pointers);
      if (fitted.size() > 0) {
        layers.push_back({add_dense(script, fitted, strain, stress), '#',
                          fits.size() == 1 ? "fitted" : "fitted, mean"});
      }
      layers.push_back(
          {add_dense(script, curve, strain, stress), '.', fmt::format("measured, {}", what)});
    } else {
      const std::string label = group_label(records[groups[g].front()].target.group);
      layers.push_back({add_dense(script, curve, strain, stress), kLetters[g],
                        fmt::format("{}, {}", cut(label, 26), what)});
    }
  }
  if (!breaks.empty()) layers.push_back({script.add_points(breaks), 'x', "break"});
  script.command(plot_command(layers));
  return script;
}

PlotScript parameters_terminal(std::span<const FitRecord> records) {
  const std::vector<std::vector<std::size_t>> groups = group_indices(records);
  const std::vector<FittedParameter> shown = free_parameters(records);
  PlotScript script;
  begin(script);
  script.terminal_rows = kPanelRows * static_cast<int>(shown.size());
  script.command(fmt::format("set multiplot layout {},1", shown.size()));
  script.command(
      fmt::format("set xrange [0.4:{:.1f}]\n"
                  "set offsets graph 0, graph 0, graph 0.1, graph 0.1",
                  static_cast<double>(groups.size()) + 0.6));
  const TerminalAxis axis = group_axis(records, groups);
  const std::size_t each = (groups.size() + 5) / 6;
  std::string tics;
  for (std::size_t g = 0; g < groups.size(); g += each) {
    tics += fmt::format("{}{} {}", g == 0 ? "" : ", ", quoted_tic(cut(axis.labels[g], 10)), g + 1);
  }
  script.command("set xtics (" + tics + ")");
  for (const FittedParameter& parameter : shown) {
    const DisplayUnit unit = display_unit(parameter);
    const GroupValues values = values_of(records, groups, parameter);
    std::string title = parameter.name();
    if (!unit.name.empty()) title += fmt::format(" [{}]", unit.name);
    if (!axis.title.empty()) title += " over " + axis.title;
    script.command(title_of({title}));
    std::vector<Layer> layers;
    if (!values.points.empty()) {
      layers.push_back({script.add_points(values.points), 'o', "specimens"});
    }
    if (!values.means.empty()) {
      layers.push_back({script.add_points(values.means), '#', "mean"});
    }
    script.command(layers.empty() ? "plot [0:1] [0:1] NaN notitle" : plot_command(layers));
  }
  script.command("unset multiplot");
  return script;
}

}  // namespace plastica::calibrate::report
