#include "sweeps/report/text.hpp"

#include <fmt/format.h>

#include <utility>

#include "plastica/report/format.hpp"
#include "plastica/report/table.hpp"
#include "sweeps/report/case_rows.hpp"
#include "sweeps/report/spread.hpp"

namespace plastica::sweeps {
namespace {

using report::Table;

constexpr std::size_t kWidth = 140;

std::string head(const SweepRecord& record) {
  const auto lines = head_lines(record);
  std::string text = lines.front() + "\n";
  for (std::size_t i = 1; i < lines.size(); ++i) text += "  " + lines[i] + "\n";
  return text;
}

std::string block_text(const std::vector<CaseColumn>& names, const CaseBlock& block) {
  std::vector<Table::Column> columns;
  columns.reserve(names.size());
  for (const CaseColumn& column : names) {
    columns.push_back(
        {column.name, column.words ? Table::Align::Left : Table::Align::Right, column.unit});
  }
  Table table(std::move(columns));
  for (const auto& row : block.rows) table.add(row);
  std::string text = "\n";
  if (!block.label.empty()) text += report::printable(block.label) + "\n";
  text += table.text(2, kWidth);
  for (const std::string& note : block.notes) text += "  " + note + "\n";
  return text;
}

}  // namespace

std::string sweep_report(const SweepRecord& record, std::size_t max_cases) {
  std::string text = head(record);
  const bool many = max_cases > 0 && record.cases() > max_cases;
  if (many && !record.refined) return text + "\n" + spread_report(record);
  const CaseRows all = case_rows(record, max_cases);
  for (const CaseBlock& block : all.blocks) text += block_text(all.columns, block);
  if (many) {
    text += fmt::format("\n{} more cases; export has them all. Of all cases:\n\n", all.left_out) +
            spread_report(record);
  }
  return text;
}

std::string case_report(const SweepRecord& record, std::size_t index) {
  const CaseResult& result = record.results[index];
  Table table({{"", Table::Align::Left}, {"", Table::Align::Left}});
  const auto add = [&](std::string name, const std::string& value, const std::string& unit = {}) {
    table.add({std::move(name), report::quantity(value, shown_unit_of(unit))});
  };
  const auto add_number = [&](std::string name, const std::optional<double>& value,
                              const std::string& unit) {
    if (value) add(std::move(name), fmt::format("{:.12g}", *value), unit);
  };
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    add(std::string(record.axes[a].field->path),
        value_text(*record.axes[a].field, record.at(index, a)));
  }
  add("status", std::string(name_of(result.status)));
  if (!result.reason.empty()) add("reason", report::printable(result.reason));
  add("level", level_word(result.level));
  const std::string& unit = record.quantity.unit;
  add_number(record.quantity.name, result.value, unit);
  if (!result.curve.empty()) {
    add(record.quantity.name, report::counted(result.curve.size(), "sample"));
  }
  add_number("standard error", result.standard_error, unit);
  add_number("reference", record.comparison.reference[index], unit);
  const auto& error = record.comparison.error[index];
  if (error) add("error", fmt::format("{:.6g} %", 100.0 * *error));
  if (!record.comparison.reason[index].empty()) {
    add("no error", report::printable(record.comparison.reason[index]));
  }
  const std::string& lacks = record.comparison.lacks[index];
  if (!lacks.empty()) add("not in it", "the error of " + report::printable(lacks));
  if (const auto& off = record.comparison.reference_error[index]) {
    add("reference off by about", fmt::format("{:.2g} %", 100.0 * *off));
  }
  if (result.break_joint >= 0) add("breaks at joint", fmt::format("{}", result.break_joint));
  add("segments", fmt::format("{}", result.segments));
  add("iterations", fmt::format("{}", result.iterations));
  add("cut-backs", fmt::format("{}", result.cutbacks));
  add("segment-iterations", fmt::format("{}", result.segment_iterations()));
  add("energy balance error", percent_text(result.energy_balance_error) + " %");
  add(result.status == Status::Unstable ? "end of the path" : "last good state",
      fmt::format("{:.6g} s", result.last_time));
  add_number("probe there", result.last_value, unit);
  add("time", fmt::format("{:.4g} ms", 1e3 * result.seconds));
  return fmt::format("case {} of {}\n", record.ids[index], report::printable(record.name)) +
         table.text(2, kWidth);
}

}  // namespace plastica::sweeps
