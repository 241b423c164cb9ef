#include "calibrate/report/scene_fit_csv.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/csv_cells.hpp"
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

using Ends = std::pair<double, double>;

std::optional<Ends> ends_of(const SceneBootstrap& bootstrap, std::size_t i) {
  if (i >= bootstrap.intervals.size()) return std::nullopt;
  return Ends(bootstrap.intervals[i].low, bootstrap.intervals[i].high);
}

/// An interval that a fit may have beside that of the covariance.
struct IntervalKind {
  const char* low;
  const char* high;
  std::optional<Ends> (*ends)(const SceneIntervals& intervals, std::size_t parameter);
};
const IntervalKind kIntervalKinds[] = {
    {".profile_low", ".profile_high",
     [](const SceneIntervals& all, std::size_t i) {
       if (i >= all.profiles.size()) return std::optional<Ends>();
       return std::optional(Ends(all.profiles[i].low, all.profiles[i].high));
     }},
    {".bootstrap_low", ".bootstrap_high",
     [](const SceneIntervals& all, std::size_t i) { return ends_of(all.residuals, i); }},
    {".specimens_low", ".specimens_high",
     [](const SceneIntervals& all, std::size_t i) { return ends_of(all.specimens, i); }}};

/// Those that any fit has.
std::vector<IntervalKind> kinds_of(std::span<const SceneFitRecord> records) {
  std::vector<IntervalKind> kinds;
  for (const IntervalKind& kind : kIntervalKinds) {
    const bool any = std::ranges::any_of(records, [&](const SceneFitRecord& record) {
      return kind.ends(record.result.intervals, 0).has_value();
    });
    if (any) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace

void write_scene_fits_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  const auto paths = all_paths(records);
  const std::vector<IntervalKind> kinds = kinds_of(records);
  std::vector<std::string> header = {"name", "status", "reason"};
  for (const auto& [path, dimension] : paths) {
    std::vector<const char*> columns = {"",      ".stderr",       ".low",
                                        ".high", ".extrapolated", ".segments_error"};
    for (const IntervalKind& kind : kinds) columns.insert(columns.end(), {kind.low, kind.high});
    for (const char* what : columns) {
      header.push_back(fmt::format("{}{} [{}]", path, what, si_unit(dimension)));
    }
    header.push_back(path + ".verdict");
  }
  for (const char* last : {"cost [1]", "degrees_of_freedom [1]", "starts", "runs", "failed_runs"}) {
    header.emplace_back(last);
  }
  put_row(out, header);
  for (const SceneFitRecord& record : records) {
    const SceneFitResult& result = record.result;
    const bool fitted = result.status == FitStatus::Fitted;
    std::vector<std::string> row = {record.name, std::string(word_of(result.status)),
                                    result.reason};
    for (const auto& [path, dimension] : paths) {
      const auto p = std::ranges::find(result.parameters, path, &SceneParameter::path);
      if (p == result.parameters.end() || !fitted) {
        row.insert(row.end(), 2 * kinds.size() + 7, std::string());
        continue;
      }
      const auto index = static_cast<std::size_t>(p - result.parameters.begin());
      for (const double value : {p->value, p->standard_error, p->interval_low, p->interval_high}) {
        row.push_back(cell_of(value));
      }
      const SegmentsError error =
          result.segments ? result.segments->parameters[index] : SegmentsError{};
      row.push_back(cell_of(error.extrapolated));
      row.push_back(cell_of(error.error));
      for (const IntervalKind& kind : kinds) {
        const auto ends = kind.ends(result.intervals, index);
        row.push_back(ends ? cell_of(ends->first) : std::string());
        row.push_back(ends ? cell_of(ends->second) : std::string());
      }
      row.emplace_back(name_of(p->verdict));
    }
    const std::vector<double> costs = sorted_costs(result);
    row.push_back(fitted && !costs.empty() ? cell_of(costs.front()) : std::string());
    row.push_back(fitted ? cell_of(result.degrees_of_freedom) : std::string());
    row.push_back(std::to_string(result.starts.size()));
    row.push_back(std::to_string(result.runs));
    row.push_back(std::to_string(result.failed_runs));
    put_row(out, row);
  }
}

void write_scene_targets_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  put_row(out, {"fit", "target", "abscissa", "abscissa_unit", "ordinate", "ordinate_unit",
                "samples", "weight", "broke_at", "broke_half_interval", "level", "noise",
                "noise_is", "misfit_share [1]", "runs_probability [1]", "break_strain [1]"});
  for (const SceneFitRecord& record : records) {
    const bool there = record.result.parts.size() == record.targets.size();
    for (std::size_t i = 0; i < record.targets.size(); ++i) {
      const SceneTarget& target = record.targets[i];
      std::vector<std::string> row = {record.name,
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
        row.insert(row.end(), {word_of(part.level), cell_of(part.noise),
                               target.noise ? "given" : "estimated", cell_of(part.misfit_share),
                               cell_of(part.runs_probability), cell_of(part.break_strain)});
      } else {
        row.insert(row.end(), 6, std::string());
      }
      put_row(out, row);
    }
  }
}

void write_scene_fit_curves_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  out << "fit,target,abscissa,abscissa_unit,measured,fitted,fitted_error,ordinate_unit\n";
  for (const SceneFitRecord& record : records) {
    const bool there = record.result.parts.size() == record.targets.size();
    for (std::size_t i = 0; i < record.targets.size(); ++i) {
      const SceneTarget& target = record.targets[i];
      static const std::vector<double> kNone;
      const std::vector<double>& fitted = there ? record.result.parts[i].fitted : kNone;
      const std::vector<double>& error = there ? record.result.parts[i].fitted_error : kNone;
      for (std::size_t k = 0; k < target.abscissa.size(); ++k) {
        put_row(out, {record.name, target.name, cell_of(target.abscissa[k]),
                      std::string(si_unit(target.abscissa_is)), cell_of(target.ordinate[k]),
                      k < fitted.size() ? cell_of(fitted[k]) : std::string(),
                      k < error.size() ? cell_of(error[k]) : std::string(),
                      std::string(si_unit(target.ordinate_is))});
      }
    }
  }
}

}  // namespace plastica::calibrate
