#include "sweeps/report/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plastica/report/format.hpp"
#include "plastica/report/table.hpp"
#include "sweeps/compare/convergence.hpp"

namespace plastica::sweeps {
namespace {

using report::Table;

std::string percent(double share) { return fmt::format("{:.4g}", 100.0 * share); }

std::string count_text(std::int64_t count) { return fmt::format("{}", count); }

/// What a table of cases shows.
struct Shown {
  bool value = false;
  bool error = false;
  bool order = false;
  bool work = false;
  bool seconds = false;
};

Shown shown_of(const SweepRecord& record) {
  Shown shown;
  for (const CaseResult& result : record.results) {
    shown.value = shown.value || result.value.has_value();
    shown.work = shown.work || result.segment_iterations() > 0;
  }
  shown.error = record.has_errors();
  shown.order = shown.error && record.refined.has_value();
  shown.seconds = record.timed_runs > 0;
  return shown;
}

Table empty_table(const SweepRecord& record, const std::vector<std::size_t>& axes,
                  const Shown& shown) {
  std::vector<Table::Column> columns;
  for (const std::size_t a : axes) {
    const Field& field = *record.axes[a].field;
    const bool words = field.kind == FieldKind::Choice;
    const std::string_view unit = si_unit(field.dimension);
    columns.push_back({std::string(field.path), words ? Table::Align::Left : Table::Align::Right,
                       unit == "1" ? "" : std::string(unit)});
  }
  if (columns.empty()) columns.push_back({"case", Table::Align::Left});
  if (shown.value) {
    columns.push_back({record.quantity.name, Table::Align::Right,
                       record.quantity.unit == "1" ? "" : record.quantity.unit});
  }
  if (shown.error) columns.push_back({"error", Table::Align::Right, "%"});
  if (shown.order) columns.push_back({"order"});
  if (shown.work) columns.push_back({"work", Table::Align::Right, "segment-it."});
  if (shown.seconds) columns.push_back({"time", Table::Align::Right, "ms"});
  columns.push_back({"", Table::Align::Left});
  return Table(std::move(columns));
}

/// What stands behind a case that is not as it should be.
std::string remark(const SweepRecord& record, std::size_t i) {
  const CaseResult& result = record.results[i];
  if (!usable(result.status)) {
    std::string text(name_of(result.status));
    if (result.last_time > 0.0) text += fmt::format(" at {:.4g} s", result.last_time);
    if (!result.reason.empty()) text += ": " + result.reason;
    return text;
  }
  std::string text = result.status == Status::Completed ? "" : std::string(name_of(result.status));
  const std::string& why = result.reason.empty() ? record.comparison.reason[i] : result.reason;
  if (!why.empty()) text += (text.empty() ? "" : ": ") + why;
  if (result.ledger_error > kLedgerTolerance) {
    text += fmt::format("{}ledger open by {} %", text.empty() ? "" : ", ",
                        percent(result.ledger_error));
  }
  return text;
}

void add_case(const SweepRecord& record, const std::vector<std::size_t>& axes, const Shown& shown,
              std::size_t i, const std::optional<double>& order, Table& table) {
  std::vector<std::string> cells;
  for (const std::size_t a : axes) {
    const FieldValue& value = record.at(i, a);
    const auto* number = std::get_if<double>(&value);
    cells.push_back(number != nullptr ? fmt::format("{:.6g}", *number)
                                      : value_text(*record.axes[a].field, value));
  }
  if (cells.empty()) cells.push_back(record.ids[i]);
  const CaseResult& result = record.results[i];
  if (shown.value) cells.push_back(result.value ? fmt::format("{:.8g}", *result.value) : "-");
  const auto& error = record.comparison.error[i];
  if (shown.error) cells.push_back(error ? percent(*error) : "-");
  if (shown.order) cells.push_back(order ? fmt::format("{:.3f}", *order) : "");
  if (shown.work) cells.push_back(count_text(result.segment_iterations()));
  if (shown.seconds) cells.push_back(fmt::format("{:.4g}", 1e3 * result.seconds));
  cells.push_back(remark(record, i));
  table.add(std::move(cells));
}

std::string fit_line(const theory::OrderFit& fit, std::size_t errors) {
  if (!fit.order) return "";
  std::string line =
      fmt::format("  order {:.3f} by least squares of {} points", *fit.order, fit.points);
  if (fit.correlation) line += fmt::format(", correlation {:.5f}", *fit.correlation);
  if (fit.points < errors) {
    line += fmt::format("; {} at the round-off floor left out", errors - fit.points);
  }
  return line + "\n";
}

std::string grid_line(const std::optional<theory::GridConvergence>& grid, const std::string& unit) {
  using theory::ConvergenceKind;
  if (!grid) return "";
  switch (grid->kind) {
    case ConvergenceKind::Unknown: return "";
    case ConvergenceKind::Divergent:
      return "  the three finest values do not converge: nothing is extrapolated\n";
    case ConvergenceKind::Unchanged: return "  the two finest values agree to rounding\n";
    case ConvergenceKind::Monotone:
    case ConvergenceKind::Oscillatory: break;
  }
  std::string line =
      fmt::format("  three finest: order {:.3f}, extrapolated {:.9g}{}", *grid->observed_order,
                  *grid->extrapolated, unit == "1" ? "" : " " + unit);
  if (grid->fine_index) {
    line += fmt::format(", GCI {} % (safety factor {:g})", percent(*grid->fine_index),
                        grid->safety_factor);
  }
  if (grid->kind == ConvergenceKind::Oscillatory) line += ", oscillating";
  return line + "\n";
}

/// Axes whose values tell the cases of a group apart: those that move with the refined one.
std::vector<std::size_t> axes_of_groups(const SweepRecord& record) {
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    const bool same = record.refined && !record.axes[a].group.empty() &&
                      record.axes[a].group == record.axes[*record.refined].group;
    const bool varies = record.axes[a].values.size() > 1;
    if (record.refined ? a == *record.refined || same : varies) axes.push_back(a);
  }
  return axes;
}

std::string group_text(const SweepRecord& record, const RefinementGroup& group,
                       const std::vector<std::size_t>& axes, const Shown& shown,
                       std::size_t& left) {
  const GroupConvergence convergence = convergence_of(group, record.results, record.comparison);
  std::map<std::size_t, double> order_at;
  for (std::size_t k = 0; k + 1 < convergence.cases.size(); ++k) {
    if (convergence.pairwise[k]) order_at[convergence.cases[k + 1]] = *convergence.pairwise[k];
  }
  Table table = empty_table(record, axes, shown);
  for (const std::size_t i : group.cases) {
    if (left == 0) break;
    --left;
    const auto order = order_at.find(i);
    add_case(record, axes, shown, i,
             order == order_at.end() ? std::nullopt : std::optional(order->second), table);
  }
  std::string text = "\n";
  if (!group.label.empty()) text += group.label + "\n";
  return text + table.text(2, 140) + fit_line(convergence.fit, convergence.cases.size()) +
         grid_line(convergence.grid, record.quantity.unit);
}

std::string head(const SweepRecord& record) {
  std::map<std::string, std::size_t> counts;
  for (const CaseResult& result : record.results) ++counts[std::string(name_of(result.status))];
  std::string text = fmt::format("{}: {}", record.name, report::counted(record.cases(), "case"));
  for (const auto& [status, count] : counts) text += fmt::format(", {} {}", count, status);
  text += fmt::format("\n  scene     {}\n  compared  {}", record.scene_name, record.quantity.name);
  if (!record.against.empty()) text += " against " + record.against;
  return text + "\n";
}

}  // namespace

std::string sweep_report(const SweepRecord& record, std::size_t most_cases) {
  const Shown shown = shown_of(record);
  const auto axes = axes_of_groups(record);
  std::string text = head(record);
  std::size_t left = most_cases == 0 ? record.cases() : most_cases;
  if (record.refined) {
    for (const RefinementGroup& group : record.groups) {
      if (left == 0) break;
      text += group_text(record, group, axes, shown, left);
    }
  } else {
    RefinementGroup all;
    for (std::size_t i = 0; i < record.cases(); ++i) all.cases.push_back(i);
    text += group_text(record, all, axes, shown, left);
  }
  if (most_cases > 0 && record.cases() > most_cases) {
    text += fmt::format("\n{} more cases; export has them all\n", record.cases() - most_cases);
  }
  return text;
}

}  // namespace plastica::sweeps
