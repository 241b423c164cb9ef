#include "plastica/io/csv_header.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

#include "plastica/io/csv_number.hpp"
#include "plastica/io/csv_text.hpp"
#include "plastica/io/units.hpp"

namespace plastica::io {
namespace {

using csv_text::CellKind;

/// "50 mm" as number and unit; a number alone has an empty unit.
std::optional<HeaderEntry> quantity_of(std::string_view text, csv_text::NumberFormat format) {
  text = csv_text::without_blanks(text);
  const std::size_t end = std::min(text.find_first_not_of("+-0123456789.,eE"), text.size());
  const std::string_view rest = csv_text::without_blanks(text.substr(end));
  const csv_text::Number number =
      csv_text::read_number(csv_text::without_blanks(text.substr(0, end)), format);
  if (number.kind != CellKind::Number) return std::nullopt;
  const csv_text::UnitCell unit = csv_text::unit_cell(rest);
  if (!rest.empty() && !unit.is_unit) return std::nullopt;
  return HeaderEntry{{}, number.value, unit.unit};
}

/// Of a line whose cells are a name, a number and perhaps a unit.
std::optional<HeaderEntry> entry_of_cells(const std::vector<std::string_view>& cells,
                                          csv_text::NumberFormat format) {
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (cells[i].empty()) continue;
    auto entry = quantity_of(cells[i], format);
    if (!entry) return std::nullopt;
    const auto [name, unit] = csv_text::name_and_unit(cells[0]);
    entry->name = name;
    if (entry->unit.empty() && i + 1 < cells.size() && !cells[i + 1].empty()) {
      const csv_text::UnitCell behind = csv_text::unit_cell(cells[i + 1]);
      if (behind.is_unit) entry->unit = behind.unit;
    }
    if (entry->unit.empty()) entry->unit = unit;
    return entry;
  }
  return std::nullopt;
}

/// Of "Gauge length: 50 mm".
std::optional<HeaderEntry> entry_of_words(std::string_view line, csv_text::NumberFormat format) {
  const std::size_t at = line.find_last_of(":=");
  if (at == std::string_view::npos || at == 0) return std::nullopt;
  auto entry = quantity_of(line.substr(at + 1), format);
  if (!entry) return std::nullopt;
  const auto [name, unit] = csv_text::name_and_unit(line.substr(0, at));
  entry->name = name;
  if (entry->unit.empty()) entry->unit = unit;
  return entry;
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
    const bool is_row = table.separator() != ' ' && csv_text::split(line, table.separator(), cells);
    auto entry = is_row ? entry_of_cells(cells, format) : std::nullopt;
    if (!entry) entry = entry_of_words(line, format);
    if (entry) entries.push_back(std::move(*entry));
  }
  return entries;
}

}  // namespace plastica::io
