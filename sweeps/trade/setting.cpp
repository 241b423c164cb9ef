#include "sweeps/trade/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "plastica/io/scene_file.hpp"
#include "sweeps/plan/read_axes.hpp"
#include "sweeps/plan/refining.hpp"
#include "sweeps/trade/written_scene.hpp"

namespace plastica::sweeps {
namespace {

constexpr double kFailed = std::numeric_limits<double>::quiet_NaN();

/// The field that a derived one moves, with the value that it comes to.
struct Target {
  const Field* field = nullptr;
  FieldValue value;
};

std::optional<Target> target_of(const Axis& axis, const FieldValue& value, const Setup& setup) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kMoved{
      {{"beam.segment_depth", "beam.segments"}, {"beam.slenderness", "beam.length"}}};
  const bool in_files =
      find_field_or_null(axis.field->path) != nullptr || axis.field->path == "material.name";
  if (in_files) return Target{axis.field, value};
  for (const auto& [derived, moved] : kMoved) {
    if (axis.field->path != derived) continue;
    const Field* field = find_field_or_null(moved);
    return Target{field, field->get(setup)};
  }
  return std::nullopt;
}

/// The setup of a case, from the file of its scene.
Setup setup_of(const SweepRecord& record, const std::string& text, const std::string& file,
               std::size_t index) {
  Setup setup = io::parse_scene_file(text, file).setup;
  std::vector<const Field*> fields;
  std::vector<FieldValue> values;
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    fields.push_back(record.axes[a].field);
    values.push_back(record.at(index, a));
  }
  apply(setup, fields, values);
  return setup;
}

/// h of a value as the file has it; NaN where the axis does not refine by it.
double nominal_size(const Axis& axis, const FieldValue& value) {
  const Refinement refinement = refinement_of(*axis.field);
  const auto* number = std::get_if<double>(&value);
  if (refinement == Refinement::None || number == nullptr) return kFailed;
  return refinement == Refinement::Count ? 1.0 / *number : *number;
}

bool makes_problems(const Axis& axis) {
  return axis.values.size() > 1 && role_of(*axis.field) == AxisRole::Problem;
}

}  // namespace

std::vector<TradePoint> trade_points(const SweepRecord& record, CostKind cost) {
  std::vector<TradePoint> points(record.cases());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CaseResult& result = record.results[i];
    const auto& error = record.comparison.error[i];
    points[i].cost = cost == CostKind::Seconds ? result.seconds
                                               : static_cast<double>(result.segment_iterations());
    points[i].error = usable(result.status) && error ? std::abs(*error) : kFailed;
  }
  return points;
}

std::optional<double> promised_error(const SweepRecord& record, std::size_t index) {
  const Comparison& comparison = record.comparison;
  if (!usable(record.results[index].status) || !comparison.lacks[index].empty()) return {};
  const std::string& reason = comparison.reason[index];
  const auto& own = comparison.error[index];
  const auto& of_reference = comparison.reference_error[index];
  if (reason == kIsReference || reason == kIsRunOfReference) return of_reference;
  return own ? std::optional(std::abs(*own) + of_reference.value_or(0.0)) : std::nullopt;
}

std::vector<TradePoint> promised_points(const SweepRecord& record, CostKind cost) {
  std::vector<TradePoint> points = trade_points(record, cost);
  std::map<std::vector<std::size_t>, std::size_t> groups;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].error = promised_error(record, i).value_or(kFailed);
    std::vector<std::size_t> key;
    for (std::size_t a = 0; a < record.axes.size(); ++a) {
      const Axis& axis = record.axes[a];
      const double size = nominal_size(axis, record.at(i, a));
      if (axis.values.size() > 1 && size > 0.0 && !axis.apart) {
        points[i].sizes.push_back(size);
      } else {
        const auto first = std::find(axis.values.begin(), axis.values.end(), record.at(i, a));
        key.push_back(static_cast<std::size_t>(first - axis.values.begin()));
      }
    }
    points[i].group = groups.emplace(std::move(key), groups.size()).first->second;
  }
  return points;
}

bool has_problems(const SweepRecord& record) {
  return std::any_of(record.axes.begin(), record.axes.end(), makes_problems);
}

void check_settings(const SweepRecord& record) {
  for (const Axis& axis : record.axes) {
    if (!makes_problems(axis)) continue;
    throw InputError({}, axis.field->path, std::to_string(axis.values.size()) + " values",
                     "makes other problems of the scene: a recommendation is for one; fix it by "
                     "[set] in the sweep");
  }
}

std::string setting_text(const SweepRecord& record, std::size_t index) {
  std::string text;
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    if (record.axes[a].values.size() == 1) continue;
    const Field& field = *record.axes[a].field;
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", field.path,
                        value_text(field, record.at(index, a)));
  }
  return text;
}

std::string scene_with_setting(const SweepRecord& record, std::size_t index,
                               const std::string& folder, const std::string& output) {
  const std::string& before = record.inputs.at(1).text;
  const std::string file = (std::filesystem::path(folder) / "scene").string();
  const Setup wanted = setup_of(record, before, file, index);
  std::vector<std::pair<const Field*, FieldValue>> values;
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    const FieldValue& value = record.at(index, a);
    const auto target = target_of(record.axes[a], value, wanted);
    if (!target) refuse_to_write(*record.axes[a].field, value);
    values.emplace_back(target->field, target->value);
  }
  return scene_with_values(before, values, wanted, file, output);
}

}  // namespace plastica::sweeps
