#include "calibrate/report/csv_export.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/csv_cells.hpp"
#include "calibrate/report/described.hpp"
#include "calibrate/report/format.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/parameter_columns.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/summary.hpp"
#include "calibrate/result/describe_fit.hpp"
#include "calibrate/result/describe_target.hpp"
#include "plastica/report/format.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;

/// Names that any record has, in the order in which they come up first.
template <typename Names>
std::vector<std::string> all_names(std::span<const FitRecord> records, const Names& names_of) {
  std::vector<std::string> all;
  for (const FitRecord& record : records) {
    for (const auto& entry : names_of(record)) {
      if (std::find(all.begin(), all.end(), entry) == all.end()) all.push_back(entry);
    }
  }
  return all;
}

std::vector<std::string> group_keys(const FitRecord& record) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : record.target.group) keys.push_back(key);
  return keys;
}

/// The columns of a fit and of its curve's characteristics; null: empty cells.
CellDescriber<FitRecord> fit_columns(const FitRecord* record) {
  CellDescriber<FitRecord> columns(record, "", {});
  kDescribeFit(columns);
  columns.names.emplace_back("evaluations");
  columns.cells.push_back(record == nullptr ? "" : std::to_string(record->result.evaluations()));
  columns.names.emplace_back("held_out [1]");
  columns.cells.push_back(record == nullptr ? "" : cell_of(record->result.held_out_misfit()));
  CellDescriber<Characteristics> characteristics(
      record == nullptr ? nullptr : &record->target.characteristics, "", {});
  kDescribeCharacteristics(characteristics);
  columns.append(characteristics);
  // Of a rejected target the fit has none of its own.
  if (record == nullptr) return columns;
  const auto at = std::ranges::find(columns.names, "reason") - columns.names.begin();
  columns.cells[static_cast<std::size_t>(at)] = reason_of(*record);
  return columns;
}

/// One line of the curves; the columns are those of write_curves_csv.
void put_sample(std::ostream& out, const std::string& name, double strain,
                std::optional<double> measured, std::optional<double> fitted) {
  out << name << ',' << cell_of(strain) << ',' << cell_of(measured) << ',' << cell_of(fitted)
      << '\n';
}

}  // namespace

void write_specimens_csv(std::ostream& out, std::span<const FitRecord> records) {
  const std::vector<std::string> keys = all_names(records, group_keys);
  std::vector<FitRow> fits;
  for (const FitRecord& record : records) fits.push_back({.fit = &record.result});
  const ParameterColumns parameters(fits);
  std::vector<std::string> header = fit_columns(nullptr).names;
  for (const std::string& key : keys) header.push_back("group." + key);
  parameters.add_titles(header);
  put_row(out, header);
  for (std::size_t i = 0; i < records.size(); ++i) {
    std::vector<std::string> row = fit_columns(&records[i]).cells;
    for (const std::string& key : keys) {
      const auto& group = records[i].target.group;
      const auto pair =
          std::ranges::find(group, key, [](const auto& entry) { return entry.first; });
      row.push_back(pair == group.end() ? std::string() : pair->second);
    }
    parameters.add_cells(fits[i], row);
    put_row(out, row);
  }
}

void write_curves_csv(std::ostream& out, std::span<const FitRecord> records) {
  const bool compared = compares_laws(records);
  out << "specimen,strain [1],stress_measured [Pa],stress_fitted [Pa]\n";
  for (const FitRecord& record : records) {
    const std::string name = plastica::report::csv_cell(label_of(record, compared));
    const Target& target = record.target;
    const Curve& measured = target.corrected.size() > 0 ? target.corrected : target.raw;
    const Curve fitted = report::fitted_with_fall(record.result);
    std::size_t j = 0;
    for (std::size_t i = 0; i < measured.size(); ++i) {
      // The fitted curve has the strains of the corrected one, and its break among or after them.
      while (fitted.size() - j > measured.size() - i && fitted.strain[j] != measured.strain[i]) {
        put_sample(out, name, fitted.strain[j], std::nullopt, fitted.stress[j]);
        ++j;
      }
      if (j < fitted.size() && fitted.strain[j] == measured.strain[i]) {
        put_sample(out, name, measured.strain[i], measured.stress[i], fitted.stress[j]);
        ++j;
      } else {
        put_sample(out, name, measured.strain[i], measured.stress[i], std::nullopt);
      }
    }
    for (; j < fitted.size(); ++j) {
      put_sample(out, name, fitted.strain[j], std::nullopt, fitted.stress[j]);
    }
  }
}

}  // namespace plastica::calibrate
