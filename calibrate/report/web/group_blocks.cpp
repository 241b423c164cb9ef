#include "calibrate/report/web/group_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/plot_data.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/scene_fit_figures.hpp"
#include "calibrate/report/summary.hpp"
#include "calibrate/report/web/outcome_blocks.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::FigureCurve;
using plastica::report::FigurePanel;
using plastica::report::Stroke;
using plastica::report::web_figure;

bool any_fitted(std::span<const FitRecord> records) {
  return std::ranges::any_of(records, [](const FitRecord& record) { return is_fitted(record); });
}

FigurePanel panel_of(std::span<const FitRecord> records,
                     const std::vector<std::vector<std::size_t>>& groups,
                     const FittedParameter& parameter) {
  const GroupValues values = values_of(records, groups, parameter);
  const DisplayUnit unit = display_unit(parameter);
  const std::string name = short_name(parameter.path);
  FigurePanel panel{name, "", unit.name.empty() ? name : name + " [" + std::string(unit.name) + "]"};
  FigureCurve points{{}, "specimens", kBlue, Stroke::Points};
  for (const auto& row : values.points) points.points.push_back({row[0], row[1]});
  FigureCurve means{{}, "mean and standard deviation", kVermillion, Stroke::Bars};
  for (const auto& row : values.means) {
    const double deviation = std::isfinite(row[2]) ? row[2] : 0.0;
    means.points.push_back({row[0], row[1], row[1] - deviation, row[1] + deviation});
  }
  panel.curves = {std::move(points), std::move(means)};
  for (const auto& group : groups) {
    panel.x_names.push_back(group_label(records[group.front()].target.group));
  }
  return panel;
}

void add_statistics(WebTable& table, const GroupSummary& group,
                    const std::vector<GroupStatistic>& all, const char* of) {
  for (const GroupStatistic& entry : all) {
    const DisplayUnit unit = display_unit_of(entry.name, entry.dimension, entry.statistic.mean);
    const auto& interval = entry.mean_interval;
    const auto cell = [&](std::optional<double> value) { return in_unit(value, unit); };
    table.add_row({printable(group_label(group.group)), printable(entry.name), of, unit.name,
                   entry.statistic.n, cell(entry.statistic.mean),
                   cell(entry.statistic.standard_deviation),
                   interval ? cell(interval->low) : Json(nullptr),
                   interval ? cell(interval->high) : Json(nullptr)});
  }
}

}  // namespace

void add_groups(Json& blocks, std::span<const FitRecord> records, const SpecimenDraws& draws) {
  if (any_fitted(records)) {
    const auto groups = group_indices(records);
    Figure figure{"Parameters over the groups", {}};
    for (const FittedParameter& parameter : free_parameters(records)) {
      figure.panels.push_back(panel_of(records, groups, parameter));
    }
    blocks.push_back(web_figure(figure));
  }
  WebTable table("Statistics");
  table.add_words("group");
  table.add_words("quantity");
  table.add_words("of");
  table.add_words("unit");
  table.add_numbers("n");
  table.add_numbers("mean");
  table.add_numbers("standard deviation", "", "", 3);
  table.add_numbers("mean from", "", "ends of the confidence interval of the mean");
  table.add_numbers("to");
  for (const GroupSummary& group : summarize_groups(records, draws)) {
    add_statistics(table, group, group.characteristics, "the curves");
    add_statistics(table, group, group.parameters, "the fits");
  }
  blocks.push_back(table.block());
}

void add_population(Json& blocks, std::span<const SceneFitRecord> records) {
  const auto fitted = std::ranges::count_if(
      records, [](const SceneFitRecord& record) { return record.result.is_fitted(); });
  if (fitted > 1) blocks.push_back(web_figure(population_figure(records)));
}

void add_scene_figures(Json& blocks, const SceneFitRecord& record) {
  const auto add = [&](std::string title, Figure figure) {
    figure.title = std::move(title);
    blocks.push_back(web_figure(figure));
  };
  add("Measured and fitted", fit_figure(record, false));
  if (!record.result.is_fitted()) return;
  add("Measured less fitted", residuals_figure(record));
  if (record.result.starts.size() > 1) add("Searches", starts_figure(record));
  if (record.result.segments) add("Other segments", segments_figure(record));
}

}  // namespace plastica::calibrate::report
