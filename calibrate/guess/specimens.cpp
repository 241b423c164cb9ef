#include "calibrate/guess/specimens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

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

std::vector<std::size_t> find_split(const io::CsvTable& table, std::span<const double> deformation,
                                    const std::vector<std::size_t>& taken) {
  std::vector<std::size_t> restarts = restarts_of(deformation);
  // A new specimen may begin with rows that are not yet below a tenth, or have no number.
  const auto is_restart = [&](std::size_t row) {
    constexpr std::size_t kNear = 3;
    return std::ranges::any_of(restarts, [&](std::size_t restart) {
      return restart + kNear >= row && restart <= row + kNear;
    });
  };
  struct Candidate {
    std::size_t column;
    std::vector<std::size_t> changes;
    bool is_named;
  };
  std::vector<Candidate> candidates;
  std::set<std::size_t> boundaries;
  for (std::size_t k = 0; k < table.columns(); ++k) {
    if (std::ranges::find(taken, k) != taken.end()) continue;
    std::vector<std::size_t> changes = changes_of(table, k);
    if (changes.empty() || 5 * changes.size() > table.rows()) continue;
    if (!std::ranges::all_of(changes, is_restart)) continue;
    boundaries.insert(changes.begin(), changes.end());
    candidates.push_back({k, std::move(changes), names_specimens(table.names()[k])});
  }
  if (boundaries.empty()) return {};
  std::vector<std::size_t> begins(boundaries.begin(), boundaries.end());
  begins.insert(begins.begin(), 0);
  const auto tells_apart = [&](const std::vector<std::size_t>& columns) {
    std::set<std::vector<std::string_view>> keys;
    for (const std::size_t begin : begins) {
      std::vector<std::string_view> key;
      key.reserve(columns.size());
      for (const std::size_t column : columns) key.push_back(table.cell(begin, column));
      keys.insert(std::move(key));
    }
    return keys.size() == begins.size();
  };
  for (const bool named : {true, false}) {
    std::vector<std::size_t> columns;
    for (const Candidate& one : candidates) {
      if (one.is_named == named && tells_apart({one.column})) return {one.column};
    }
    for (const Candidate& more : candidates) {
      if (named && !more.is_named) continue;
      columns.push_back(more.column);
      if (tells_apart(columns)) return columns;
    }
  }
  return {};
}

}  // namespace plastica::calibrate
