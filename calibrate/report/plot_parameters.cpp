#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/report/plot_kinds.hpp"
#include "calibrate/report/summary.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate::report {
namespace {

/// Free parameters of the first fit.
std::vector<FittedParameter> free_parameters(std::span<const FitRecord> records) {
  std::vector<FittedParameter> all;
  for (const FitRecord& record : records) {
    if (record.result.status != FitStatus::Fitted) continue;
    for (const FittedParameter& parameter : record.result.parameters) {
      if (parameter.role == ParameterRole::Free) all.push_back(parameter);
    }
    break;
  }
  return all;
}

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

PlotScript parameters_plot(std::span<const FitRecord> records) {
  const std::vector<std::vector<std::size_t>> groups = group_indices(records);
  const std::vector<FittedParameter> shown = free_parameters(records);
  if (shown.empty()) throw InputError({}, "--what", "parameters", "there is no fitted specimen");
  PlotScript script;
  const GroupAxis axis = axis_of(records, groups);
  // Labels that would run into each other are turned; very many are left out.
  const bool crowded = axis.letters * std::min<std::size_t>(shown.size(), 3) > 90;
  const bool many = groups.size() > 40;
  const bool turned = crowded && !many;
  script.begin_panels(shown.size(), {}, 1, turned ? 3.0 * static_cast<double>(axis.longest) : 0.0);
  script.command(
      many ? "unset xtics"
           : fmt::format("set xtics {}({})", turned ? "rotate by 35 right " : "", axis.tics));
  script.command("set xlabel " + quoted(turned ? "" : cut(axis.keys, 40)));
  script.command(fmt::format("set xrange [0.4:{}.6]", groups.size()));
  script.command("set offsets graph 0, graph 0, graph 0.08, graph 0.08");
  for (const FittedParameter& parameter : shown) {
    const DisplayUnit unit = display_unit(parameter);
    std::vector<std::vector<double>> points;
    std::vector<std::vector<double>> means;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      std::vector<double> values;
      const auto middle = static_cast<double>(g + 1);
      for (std::size_t k = 0; k < groups[g].size(); ++k) {
        const FitRecord& record = records[groups[g][k]];
        if (record.result.status != FitStatus::Fitted) continue;
        for (const FittedParameter& found : record.result.parameters) {
          if (found.name != parameter.name || !found.identified) continue;
          values.push_back(found.value / unit.scale);
          // Spread sideways by the golden ratio: even, and the same in each picture.
          const double spread = std::fmod(0.6180339887 * static_cast<double>(k + 1), 1.0) - 0.5;
          points.push_back({middle + 0.36 * spread, values.back(),
                            found.standard_error.value_or(0.0) / unit.scale});
        }
      }
      const Statistic statistic = statistic_of(std::move(values));
      if (statistic.n < 2) continue;
      means.push_back({middle + 0.32, statistic.mean, statistic.standard_deviation.value_or(0.0)});
    }
    script.begin_panel(quoted(
        unit.name.empty() ? parameter.name : fmt::format("{} [{}]", parameter.name, unit.name)));
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
