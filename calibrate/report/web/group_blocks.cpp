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
#include "calibrate/report/text_groups.hpp"
#include "calibrate/report/web/outcome_blocks.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::FigureCurve;
using plastica::report::FigurePanel;
using plastica::report::Stroke;
using plastica::report::web_figure;

/// The free parameters that any specimen determines, in their order.
std::vector<FittedParameter> determined(std::span<const FitRecord> records) {
  std::vector<FittedParameter> all;
  for (const FitRecord& record : records) {
    if (!is_fitted(record)) continue;
    for (const FittedParameter* p : record.result.free_parameters()) {
      const auto is_same = [&](const FittedParameter& one) { return one.path == p->path; };
      if (p->identified && std::ranges::none_of(all, is_same)) all.push_back(*p);
    }
  }
  return all;
}

FigurePanel panel_of(std::span<const FitRecord> records,
                     const std::vector<std::vector<std::size_t>>& groups,
                     const FittedParameter& parameter) {
  const GroupValues values = values_of(records, groups, parameter);
  const DisplayUnit unit = display_unit(parameter);
  const std::string name = short_name(parameter.path);
  FigurePanel panel{name, "",
                    unit.name.empty() ? name : name + " [" + std::string(unit.name) + "]"};
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

void add_statistics(WebTable& table, const GroupSummary& group, std::span<const FitRecord> records,
                    const std::vector<GroupStatistic>& all, bool measured) {
  for (const GroupStatistic& entry : all) {
    const DisplayUnit unit = display_unit_of(entry.name, entry.dimension, entry.statistic.mean);
    const auto& interval = entry.mean_interval;
    const auto cell = [&](std::optional<double> value) { return in_unit(value, unit); };
    table.add_row(
        {printable(group_label(group.group)),
         measured ? characteristic_label(entry.name, group, records) : printable(entry.name),
         measured ? "the curves" : "the fits", unit.name, entry.statistic.n,
         cell(entry.statistic.mean), cell(entry.statistic.standard_deviation),
         interval ? cell(interval->low) : Json(nullptr),
         interval ? cell(interval->high) : Json(nullptr)});
  }
}

void add_out_of_line(WebTable& table, const GroupSummary& group, std::span<const FitRecord> records,
                     const std::vector<GroupStatistic>& all, bool measured) {
  for (const GroupStatistic& entry : all) {
    for (const OutOfLine& one : entry.out_of_line) {
      const DisplayUnit unit = display_unit_of(entry.name, entry.dimension, one.median);
      table.add_row(
          {printable(records[one.record].name()), printable(group_label(group.group)),
           measured ? characteristic_label(entry.name, group, records) : printable(entry.name),
           measured ? "the curves" : "the fits", unit.name, in_unit(one.value, unit),
           in_unit(one.median, unit), plastica::report::number(one.score)},
          one.record);
    }
  }
}

/// The specimens that are out of line with their groups; each row opens its own.
Json out_of_line_block(const std::vector<GroupSummary>& groups,
                       std::span<const FitRecord> records) {
  WebTable table("Specimens out of line");
  table.open_details();
  table.add_words("specimen");
  table.add_words("group");
  table.add_words("quantity");
  table.add_words("of");
  table.add_words("unit");
  table.add_numbers("value");
  table.add_numbers("median", "", "of the group");
  table.add_numbers("score", "", "0.6745 (value - median)/MAD", 3);
  for (const GroupSummary& group : groups) {
    add_out_of_line(table, group, records, group.characteristics, true);
    add_out_of_line(table, group, records, group.parameters, false);
  }
  return table.is_empty() ? Json(nullptr) : table.block();
}

}  // namespace

void add_groups(Json& blocks, std::span<const FitRecord> records, const SpecimenDraws& draws) {
  if (const auto parameters = determined(records); !parameters.empty()) {
    const auto groups = group_indices(records);
    Figure figure{"Parameters over the groups", {}};
    for (const FittedParameter& parameter : parameters) {
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
  table.add_numbers("mean, " + percent_from(draws.confidence), "",
                    "confidence interval of the mean");
  table.add_numbers("to");
  const std::vector<GroupSummary> groups = summarize_groups(records, draws);
  for (const GroupSummary& group : groups) {
    add_statistics(table, group, records, group.characteristics, true);
    add_statistics(table, group, records, group.parameters, false);
  }
  if (Json outliers = out_of_line_block(groups, records); !outliers.is_null()) {
    blocks.push_back(std::move(outliers));
    blocks.push_back(plastica::report::web_notes("", {out_of_line_rule()}, "note"));
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
