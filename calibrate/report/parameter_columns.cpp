#include "calibrate/report/parameter_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "calibrate/report/csv_cells.hpp"

namespace plastica::calibrate::report {
namespace {

constexpr auto kDescribeExtrapolated = [](auto& d) {
  d("extrapolated", kOwnUnits, PLASTICA_MEMBER(extrapolated));
  d("segments_error", kOwnUnits, PLASTICA_MEMBER(error));
};

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
    report::add_titles(header, described(none, kDescribeParameter), of, unit);
    const SegmentsError* no_error = nullptr;
    if (has_segments_) {
      report::add_titles(header, described(no_error, kDescribeExtrapolated), of, unit);
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
    report::add_cells(cells, described(fitted, kDescribeParameter));
    const auto at = static_cast<std::size_t>(std::ranges::find(free, fitted) - free.begin());
    const bool is_free = at < free.size();
    if (has_segments_) {
      const bool known = is_free && row.segments != nullptr;
      const SegmentsError* error = known ? &row.segments->parameters.at(at) : nullptr;
      report::add_cells(cells, described(error, kDescribeExtrapolated));
    }
    for (const IntervalColumn& column : intervals_) {
      cells.push_back(is_free ? column.cell(row.fit->intervals, at) : std::string());
    }
  }
}

}  // namespace plastica::calibrate::report
