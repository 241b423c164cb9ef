#include "calibrate/guess/specimens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "calibrate/guess/column_role.hpp"

namespace plastica::calibrate {
namespace {

/// First rows of the runs of equal values of a column, without row 0.
std::vector<std::size_t> changes_of(const io::CsvTable& table, std::size_t column) {
  std::vector<std::size_t> changes;
  for (std::size_t row = 1; row < table.rows(); ++row) {
    if (table.cell(row, column) != table.cell(row - 1, column)) changes.push_back(row);
  }
  return changes;
}

/// Whether a column names something: words that come before others.
bool names_specimens(const std::string& name) {
  constexpr std::array<std::string_view, 11> kWords{
      "specimen", "sample",      "probe",      "test",   "repeat",  "number",
      "nummer",   "échantillon", "éprouvette", "coupon", "prüfling"};
  const std::string lower = lower_name(name);
  if (lower == "id" || lower.ends_with("_id") || lower.ends_with(" id") || name.ends_with("ID")) {
    return true;
  }
  return std::ranges::any_of(kWords,
                             [&](auto word) { return lower.find(word) != std::string::npos; });
}

/// Whether the values of a column may tell specimens apart: none is empty, and they are no stages
/// of one test and no time.
bool may_split(const io::CsvTable& table, std::size_t column) {
  constexpr std::array<std::string_view, 14> kStages{
      "cycle", "zyklus", "zyklen", "ciclo", "step", "schritt", "segment",
      "stage", "stufe",  "block",  "phase", "loop", "ramp",    "rampe"};
  const std::string name = lower_name(table.names()[column]);
  const bool is_stage =
      std::ranges::any_of(kStages, [&](auto word) { return name.find(word) != std::string::npos; });
  if (is_stage) return false;
  if (meaning_of(name, table.units()[column]).role == ColumnRole::Time) return false;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.cell(row, column).empty()) return false;
  }
  return true;
}

}  // namespace

std::vector<std::size_t> restarts_of(std::span<const double> deformation) {
  std::vector<std::size_t> restarts;
  double span = 0.0;  // largest excursion of all
  for (const double value : deformation) {
    if (std::isfinite(value)) span = std::max(span, std::abs(value));
  }
  double reached = 0.0;
  for (std::size_t row = 0; row < deformation.size(); ++row) {
    const double size = std::abs(deformation[row]);
    if (!std::isfinite(size)) continue;
    if (reached > 0.1 * span && size < 0.1 * reached) {
      restarts.push_back(row);
      reached = size;
    }
    reached = std::max(reached, size);
  }
  return restarts;
}

bool FoundSplit::tells_all() const { return untold == 0; }

FoundSplit find_split(const io::CsvTable& table, std::span<const double> deformation,
                      const std::vector<std::size_t>& taken) {
  const std::vector<std::size_t> restarts = restarts_of(deformation);
  // A new specimen may begin with rows that are not yet below a tenth, or have no number.
  const auto is_near = [](const std::vector<std::size_t>& rows, std::size_t row) {
    constexpr std::size_t kNear = 3;
    return std::ranges::any_of(
        rows, [&](std::size_t other) { return other + kNear >= row && other <= row + kNear; });
  };
  struct Candidate {
    std::size_t column;
    std::vector<std::size_t> changes;
    bool is_named;
  };
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < table.columns(); ++k) {
    if (std::ranges::find(taken, k) != taken.end() || !may_split(table, k)) continue;
    std::vector<std::size_t> changes = changes_of(table, k);
    if (changes.empty() || 5 * changes.size() > table.rows()) continue;
    const bool all = std::ranges::all_of(changes, [&](auto row) { return is_near(restarts, row); });
    if (all) candidates.push_back({k, std::move(changes), names_specimens(table.names()[k])});
  }
  // Whether each part of the rows has its own values, and how many restarts are within parts.
  const auto tried = [&](const std::vector<const Candidate*>& parts) -> std::optional<FoundSplit> {
    std::set<std::size_t> begins{0};
    for (const Candidate* one : parts) begins.insert(one->changes.begin(), one->changes.end());
    std::set<std::vector<std::string>> keys;
    FoundSplit found;
    for (const Candidate* one : parts) found.columns.push_back(one->column);
    for (const std::size_t begin : begins) {
      std::vector<std::string> key;
      for (const std::size_t column : found.columns) key.push_back(table.cell(begin, column));
      keys.insert(std::move(key));
    }
    if (keys.size() != begins.size()) return std::nullopt;
    found.parts = keys.size();
    const std::vector<std::size_t> rows(begins.begin(), begins.end());
    for (const std::size_t restart : restarts) found.untold += is_near(rows, restart) ? 0 : 1;
    return found;
  };
  std::optional<FoundSplit> best;
  const auto keep = [&](std::optional<FoundSplit> found) {
    if (found && (!best || found->untold < best->untold)) best = std::move(found);
  };
  for (const bool named : {true, false}) {
    for (const Candidate& one : candidates) {
      if (one.is_named == named) keep(tried({&one}));
    }
    std::vector<const Candidate*> several;
    for (const Candidate& more : candidates) {
      if (named && !more.is_named) continue;
      several.push_back(&more);
      if (several.size() > 1) keep(tried(several));
    }
    // What does not name specimens, such as a temperature, may be the same for several of them.
    if (best && (named || best->tells_all())) return *best;
  }
  return {};
}

}  // namespace plastica::calibrate
