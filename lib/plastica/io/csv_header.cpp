#include "plastica/io/csv_header.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

#include "plastica/io/csv_number.hpp"
#include "plastica/io/csv_text.hpp"
#include "plastica/io/units.hpp"

namespace plastica::io {
namespace {

using csv_text::CellKind;

/// "50 mm" as number and unit; a number alone has an empty unit. None of one that may be another
/// number: "1,200" between commas.
std::optional<HeaderEntry> quantity_of(std::string_view text, csv_text::NumberFormat format) {
  text = csv_text::without_blanks(text);
  const std::size_t end = std::min(text.find_first_not_of("+-0123456789.,eE"), text.size());
  const std::string_view rest = csv_text::without_blanks(text.substr(end));
  const std::string_view digits = csv_text::without_blanks(text.substr(0, end));
  const csv_text::Number number = csv_text::read_number(digits, format);
  if (number.kind != CellKind::Number) return std::nullopt;
  const bool is_plain = digits.find(format.decimal == '.' ? ',' : '.') == std::string_view::npos;
  if (!is_plain && csv_text::is_ambiguous(digits)) return std::nullopt;
  const csv_text::UnitCell unit = csv_text::unit_cell(rest);
  if (!rest.empty() && !unit.is_unit) return std::nullopt;
  return HeaderEntry{{}, number.value, unit.unit};
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether a text has a number behind a colon or a sign of equality: "Gauge length: 50".
bool holds_value(std::string_view text) {
  for (std::size_t at = text.find_first_of(":="); at != std::string_view::npos;
       at = text.find_first_of(":=", at + 1)) {
    const std::string_view rest = csv_text::without_blanks(text.substr(at + 1));
    if (!rest.empty() && is_digit(rest[0])) return true;
  }
  return false;
}

/// Of a line whose cells are a name, one number and perhaps a unit. Of several numbers none is the
/// one of all specimens.
std::optional<HeaderEntry> entry_of_cells(const std::vector<std::string_view>& cells,
                                          csv_text::NumberFormat format) {
  std::optional<HeaderEntry> entry;
  std::string_view behind;  // the cell after the number
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (cells[i].empty()) continue;
    auto quantity = quantity_of(cells[i], format);
    if (entry) {
      if (quantity) return std::nullopt;
      if (behind.empty()) behind = cells[i];
      continue;
    }
    if (!quantity) return std::nullopt;
    entry = std::move(quantity);
  }
  if (!entry) return std::nullopt;
  const auto [name, unit] = csv_text::name_and_unit(cells[0]);
  entry->name = name;
  if (entry->unit.empty() && !behind.empty()) {
    const csv_text::UnitCell of_it = csv_text::unit_cell(behind);
    if (of_it.is_unit) entry->unit = of_it.unit;
  }
  if (entry->unit.empty()) entry->unit = unit;
  return entry;
}

/// Of "Gauge length: 50 mm".
std::optional<HeaderEntry> entry_of_words(std::string_view words, csv_text::NumberFormat format) {
  const std::size_t at = words.find_last_of(":=");
  if (at == std::string_view::npos || at == 0 || holds_value(words.substr(0, at + 1))) {
    return std::nullopt;
  }
  auto entry = quantity_of(words.substr(at + 1), format);
  if (!entry) return std::nullopt;
  const auto [name, unit] = csv_text::name_and_unit(words.substr(0, at));
  entry->name = name;
  if (entry->unit.empty()) entry->unit = unit;
  return entry;
}

/// "Width: 12.5 mm, Thickness: 6.4 mm" in pieces: a comma parts them before a blank only.
std::vector<std::string_view> pieces_of(std::string_view line) {
  std::vector<std::string_view> pieces;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const bool parts = i == line.size() || line[i] == ';' || line[i] == '\t' ||
                       (line[i] == ',' && i + 1 < line.size() && line[i + 1] == ' ');
    if (!parts) continue;
    pieces.push_back(csv_text::without_blanks(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  return pieces;
}

}  // namespace

std::vector<HeaderEntry> header_entries(const CsvTable& table) {
  std::vector<HeaderEntry> entries;
  std::vector<std::string_view> cells;
  const csv_text::NumberFormat format{table.decimal(), false};
  for (const std::string& text : table.preamble()) {
    std::string_view line = csv_text::without_blanks(text);
    const std::size_t begin = std::min(line.find_first_not_of("#%/"), line.size());
    line = csv_text::without_blanks(line.substr(begin));
    const bool is_row = table.separator() != ' ' && !holds_value(line) &&
                        csv_text::split(line, table.separator(), cells);
    if (is_row) {
      if (auto entry = entry_of_cells(cells, format)) {
        entries.push_back(std::move(*entry));
        continue;
      }
    }
    for (const std::string_view piece : pieces_of(line)) {
      if (auto entry = entry_of_words(piece, format)) entries.push_back(std::move(*entry));
    }
  }
  return entries;
}

}  // namespace plastica::io
