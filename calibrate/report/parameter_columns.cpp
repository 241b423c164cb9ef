#include "calibrate/report/parameter_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "calibrate/report/described.hpp"

namespace plastica::calibrate::report {
namespace {

template <typename Row>
void append(std::vector<std::string>& to, const std::vector<std::string> CellDescriber<Row>::*list,
            const CellDescriber<Row>& from) {
  to.insert(to.end(), (from.*list).begin(), (from.*list).end());
}

/// @param parameter  null: empty cells
CellDescriber<FittedParameter> columns_of(const FittedParameter* parameter,
                                          const std::string& title, std::string_view unit) {
  CellDescriber<FittedParameter> columns(parameter, title, unit);
  kDescribeParameter(columns);
  return columns;
}

/// @param segments  null: empty cells
CellDescriber<SegmentsError> columns_of(const SegmentsError* segments, const std::string& title,
                                        std::string_view unit) {
  CellDescriber<SegmentsError> columns(segments, title, unit);
  columns("extrapolated", kOwnUnits, PLASTICA_MEMBER(extrapolated));
  columns("segments_error", kOwnUnits, PLASTICA_MEMBER(error));
  return columns;
}

}  // namespace

ParameterColumns::ParameterColumns(const std::vector<FitRow>& fits) {
  std::vector<const FitIntervals*> intervals;
  for (const FitRow& row : fits) {
    intervals.push_back(&row.fit->intervals);
    has_segments_ = has_segments_ || row.segments != nullptr;
    for (const FittedParameter& p : row.fit->parameters) {
      if (std::ranges::find(parameters_, p.path, &Parameter::path) == parameters_.end()) {
        parameters_.push_back({p.path, p.dimension});
      }
    }
  }
  intervals_ = interval_columns(intervals);
}

void ParameterColumns::add_titles(std::vector<std::string>& header) const {
  for (const Parameter& parameter : parameters_) {
    const std::string of = "fit." + std::string(last_part(parameter.path));
    const std::string_view unit = si_unit(parameter.dimension);
    const FittedParameter* none = nullptr;
    append(header, &CellDescriber<FittedParameter>::names, columns_of(none, of, unit));
    const SegmentsError* no_error = nullptr;
    if (has_segments_) {
      append(header, &CellDescriber<SegmentsError>::names, columns_of(no_error, of, unit));
    }
    for (const IntervalColumn& column : intervals_) {
      header.push_back(of + column.name);
      if (column.has_unit) header.back() += fmt::format(" [{}]", unit);
    }
  }
}

void ParameterColumns::add_cells(const FitRow& row, std::vector<std::string>& cells) const {
  const std::vector<const FittedParameter*> free = row.fit->free_parameters();
  for (const Parameter& parameter : parameters_) {
    const FittedParameter* fitted = row.fit->find_parameter(parameter.path);
    append(cells, &CellDescriber<FittedParameter>::cells, columns_of(fitted, {}, {}));
    const auto at = static_cast<std::size_t>(std::ranges::find(free, fitted) - free.begin());
    const bool is_free = at < free.size();
    if (has_segments_) {
      const bool known = is_free && row.segments != nullptr;
      const SegmentsError* error = known ? &row.segments->parameters.at(at) : nullptr;
      append(cells, &CellDescriber<SegmentsError>::cells, columns_of(error, {}, {}));
    }
    for (const IntervalColumn& column : intervals_) {
      cells.push_back(is_free ? column.cell(row.fit->intervals, at) : std::string());
    }
  }
}

}  // namespace plastica::calibrate::report
