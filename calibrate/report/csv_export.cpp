#include "calibrate/report/csv_export.hpp"

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/report/csv_cells.hpp"
#include "calibrate/report/fit_entries.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/parameter_columns.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "calibrate/result/describe_target.hpp"
#include "plastica/report/format.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;

/// What the table of fits has of one kind alone, behind what all have: of curves their
/// characteristics and groups.
class OwnColumns {
 public:
  explicit OwnColumns(std::span<const FitRecord> records) {
    for (const FitRecord& record : records) {
      for (const auto& [key, value] : record.target.group) {
        if (std::ranges::find(keys_, key) == keys_.end()) keys_.push_back(key);
      }
    }
  }
  /// @param record  null: the names alone
  std::vector<Entry> of(const FitRecord* record) const {
    std::vector<Entry> entries = described(
        record == nullptr ? nullptr : &record->target.characteristics, kDescribeCharacteristics);
    for (const std::string& key : keys_) {
      Entry& entry = entries.emplace_back(Entry{"group." + key, "", nullptr});
      if (record == nullptr) continue;
      const auto& group = record->target.group;
      const auto pair = std::ranges::find(group, key, [](const auto& each) { return each.first; });
      if (pair != group.end()) entry.value = pair->second;
    }
    return entries;
  }

 private:
  std::vector<std::string> keys_;
};

/// Through scenes, in place of the list that JSON has of its searches: the best one's cost, and how
/// many there are. @param record  null: the names alone
std::vector<Entry> searches_of(const SceneFitRecord* record) {
  return described(record, [](auto& d) {
    d.derived("cost", "1", [](const auto& row) {
      const std::vector<double> costs = sorted_costs(row.result);
      return costs.empty() ? std::optional<double>() : costs.front();
    });
    d.derived("starts", "", [](const auto& row) { return row.result.starts.size(); });
  });
}

FitRow row_of(const FitRecord& record) { return {.fit = &record.result}; }
FitRow row_of(const SceneFitRecord& record) {
  const auto& segments = record.result.segments;
  return {.fit = &record.result, .segments = segments ? &*segments : nullptr};
}

/// @param own  the entries of one kind alone, of a record; of null their names
template <typename Record, typename Own>
void write_fits(std::ostream& out, std::span<const Record> records, const Own& own) {
  std::vector<FitRow> fits;
  for (const Record& record : records) fits.push_back(row_of(record));
  const ParameterColumns parameters(fits);
  const Record* none = nullptr;
  std::vector<std::string> header;
  add_titles(header, fit_entries(none));
  add_titles(header, own(none));
  parameters.add_titles(header);
  put_row(out, header);
  for (std::size_t i = 0; i < records.size(); ++i) {
    std::vector<std::string> row;
    add_cells(row, fit_entries(&records[i]));
    add_cells(row, own(&records[i]));
    parameters.add_cells(fits[i], row);
    put_row(out, row);
  }
}

/// One line of the curves; the columns are those of write_curves_csv.
void put_sample(std::ostream& out, const std::string& name, double strain,
                std::optional<double> measured, std::optional<double> fitted) {
  out << name << ',' << cell_of(strain) << ',' << cell_of(measured) << ',' << cell_of(fitted)
      << '\n';
}

}  // namespace

void write_fits_csv(std::ostream& out, std::span<const FitRecord> records) {
  const OwnColumns own(records);
  write_fits(out, records, [&](const FitRecord* record) { return own.of(record); });
}

void write_fits_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  write_fits(out, records, searches_of);
}

void write_targets_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
  std::vector<std::string> header{"fit"};
  add_titles(header, target_entries(nullptr, 0));
  put_row(out, header);
  const bool compared = compares_laws(records);
  for (const SceneFitRecord& record : records) {
    for (std::size_t t = 0; t < record.targets.size(); ++t) {
      std::vector<std::string> row{label_of(record, compared)};
      add_cells(row, target_entries(&record, t));
      put_row(out, row);
    }
  }
}

void write_curves_csv(std::ostream& out, std::span<const FitRecord> records) {
  require_curves(records);
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

void write_curves_csv(std::ostream& out, std::span<const SceneFitRecord> records) {
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
