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
#include "calibrate/report/parameter_columns.hpp"
#include "calibrate/report/scene_fit_words.hpp"

namespace plastica::calibrate {

using namespace report;

void write_scene_fits_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  std::vector<FitRow> fits;
  for (const SceneFitRecord& record : records) {
    const auto& segments = record.result.segments;
    fits.push_back({.fit = &record.result, .segments = segments ? &*segments : nullptr});
  }
  const ParameterColumns parameters(fits);
  std::vector<std::string> header = {"name", "law", "status", "reason"};
  parameters.add_titles(header);
  for (const char* last : {"cost [1]", "degrees_of_freedom [1]", "starts", "runs", "search_runs",
                           "failed_runs", "held_out [1]"}) {
    header.emplace_back(last);
  }
  put_row(out, header);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const SceneFitResult& result = records[i].result;
    std::vector<std::string> row = {records[i].name, laws_text(result),
                                    std::string(word_of(result.status)), result.reason};
    parameters.add_cells(fits[i], row);
    const std::vector<double> costs = sorted_costs(result);
    const bool fitted = result.is_fitted();
    row.push_back(fitted && !costs.empty() ? cell_of(costs.front()) : std::string());
    row.push_back(fitted ? cell_of(result.degrees_of_freedom) : std::string());
    row.push_back(std::to_string(result.starts.size()));
    row.push_back(std::to_string(result.runs));
    row.push_back(std::to_string(result.search_runs));
    row.push_back(std::to_string(result.failed_runs));
    row.push_back(cell_of(result.held_out_misfit()));
    put_row(out, row);
  }
}

void write_scene_targets_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  put_row(out,
          {"fit", "target", "abscissa", "abscissa_unit", "ordinate", "ordinate_unit", "samples",
           "weight", "broke_at", "broke_half_interval", "law", "level", "noise", "noise_is",
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
                   {std::string(name_of(of_target.law)), std::string(word_of(of_target.level)),
                    cell_of(of_target.noise), target.noise ? "given" : "estimated",
                    cell_of(of_target.degrees_of_freedom), cell_of(of_target.misfit_fraction),
                    cell_of(of_target.runs_test_p), cell_of(of_target.break_strain)});
      } else {
        row.insert(row.end(), 8, std::string());
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
