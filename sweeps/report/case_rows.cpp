#include "sweeps/report/case_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "plastica/report/format.hpp"
#include "sweeps/compare/convergence.hpp"

namespace plastica::sweeps {
namespace {

/// Which columns there are besides the axes.
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

/// Axes whose values tell the cases of a block apart.
std::vector<std::size_t> axes_of_blocks(const SweepRecord& record) {
  if (!record.refined) return varied_axes(record);
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    if (moves_with_refined(record, a)) axes.push_back(a);
  }
  return axes;
}

std::vector<CaseColumn> columns_of(const SweepRecord& record, const std::vector<std::size_t>& axes,
                                   const Shown& shown) {
  std::vector<CaseColumn> columns;
  for (const std::size_t a : axes) {
    const Field& field = *record.axes[a].field;
    columns.push_back({std::string(field.path), shown_unit_of(si_unit(field.dimension)),
                       field.kind == FieldKind::Choice});
  }
  if (columns.empty()) columns.push_back({"case", "", true});
  if (shown.value) columns.push_back({record.quantity.name, shown_unit_of(record.quantity.unit)});
  if (shown.error) columns.push_back({"error", "%"});
  if (shown.order) columns.push_back({"order"});
  if (shown.work) columns.push_back({"work", "segment-it."});
  if (shown.seconds) columns.push_back({"time", "ms"});
  columns.push_back({"", "", true});
  return columns;
}

std::vector<std::string> cells_of(const SweepRecord& record, const std::vector<std::size_t>& axes,
                                  const Shown& shown, std::size_t i,
                                  const std::optional<double>& order) {
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
  if (shown.error) cells.push_back(error ? percent_text(*error) : "-");
  if (shown.order) cells.push_back(order ? fmt::format("{:.3f}", *order) : "");
  if (shown.work) cells.push_back(fmt::format("{}", result.segment_iterations()));
  if (shown.seconds) cells.push_back(fmt::format("{:.4g}", 1e3 * result.seconds));
  cells.push_back(remark_of(record, i));
  return cells;
}

/// What the errors of a block do not have in them.
std::string alone_note(const SweepRecord& record, const RefinementGroup& group) {
  if (!record.refined || group.cases.empty()) return "";
  const std::string& lacks = record.comparison.lacks[group.cases.front()];
  return lacks.empty() ? "" : error_alone(record.axes[*record.refined].field->path, lacks);
}

std::string stop_note(const GroupConvergence& convergence) {
  if (convergence.stops_at.empty()) return "";
  return "no order: these errors stop at that of " + convergence.stops_at;
}

std::string fit_note(const theory::OrderFit& fit, std::size_t errors) {
  if (!fit.order) return "";
  std::string line =
      fmt::format("order {:.3f} by least squares of {} points", *fit.order, fit.points);
  if (fit.correlation) line += fmt::format(", correlation {:.5f}", *fit.correlation);
  if (fit.points < errors) {
    line += fmt::format("; {} at the round-off floor left out", errors - fit.points);
  }
  return line;
}

std::string grid_note(const std::optional<theory::GridConvergence>& grid, const std::string& unit) {
  using theory::ConvergenceKind;
  if (!grid) return "";
  switch (grid->kind) {
    case ConvergenceKind::Unknown: return "";
    case ConvergenceKind::Divergent:
      return "the three finest values do not converge: nothing is extrapolated";
    case ConvergenceKind::Unchanged: return "the two finest values agree to rounding";
    case ConvergenceKind::Oscillatory:
      return "the three finest values go to and fro: nothing is extrapolated";
    case ConvergenceKind::TooFast:
      return "the three finest values converge faster than any method: errors of unlike orders "
             "cancel, and nothing is extrapolated";
    case ConvergenceKind::Monotone: break;
  }
  std::string line = fmt::format("three finest: order {:.3f}", *grid->observed_order);
  if (*grid->order < *grid->observed_order) line += fmt::format(", taken as {:g}", *grid->order);
  line +=
      fmt::format(", extrapolated {:.9g}{}", *grid->extrapolated, unit == "1" ? "" : " " + unit);
  if (grid->fine_index) {
    line += fmt::format(", GCI {} % (safety factor {:g})", percent_text(*grid->fine_index),
                        grid->safety_factor);
  }
  return line;
}

/// Of a fitted value: what the noise of the data and what the segments leave open.
std::string noise_note(const SweepRecord& record, const RefinementGroup& group,
                       const std::optional<theory::GridConvergence>& grid) {
  const CaseResult& finest = record.results[group.cases.back()];
  if (!finest.standard_error || !finest.value) return "";
  const std::string unit = record.quantity.unit == "1" ? "" : " " + record.quantity.unit;
  std::string line = fmt::format("finest: {:.6g}{}, ± {:.2g} from noise (standard error)",
                                 *finest.value, unit, *finest.standard_error);
  if (grid && grid->uncertainty) {
    line += fmt::format(", ± {:.2g} from the discretization (GCI)", *grid->uncertainty);
  }
  return line;
}

/// @param left  how many rows may be added; is counted down
CaseBlock block_of(const SweepRecord& record, const RefinementGroup& group,
                   const std::vector<std::size_t>& axes, const Shown& shown, std::size_t& left) {
  const GroupConvergence convergence = convergence_of(group, record.results, record.comparison);
  std::map<std::size_t, double> order_at;
  for (std::size_t k = 0; k + 1 < convergence.cases.size(); ++k) {
    if (convergence.pairwise[k]) order_at[convergence.cases[k + 1]] = *convergence.pairwise[k];
  }
  CaseBlock block{group.label, {}, {}};
  for (const std::size_t i : group.cases) {
    if (left == 0) break;
    --left;
    const auto order = order_at.find(i);
    block.rows.push_back(
        cells_of(record, axes, shown, i,
                 order == order_at.end() ? std::nullopt : std::optional(order->second)));
  }
  for (std::string note : {alone_note(record, group), stop_note(convergence),
                           fit_note(convergence.fit, convergence.cases.size()),
                           grid_note(convergence.grid, record.quantity.unit),
                           noise_note(record, group, convergence.grid)}) {
    if (!note.empty()) block.notes.push_back(std::move(note));
  }
  return block;
}

/// "; the same run as case 3" of a case that comes to what an earlier one does.
std::string same_run_text(const SweepRecord& record, std::size_t index) {
  // Of many cases a table shows the first ones.
  constexpr std::size_t kMaxSearched = 10'000;
  const auto end = record.ids.begin() + static_cast<std::ptrdiff_t>(std::min(index, kMaxSearched));
  const auto first = std::find(record.ids.begin(), end, record.ids[index]);
  if (first == end) return {};
  const auto number = static_cast<std::size_t>(first - record.ids.begin());
  std::string text = fmt::format("; the same run as case {}", number + 1);
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    if (record.at(index, a) == record.at(number, a)) continue;
    const std::string_view path = record.axes[a].field->path;
    if (path == "solver.time_step") text += " (steps are cut to the samples)";
    if (path == "solver.fibres") text += " (the section is laid out alike)";
  }
  return text;
}

}  // namespace

