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
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/scene_fit_words.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;

/// Paths that any fit has, in the order in which they come up first.
std::vector<std::pair<std::string, Dimension>> all_paths(std::span<const SceneFitRecord> records) {
  std::vector<std::pair<std::string, Dimension>> all;
  for (const SceneFitRecord& record : records) {
    for (const SceneParameter& p : record.result.parameters) {
      const std::pair path{p.path, p.dimension};
      if (std::ranges::find(all, path) == all.end()) all.push_back(path);
    }
  }
  return all;
}

/// A column of each parameter.
struct Column {
  enum class Unit { Own, One, None };
  const char* name;
  Unit unit;
  std::string (*cell)(const SceneFitResult& result, std::size_t parameter);
  /// Of an interval beside that of the covariance: whether a fit has it. Null: all have.
  bool (*there)(const SceneIntervals& intervals) = nullptr;
};
using Unit = Column::Unit;

template <double SceneParameter::*member>
std::string of_parameter(const SceneFitResult& result, std::size_t i) {
  return cell_of(result.parameters[i].*member);
}

template <double SegmentsError::*member>
std::string of_segments(const SceneFitResult& result, std::size_t i) {
  return cell_of((result.segments ? result.segments->parameters[i] : SegmentsError{}).*member);
}

template <double SceneProfile::*member>
std::string of_profile(const SceneFitResult& result, std::size_t i) {
  const auto& profiles = result.intervals.profiles;
  return i < profiles.size() ? cell_of(profiles[i].*member) : std::string();
}

template <ProfileEnd SceneProfile::*member>
std::string end_of_profile(const SceneFitResult& result, std::size_t i) {
  const auto& profiles = result.intervals.profiles;
  return i < profiles.size() ? std::string(name_of(profiles[i].*member)) : std::string();
}

template <SceneBootstrap SceneIntervals::*which, double BootstrapInterval::*member>
std::string of_bootstrap(const SceneFitResult& result, std::size_t i) {
  const auto& intervals = (result.intervals.*which).intervals;
  return i < intervals.size() ? cell_of(intervals[i].*member) : std::string();
}

bool has_profiles(const SceneIntervals& all) { return !all.profiles.empty(); }

template <SceneBootstrap SceneIntervals::*which>
bool has_bootstrap(const SceneIntervals& all) {
  return !(all.*which).intervals.empty();
}

const Column kColumns[] = {
    {"", Unit::Own, of_parameter<&SceneParameter::value>},
    {".stderr", Unit::Own, of_parameter<&SceneParameter::standard_error>},
    {".low", Unit::Own, of_parameter<&SceneParameter::interval_low>},
    {".high", Unit::Own, of_parameter<&SceneParameter::interval_high>},
    {".noise_error", Unit::Own, of_parameter<&SceneParameter::noise_error>},
    {".sampling_error", Unit::Own, of_parameter<&SceneParameter::sampling_error>},
    {".misfit_error", Unit::Own, of_parameter<&SceneParameter::misfit_error>},
    {".degrees_of_freedom", Unit::One, of_parameter<&SceneParameter::degrees_of_freedom>},
    {".extrapolated", Unit::Own, of_segments<&SegmentsError::extrapolated>},
    {".segments_error", Unit::Own, of_segments<&SegmentsError::error>},
    {".profile_low", Unit::Own, of_profile<&SceneProfile::low>, has_profiles},
    {".profile_high", Unit::Own, of_profile<&SceneProfile::high>, has_profiles},
    {".profile_low_end", Unit::None, end_of_profile<&SceneProfile::low_end>, has_profiles},
    {".profile_high_end", Unit::None, end_of_profile<&SceneProfile::high_end>, has_profiles},
    {".bootstrap_low", Unit::Own, of_bootstrap<&SceneIntervals::residuals, &BootstrapInterval::low>,
     has_bootstrap<&SceneIntervals::residuals>},
    {".bootstrap_high", Unit::Own,
     of_bootstrap<&SceneIntervals::residuals, &BootstrapInterval::high>,
     has_bootstrap<&SceneIntervals::residuals>},
    {".specimens_low", Unit::Own, of_bootstrap<&SceneIntervals::specimens, &BootstrapInterval::low>,
     has_bootstrap<&SceneIntervals::specimens>},
    {".specimens_high", Unit::Own,
     of_bootstrap<&SceneIntervals::specimens, &BootstrapInterval::high>,
     has_bootstrap<&SceneIntervals::specimens>},
    {".verdict", Unit::None,
     [](const SceneFitResult& result, std::size_t i) {
       return std::string(name_of(result.parameters[i].verdict));
     }},
    {".verdict_number", Unit::None, of_parameter<&SceneParameter::verdict_number>}};

/// Those that any fit has.
std::vector<Column> columns_of(std::span<const SceneFitRecord> records) {
  std::vector<Column> columns;
  for (const Column& column : kColumns) {
    const bool any =
        column.there == nullptr || std::ranges::any_of(records, [&](const SceneFitRecord& record) {
          return column.there(record.result.intervals);
        });
    if (any) columns.push_back(column);
  }
  return columns;
}

std::string title_of(const Column& column, const std::string& path, Dimension dimension) {
  if (column.unit == Unit::None) return path + column.name;
  const std::string_view unit =
      column.unit == Unit::One ? std::string_view("1") : si_unit(dimension);
  return fmt::format("{}{} [{}]", path, column.name, unit);
}

}  // namespace

void write_scene_fits_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  const auto paths = all_paths(records);
  const std::vector<Column> columns = columns_of(records);
  std::vector<std::string> header = {"name", "law", "status", "reason"};
  for (const auto& [path, dimension] : paths) {
    for (const Column& column : columns) header.push_back(title_of(column, path, dimension));
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
      const auto p = std::ranges::find(result.parameters, path, &SceneParameter::path);
      if (p == result.parameters.end() || !fitted) {
        row.insert(row.end(), columns.size(), std::string());
        continue;
      }
      const auto index = static_cast<std::size_t>(p - result.parameters.begin());
      for (const Column& column : columns) row.push_back(column.cell(result, index));
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
  put_row(out, {"fit", "target", "abscissa", "abscissa_unit", "ordinate", "ordinate_unit",
                "samples", "weight", "broke_at", "broke_half_interval", "level", "noise",
                "noise_is", "degrees_of_freedom [1]", "misfit_share [1]", "runs_probability [1]",
                "break_strain [1]"});
  const bool compared = compares_laws(records);
  for (const SceneFitRecord& record : records) {
    const bool there = record.result.parts.size() == record.targets.size();
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
        const ScenePartFit& part = record.result.parts[i];
        row.insert(row.end(),
                   {word_of(part.level), cell_of(part.noise), target.noise ? "given" : "estimated",
                    cell_of(part.degrees_of_freedom), cell_of(part.misfit_share),
                    cell_of(part.runs_probability), cell_of(part.break_strain)});
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
    const bool there = record.result.parts.size() == record.targets.size();
    for (std::size_t i = 0; i < record.targets.size(); ++i) {
      const SceneTarget& target = record.targets[i];
      static const std::vector<double> kNone;
      const std::vector<double>& fitted = there ? record.result.parts[i].fitted : kNone;
      const std::vector<double>& error = there ? record.result.parts[i].fitted_error : kNone;
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
