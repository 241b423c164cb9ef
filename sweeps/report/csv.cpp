#include "sweeps/report/csv.hpp"

#include <fmt/format.h>

#include <optional>
#include <ostream>
#include <string>

#include "plastica/base/check.hpp"
#include "plastica/report/format.hpp"
#include "sweeps/report/case_rows.hpp"

namespace plastica::sweeps {
namespace {

using report::csv_cell;

std::string cell_of(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::string cell_of(const FieldValue& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return csv_cell(*word);
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number) : std::string();
}

}  // namespace

void write_cases_csv(std::ostream& out, const SweepRecord& record) {
  const std::string& unit = record.quantity.unit;
  out << "case";
  for (const Axis& axis : record.axes) {
    out << ',' << axis.field->path;
    if (axis.field->kind == FieldKind::Number) {
      out << fmt::format(" [{}]", si_unit(axis.field->dimension));
    }
  }
  out << fmt::format(
      ",status,reason,level,value [{0}],reference [{0}],error [1],error_reason,error_lacks,"
      "standard_error [{0}],segments,iterations,segment_iterations,cutbacks,energy_balance_error "
      "[1],"
      "last_time [s],last_value [{0}],seconds [s]\n",
      unit);
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const CaseResult& result = record.results[i];
    out << record.ids[i];
    for (std::size_t a = 0; a < record.axes.size(); ++a) out << ',' << cell_of(record.at(i, a));
    out << fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       name_of(result.status), csv_cell(result.reason), level_word(result.level),
                       cell_of(result.value), cell_of(record.comparison.reference[i]),
                       cell_of(record.comparison.error[i]), csv_cell(record.comparison.reason[i]),
                       csv_cell(record.comparison.lacks[i]), cell_of(result.standard_error),
                       result.segments, result.iterations, result.segment_iterations(),
                       result.cutbacks, result.energy_balance_error, result.last_time,
                       cell_of(result.last_value), result.seconds);
  }
}

void write_sweep_curves_csv(std::ostream& out, const SweepRecord& record) {
  if (!record.quantity.is_curve()) {
    throw InputError({}, "--what", "curves", "needs a sweep with error.take = \"curve\"");
  }
  out << fmt::format("case,time [s],value [{}]\n", record.quantity.unit);
  for (std::size_t i = 0; i < record.cases(); ++i) {
    const CaseResult& result = record.results[i];
    for (std::size_t k = 0; k < result.curve.size(); ++k) {
      out << fmt::format("{},{},{}\n", record.ids[i], result.time[k], result.curve[k]);
    }
  }
}

}  // namespace plastica::sweeps