CaseRows case_rows(const SweepRecord& record, std::size_t max_cases) {
  const Shown shown = shown_of(record);
  const auto axes = axes_of_blocks(record);
  CaseRows all;
  all.columns = columns_of(record, axes, shown);
  const std::size_t wanted = max_cases == 0 ? record.cases() : max_cases;
  std::size_t left = wanted;
  if (record.refined) {
    for (const RefinementGroup& group : record.groups) {
      if (left == 0) break;
      all.blocks.push_back(block_of(record, group, axes, shown, left));
    }
  } else {
    RefinementGroup whole;
    for (std::size_t i = 0; i < record.cases(); ++i) whole.cases.push_back(i);
    all.blocks.push_back(block_of(record, whole, axes, shown, left));
  }
  if (record.cases() > wanted) all.left_out = record.cases() - wanted;
  return all;
}

std::vector<std::string> what_was_swept(const SweepRecord& record) {
  std::map<std::string, std::size_t> counts;
  for (const CaseResult& result : record.results) ++counts[std::string(name_of(result.status))];
  std::string first = fmt::format("{}: {}", report::printable(record.name),
                                  report::counted(record.cases(), "case"));
  for (const auto& [status, count] : counts) first += fmt::format(", {} {}", count, status);
  std::string compared = record.quantity.name;
  if (!record.against.empty()) compared += " against " + record.against;
  return {first, "scene     " + report::printable(record.scene_name),
          "compared  " + report::printable(compared)};
}

std::vector<std::string> head_lines(const SweepRecord& record) {
  std::vector<std::string> lines = what_was_swept(record);
  for (const std::string& note : record.comparison.notes) {
    lines.push_back("error     " + report::printable(note));
  }
  for (const std::string& warning : record.warnings) {
    lines.push_back("warning   " + report::printable(warning));
  }
  return lines;
}

std::string remark_of(const SweepRecord& record, std::size_t index) {
  const CaseResult& result = record.results[index];
  const std::string same = same_run_text(record, index);
  if (!usable(result.status)) {
    std::string text(name_of(result.status));
    // An unstable path goes on to its end.
    const bool ends_there = result.status != Status::Unstable && result.last_time > 0.0;
    if (ends_there) text += fmt::format(" at {:.4g} s", result.last_time);
    if (!result.reason.empty()) text += ": " + result.reason;
    return text + same;
  }
  std::string text = result.status == Status::Completed ? "" : std::string(name_of(result.status));
  const std::string& why = result.reason.empty() ? record.comparison.reason[index] : result.reason;
  if (!why.empty()) text += (text.empty() ? "" : ": ") + why;
  if (result.energy_balance_error > kBalanceTolerance) {
    text += fmt::format("{}energy balance off by {} %", text.empty() ? "" : ", ",
                        percent_text(result.energy_balance_error));
  }
  return text.empty() && !same.empty() ? same.substr(2) : text + same;
}

std::string level_word(Level level) {
  return std::string(find_field("solver.level").choices[static_cast<std::size_t>(level)]);
}

std::string percent_text(double fraction) { return fmt::format("{:.4g}", 100.0 * fraction); }

std::string shown_unit_of(std::string_view unit) {
  return unit == "1" ? std::string() : std::string(unit);
}

std::vector<std::size_t> varied_axes(const SweepRecord& record) {
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < record.axes.size(); ++a) {
    if (record.axes[a].values.size() > 1) axes.push_back(a);
  }
  return axes;
}

bool moves_with_refined(const SweepRecord& record, std::size_t axis) {
  if (!record.refined) return false;
  const std::string& group = record.axes[*record.refined].group;
  return axis == *record.refined || (!group.empty() && record.axes[axis].group == group);
}

}  // namespace plastica::sweeps
