#include "sweeps/report/json.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "plastica/report/json_values.hpp"
#include "sweeps/compare/convergence.hpp"
#include "sweeps/report/case_rows.hpp"

namespace plastica::sweeps {
namespace {

using report::Json;
using report::number;
using report::text_or_null;

Json value_of(const FieldValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  const auto* number_of = std::get_if<double>(&value);
  return number_of != nullptr ? number(*number_of) : Json(nullptr);
}

Json axes_of(const SweepRecord& record) {
  Json all = Json::array();
  for (const Axis& axis : record.axes) {
    Json values = Json::array();
    for (const FieldValue& value : axis.values) values.push_back(value_of(value));
    all.push_back({{"field", axis.field->path},
                   {"unit", si_unit(axis.field->dimension)},
                   {"moves_with", text_or_null(axis.group)},
                   {"values", std::move(values)}});
  }
  return all;
}

Json statuses_of(const SweepRecord& record) {
  std::map<std::string, std::size_t> counts;
  for (const CaseResult& result : record.results) ++counts[std::string(name_of(result.status))];
  Json all = Json::object();
  for (const auto& [status, count] : counts) all[status] = count;
  return all;
}

std::string_view word_of(theory::ConvergenceKind kind) {
  switch (kind) {
    case theory::ConvergenceKind::Monotone: return "monotone";
    case theory::ConvergenceKind::TooFast: return "too_fast";
    case theory::ConvergenceKind::Oscillatory: return "oscillatory";
    case theory::ConvergenceKind::Divergent: return "divergent";
    case theory::ConvergenceKind::Unchanged: return "unchanged";
    case theory::ConvergenceKind::Unknown: break;
  }
  return "unknown";
}

Json grid_of(const std::optional<theory::GridConvergence>& grid) {
  if (!grid) return nullptr;
  return {{"kind", word_of(grid->kind)},
          {"order", number(grid->observed_order)},
          {"extrapolated", number(grid->extrapolated)},
          {"uncertainty", number(grid->uncertainty)},
          {"gci", number(grid->fine_index)},
          {"safety_factor", number(grid->safety_factor)}};
}

Json group_of(const SweepRecord& record, const RefinementGroup& group) {
  const GroupConvergence found = convergence_of(group, record.results, record.comparison);
  Json ids = Json::array();
  for (const std::size_t i : group.cases) ids.push_back(record.ids[i]);
  Json pairwise = Json::array();
  for (const auto& order : found.pairwise) pairwise.push_back(number(order));
  return {{"label", text_or_null(group.label)},
          {"cases", std::move(ids)},
          {"sizes", group.size},
          {"order", number(found.fit.order)},
          {"correlation", number(found.fit.correlation)},
          {"points", found.fit.points},
          {"pairwise_orders", std::move(pairwise)},
          {"three_finest", grid_of(found.grid)}};
}

Json case_of(const SweepRecord& record, std::size_t i) {
  const CaseResult& result = record.results[i];
  Json axes = Json::object();
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    axes[std::string(record.axes[a].field->path)] = value_of(record.at(i, a));
  }
  return {{"id", record.ids[i]},
          {"axes", std::move(axes)},
          {"status", name_of(result.status)},
          {"reason", text_or_null(result.reason)},
          {"level", level_word(result.level)},
          {"value", number(result.value)},
          {"reference", number(record.comparison.reference[i])},
          {"error", number(record.comparison.error[i])},
          {"error_reason", text_or_null(record.comparison.reason[i])},
          {"error_lacks", text_or_null(record.comparison.lacks[i])},
          {"reference_error", number(record.comparison.reference_error[i])},
          {"standard_error", number(result.standard_error)},
          {"segments", result.segments},
          {"iterations", result.iterations},
          {"segment_iterations", result.segment_iterations()},
          {"cutbacks", result.cutbacks},
          {"energy_balance_error", number(result.energy_balance_error)},
          {"last_time", number(result.last_time)},
          {"last_value", number(result.last_value)},
          {"break_joint", result.break_joint < 0 ? Json(nullptr) : Json(result.break_joint)},
          {"seconds", number(result.seconds)}};
}

}  // namespace

std::string sweep_json(const SweepRecord& record) {
  Json groups = Json::array();
  for (const RefinementGroup& group : record.groups) groups.push_back(group_of(record, group));
  Json cases = Json::array();
  for (std::size_t i = 0; i < record.cases(); ++i) cases.push_back(case_of(record, i));
  const Json all = {
      {"name", record.name},
      {"scene", record.scene_name},
      {"quantity", {{"name", record.quantity.name}, {"unit", record.quantity.unit}}},
      {"against", text_or_null(record.against)},
      {"error_scale", number(record.error_scale)},
      {"refined", record.refined ? Json(record.axes[*record.refined].field->path) : Json(nullptr)},
      {"error_notes", record.comparison.notes},
      {"warnings", record.warnings},
      {"timed_runs", record.timed_runs},
      {"statuses", statuses_of(record)},
      {"axes", axes_of(record)},
      {"groups", std::move(groups)},
      {"cases", std::move(cases)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace plastica::sweeps
