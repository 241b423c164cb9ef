#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/plot_kinds.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/summary.hpp"

namespace plastica::calibrate::report {
namespace {

/// The horizontal axis of all panels: a tic for each group.
struct GroupAxis {
  std::string tics;         ///< as `set xtics` wants them
  std::string keys;         ///< below the axis
  std::size_t letters = 0;  ///< of all labels in a row
  std::size_t longest = 0;
};

GroupAxis axis_of(std::span<const FitRecord> records,
                  const std::vector<std::vector<std::size_t>>& groups) {
  GroupAxis axis;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::string values;
    axis.keys.clear();
    for (const auto& [key, value] : records[groups[g].front()].target.group) {
      values += (values.empty() ? "" : ", ") + value;
      axis.keys += (axis.keys.empty() ? "" : ", ") + key;
    }
    values = cut(values.empty() ? "all specimens" : values, 18);
    axis.letters += width_of(values) + 2;
    axis.longest = std::max(axis.longest, width_of(values));
    axis.tics += fmt::format("{}{} {}", g == 0 ? "" : ", ", quoted_tic(values), g + 1);
  }
  return axis;
}

}  // namespace

PlotScript parameters_plot(std::span<const FitRecord> records, const Sheet& sheet) {
  const std::vector<std::vector<std::size_t>> groups = group_indices(records);
  const std::vector<FittedParameter> shown = free_parameters(records);
  PlotScript script(sheet);
  const GroupAxis axis = axis_of(records, groups);
  // Labels that would run into each other are turned; very many are left out.
  const bool crowded = axis.letters * std::min<std::size_t>(shown.size(), 3) > 90;
  const bool many = groups.size() > 40;
  const bool rotated = crowded && !many;
  script.begin_panels(shown.size(), {}, rotated ? 3.0 * static_cast<double>(axis.longest) : 0.0);
  script.command(
      many ? "unset xtics"
           : fmt::format("set xtics {}({})", rotated ? "rotate by 35 right " : "", axis.tics));
  script.set_x_label(rotated ? "" : cut(axis.keys, 40));
  script.command(fmt::format("set xrange [0.4:{}.6]", groups.size()));
  script.command("set offsets graph 0, graph 0, graph 0.08, graph 0.08");
  for (const FittedParameter& parameter : shown) {
    const DisplayUnit unit = display_unit(parameter);
    const auto [points, means] = values_of(records, groups, parameter);
    script.begin_panel({unit.name.empty() ? parameter.name()
                                          : fmt::format("{} [{}]", parameter.name(), unit.name)});
    if (!points.empty()) {
      script.add_series(script.add_points(points),
                        fmt::format("using 1:2:3 with yerrorbars pointtype 7 pointsize {} "
                                    "linewidth 0.8 linecolor rgb '{}'",
                                    points.size() > 200  ? 0.25
                                    : points.size() > 30 ? 0.45
                                                         : 0.8,
                                    kGrey),
                        "a specimen and its standard error");
    }
    if (!means.empty()) {
      script.add_series(script.add_points(means),
                        fmt::format("using 1:2:3 with yerrorbars pointtype 5 pointsize 0.8 "
                                    "linewidth 2 linecolor rgb '{}'",
                                    kBlue),
                        "mean and standard deviation");
    }
    script.end_panel();
  }
  return script;
}

}  // namespace plastica::calibrate::report
