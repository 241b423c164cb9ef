#include "calibrate/report/scene_fit_csv.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/csv_cells.hpp"
#include "calibrate/report/described.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "calibrate/report/shown_intervals.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;

/// Paths that any fit has, in the order in which they come up first.
std::vector<std::pair<std::string, Dimension>> all_paths(std::span<const SceneFitRecord> records) {
  std::vector<std::pair<std::string, Dimension>> all;
  for (const SceneFitRecord& record : records) {
    for (const FittedParameter& p : record.result.parameters) {
      const std::pair path{p.path, p.dimension};
      if (std::ranges::find(all, path) == all.end()) all.push_back(path);
    }
  }
  return all;
}

/// A fitted parameter beside what else a row has of it.
struct ParameterRow {
  const FittedParameter* fitted = nullptr;  ///< null: the fit does not have it
  const SegmentsError* segments = nullptr;  ///< null: it was not fitted with other segments
  std::size_t index = 0;                    ///< among the parameters of the fit
};

ParameterRow row_of(const SceneFitResult& result, const std::string& path) {
  const auto p = std::ranges::find(result.parameters, path, &FittedParameter::path);
  if (p == result.parameters.end() || result.status != FitStatus::Fitted) return {};
  const auto index = static_cast<std::size_t>(p - result.parameters.begin());
  return {&*p, result.segments ? &result.segments->parameters[index] : nullptr, index};
}

/// Columns of a parameter, but for those of its intervals.
CellDescriber<FittedParameter> columns_of(const ParameterRow& parameter, const std::string& path,
                                          Dimension dimension) {
  CellDescriber<FittedParameter> columns(parameter.fitted, path, si_unit(dimension));
  kDescribeParameter(columns);
  CellDescriber<SegmentsError> segments(parameter.segments, path, si_unit(dimension));
  segments("extrapolated", kOwnUnits, PLASTICA_MEMBER(extrapolated));
  segments("segments_error", kOwnUnits, PLASTICA_MEMBER(error));
  columns.names.insert(columns.names.end(), segments.names.begin(), segments.names.end());
  columns.cells.insert(columns.cells.end(), segments.cells.begin(), segments.cells.end());
  return columns;
}

std::vector<IntervalColumn> intervals_of(std::span<const SceneFitRecord> records) {
  std::vector<const FitIntervals*> all;
  for (const SceneFitRecord& record : records) all.push_back(&record.result.intervals);
  return interval_columns(all);
}

}  // namespace

void write_scene_fits_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  const auto paths = all_paths(records);
  const std::vector<IntervalColumn> intervals = intervals_of(records);
  std::vector<std::string> header = {"name", "law", "status", "reason"};
  for (const auto& [path, dimension] : paths) {
    const std::vector<std::string> names = columns_of({}, path, dimension).names;
    header.insert(header.end(), names.begin(), names.end());
    for (const IntervalColumn& column : intervals) {
      header.push_back(path + column.name);
      if (column.has_unit) header.back() += fmt::format(" [{}]", si_unit(dimension));
    }
  }
  for (const char* last :
       {"cost [1]", "degrees_of_freedom [1]", "starts", "runs", "search_runs", "failed_runs"}) {
    header.emplace_back(last);
  }
  put_row(out, header);
  for (const SceneFitRecord& record : records) {
    const SceneFitResult& result = record.result;
    const bool fitted = result.status == FitStatus::Fitted;
    std::vector<std::string> row = {record.name, std::string(name_of(result.law)),
                                    std::string(word_of(result.status)), result.reason};
    for (const auto& [path, dimension] : paths) {
      const ParameterRow parameter = row_of(result, path);
      const std::vector<std::string> cells = columns_of(parameter, path, dimension).cells;
      row.insert(row.end(), cells.begin(), cells.end());
      for (const IntervalColumn& column : intervals) {
        row.push_back(parameter.fitted == nullptr ? std::string()
                                                  : column.cell(result.intervals, parameter.index));
      }
    }
    const std::vector<double> costs = sorted_costs(result);
    row.push_back(fitted && !costs.empty() ? cell_of(costs.front()) : std::string());
    row.push_back(fitted ? cell_of(result.degrees_of_freedom) : std::string());
    row.push_back(std::to_string(result.starts.size()));
    row.push_back(std::to_string(result.runs));
    row.push_back(std::to_string(result.search_runs));
    row.push_back(std::to_string(result.failed_runs));
    put_row(out, row);
  }
}

void write_scene_targets_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  put_row(out,
          {"fit", "target", "abscissa", "abscissa_unit", "ordinate", "ordinate_unit", "samples",
           "weight", "broke_at", "broke_half_interval", "level", "noise", "noise_is",
           "degrees_of_freedom [1]", "misfit_fraction [1]", "runs_test_p [1]", "break_strain [1]"});
  const bool compared = compares_laws(records);
  for (const SceneFitRecord& record : records) {
    const bool there = record.result.targets.size() == record.targets.size();
    for (std::size_t i = 0; i < record.targets.size(); ++i) {
      const SceneTarget& target = record.targets[i];
      std::vector<std::string> row = {label_of(record, compared),
                                      target.name,
                                      abscissa_text(target),
                                      std::string(si_unit(target.abscissa_is)),
                                      target.ordinate_probe,
                                      std::string(si_unit(target.ordinate_is)),
                                      std::to_string(target.abscissa.size()),
                                      cell_of(record.weights[i])};
      row.push_back(target.broke ? cell_of(target.broke->at) : std::string());
      row.push_back(target.broke ? cell_of(target.broke->half_interval) : std::string());
      if (there) {
        const TargetFit& of_target = record.result.targets[i];
        row.insert(row.end(),
                   {std::string(word_of(of_target.level)), cell_of(of_target.noise),
                    target.noise ? "given" : "estimated", cell_of(of_target.degrees_of_freedom),
                    cell_of(of_target.misfit_fraction), cell_of(of_target.runs_test_p),
                    cell_of(of_target.break_strain)});
      } else {
        row.insert(row.end(), 7, std::string());
      }
      put_row(out, row);
    }
  }
}

void write_scene_fit_curves_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  out << "fit,target,abscissa,abscissa_unit,measured,fitted,fitted_error,ordinate_unit\n";
  const bool compared = compares_laws(records);
  for (const SceneFitRecord& record : records) {
    const bool there = record.result.targets.size() == record.targets.size();
    for (std::size_t i = 0; i < record.targets.size(); ++i) {
      const SceneTarget& target = record.targets[i];
      static const std::vector<double> kNone;
      const std::vector<double>& fitted = there ? record.result.targets[i].fitted : kNone;
      const std::vector<double>& error = there ? record.result.targets[i].fitted_error : kNone;
      for (std::size_t k = 0; k < target.abscissa.size(); ++k) {
        put_row(out, {label_of(record, compared), target.name, cell_of(target.abscissa[k]),
                      std::string(si_unit(target.abscissa_is)), cell_of(target.ordinate[k]),
                      k < fitted.size() ? cell_of(fitted[k]) : std::string(),
                      k < error.size() ? cell_of(error[k]) : std::string(),
                      std::string(si_unit(target.ordinate_is))});
      }
    }
  }
}

}  // namespace plastica::calibrate
