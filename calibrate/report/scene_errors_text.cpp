#include "calibrate/report/scene_errors_text.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "plastica/report/table.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::Ink;
using plastica::report::kWidth;
using plastica::report::Table;
using Align = Table::Align;

/// A standard error as a cell, "-" where there is none.
std::string error_cell(double error, const DisplayUnit& unit) {
  return std::isfinite(error) && error != 0.0 ? significant(error / unit.scale, 2) : "-";
}

/// A source of errors: its column, and what it does to a parameter as a standard error [SI], NaN
/// if that is not known.
struct ErrorColumn {
  std::string name;
  std::function<double(std::size_t parameter)> error;
};

std::vector<ErrorColumn> error_columns(const SceneFitResult& result) {
  std::vector<ErrorColumn> columns;
  const auto of_parameter = [&](double FittedParameter::*member) {
    return [&result, member](std::size_t i) { return result.parameters[i].*member; };
  };
  columns.push_back({"noise", of_parameter(&FittedParameter::noise_error)});
  columns.push_back({"sampling", of_parameter(&FittedParameter::sampling_error)});
  if (result.segments) {
    columns.push_back({"segments", [&](std::size_t i) {
                         return result.segments->parameters[i].error / std::sqrt(3.0);
                       }});
  }
  if (result.intervals.specimens.resamples > 0) {
    columns.push_back({"specimens", [&](std::size_t i) {
                         return result.intervals.specimens.intervals[i].standard_error;
                       }});
  }
  columns.push_back({"misfit", of_parameter(&FittedParameter::misfit_error)});
  return columns;
}

/// "1.98", "2 (assumed)", "diverges".
std::string order_text(const SegmentsError& error) {
  if (error.trend == SegmentsTrend::Monotone) return fmt::format("{:.2f}", error.observed_order);
  if (error.trend == SegmentsTrend::Assumed) return fmt::format("{:g} (assumed)", error.order);
  return std::string(name_of(error.trend));
}

/// Digits that show the values' differences.
std::string value_cell(double value, const SegmentsError& error, const DisplayUnit& unit) {
  if (!std::isfinite(value)) return "-";
  const double scaled = value / unit.scale;
  if (!(error.extrapolated_error > 0.0)) return significant(scaled);
  return fmt::format("{:.{}f}", scaled,
                     decimals_for(scaled, error.extrapolated_error / unit.scale));
}

}  // namespace

std::string errors_text(const SceneFitRecord& record, const Ink& ink) {
  const SceneFitResult& result = record.result;
  if (result.status != FitStatus::Fitted || result.parameters.empty()) return {};
  const std::vector<ErrorColumn> sources = error_columns(result);
  std::vector<Table::Column> columns = {{"", Align::Left}};
  for (const ErrorColumn& source : sources) columns.push_back({source.name, Align::Right});
  columns.push_back({"", Align::Left});
  Table table(std::move(columns));
  for (std::size_t i = 0; i < result.free_count(); ++i) {
    const FittedParameter& parameter = result.parameters[i];
    const DisplayUnit unit = display_unit(parameter);
    std::vector<std::string> cells = {short_name(parameter.path)};
    for (const ErrorColumn& source : sources) cells.push_back(error_cell(source.error(i), unit));
    cells.emplace_back(unit.name);
    table.add(std::move(cells));
  }
  return '\n' + ink.heading("Standard errors\n") + table.text(2, kWidth);
}

std::string segments_text(const SceneFitRecord& record, const Ink& ink) {
  const SceneFitResult& result = record.result;
  if (!result.segments || result.free_count() != result.segments->parameters.size()) return {};
  const SceneSegments& segments = *result.segments;
  Table table({{"", Align::Left},
               {"N/2", Align::Right},
               {fmt::format("N = {}", segments.segments), Align::Right},
               {"2N", Align::Right},
               {"order", Align::Left},
               {"extrapolated", Align::PlusMinus},
               {"", Align::Left}});
  for (std::size_t i = 0; i < result.free_count(); ++i) {
    const FittedParameter& parameter = result.parameters[i];
    const SegmentsError& error = segments.parameters[i];
    const DisplayUnit unit = display_unit(parameter);
    const auto cell = [&](double value) { return value_cell(value, error, unit); };
    table.add({short_name(parameter.path), cell(error.at_half), cell(error.at_own),
               cell(error.at_twice), order_text(error),
               std::isfinite(error.extrapolated) ? with_error(error.extrapolated / unit.scale,
                                                              error.extrapolated_error / unit.scale)
                                                 : "-",
               std::string(unit.name)});
  }
  std::string text = '\n' + ink.heading("Segments\n") + table.text(2, kWidth);
  if (!segments.note.empty()) text += wrapped("  ", printable(segments.note), kWidth);
  return text;
}

}  // namespace plastica::calibrate::report
