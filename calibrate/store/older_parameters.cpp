#include "calibrate/store/older_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "calibrate/store/fit_rules.hpp"
#include "calibrate/store/stored_options.hpp"
#include "plastica/base/renamed.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate::store {
namespace {

/// Of a FittedParameter that stands among others, whose it is.
constexpr auto kDescribeWhoseParameter = [](auto& d) {
  d("path", "", PLASTICA_MEMBER(path), "of the field");
  d("dimension", "", PLASTICA_MEMBER(dimension), "what it measures");
};

/// Version 3 says that a parameter is at a bound, but not at which, and knows no coordinates.
void read_rows_3(const FileToRead& file, const std::vector<FittedParameter*>& parameters) {
  struct Row : FittedParameter {
    bool is_at_bound = false;
    Judgement judged;
  };
  std::vector<Row> rows(parameters.size());
  ReadRows<Row> of_file(file, pointers_to(std::span(rows)));
  of_file.columns("parameters", [](auto& columns) {
    columns("value", "", PLASTICA_MEMBER(value));
    columns("start", "", PLASTICA_MEMBER(start));
    columns("lower", "", PLASTICA_MEMBER(lower));
    columns("upper", "", PLASTICA_MEMBER(upper));
    columns("standard_error", "", PLASTICA_MEMBER(standard_error));
    columns("noise_error", "", PLASTICA_MEMBER(noise_error));
    columns("sampling_error", "", PLASTICA_MEMBER(sampling_error));
    columns("misfit_error", "", PLASTICA_MEMBER(misfit_error));
    columns("interval_low", "", PLASTICA_MEMBER(interval_low));
    columns("interval_high", "", PLASTICA_MEMBER(interval_high));
    columns("degrees_of_freedom", "1", PLASTICA_MEMBER(degrees_of_freedom));
    columns("at_bound", "", PLASTICA_MEMBER(is_at_bound));
    columns("verdict", "", PLASTICA_MEMBER(judged.verdict));
    columns("verdict_number", "", PLASTICA_MEMBER(judged.number));
  });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows[i];
    row.path = parameters[i]->path;
    row.dimension = parameters[i]->dimension;
    row.judgement = row.judged;
    row.identified = row.judged.verdict != Verdict::NotIdentified;
    row.logarithmic = row.lower > 0.0;
    const bool low = std::abs(row.value - row.lower) <= std::abs(row.upper - row.value);
    row.at_lower = row.is_at_bound && low;
    row.at_upper = row.is_at_bound && !low;
    *parameters[i] = std::move(static_cast<FittedParameter&>(row));
  }
}

}  // namespace

void read_parameters_4(const io::Hdf5Group& root, int version, std::vector<FitRecord>& records,
                       const FitOptions& options) {
  const FileToRead file{root, kFitRules, version};
  const auto present = root.read<std::uint8_t>("parameters/present");
  if (present.size() != records.size()) {
    file.refuse("parameters/present", "does not have a row for each fit");
  }
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (present[i] == 0) continue;
    for (const Parameter& parameter : parameters_of(records[i], options)) {
      FittedParameter& p = records[i].result.parameters.emplace_back();
      p.path = parameter.field->path;
      p.dimension = parameter.field->dimension;
      p.role = parameter.role;
    }
  }
  for (const Parameter& parameter : calibrate::parameters_of(options.laws, options.parameters)) {
    std::vector<FittedParameter*> rows;
    for (FitRecord& record : records) {
      auto& own = record.result.parameters;
      const auto found = std::ranges::find(own, parameter.field->path, &FittedParameter::path);
      rows.push_back(found == own.end() ? nullptr : &*found);
    }
    ReadRows<FittedParameter>(file, rows)
        .columns("parameters/" + parameter.name(), kDescribeParameter);
    if (version >= 4) continue;
    // Version 3 has both errors, whose squares differ by that of the sampling.
    for (FittedParameter* p : rows) {
      if (p == nullptr || !p->has_error()) continue;
      p->sampling_error = std::sqrt(
          std::max(0.0, p->standard_error * p->standard_error - p->noise_error * p->noise_error));
    }
  }
}

void read_scene_parameters_4(const io::Hdf5Group& root, int version,
                             const std::vector<FitOutcome*>& fits) {
  const FileToRead file{root, kFitRules, version};
  ReadRows<FitOutcome> rows(file, fits);
  auto parameters = rows.list("parameters", PLASTICA_MEMBER(parameters), kDescribeWhoseParameter);
  if (version == 3) {
    read_rows_3(file, parameters.rows());
  } else {
    parameters.columns("parameters", kDescribeParameter);
  }
  for (FittedParameter* parameter : parameters.rows()) {
    parameter->path = new_path(parameter->path);
    if (find_field_or_null(parameter->path) != nullptr) continue;
    io::refuse_value(root, "parameters/path", parameter->path, "must be a field");
  }
}

}  // namespace plastica::calibrate::store
