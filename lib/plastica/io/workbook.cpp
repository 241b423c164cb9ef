#include "plastica/io/workbook.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/csv_text.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/workbook_parts.hpp"

namespace plastica::io {
namespace {

bool is_number_as_text(const std::string& text) {
  const bool has_digit = text.find_first_of("0123456789") != std::string::npos;
  return has_digit && text.find_first_not_of("0123456789,.+-eE ") == std::string::npos;
}

/// Rows with so many numbers or more, those that are text among them.
std::size_t rows_of_numbers(const std::vector<Row>& rows, std::ptrdiff_t numbers) {
  const auto is_number = [](const Cell& cell) {
    return cell.is_number || is_number_as_text(cell.text);
  };
  return static_cast<std::size_t>(std::ranges::count_if(rows, [&](const Row& row) {
    return std::ranges::count_if(row.cells, is_number) >= numbers;
  }));
}

/// What a number that is text shows of its marks.
enum class Mark { None, Point, Comma, Either };
Mark mark_of(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return Mark::None;
  const std::size_t point = text.find('.');
  if (point != std::string::npos) return point > comma ? Mark::Point : Mark::Comma;
  if (text.find(',', comma + 1) != std::string::npos) return Mark::Point;  // 1,234,567
  std::size_t begin = text.find_first_of("0123456789");
  const std::size_t end = text.find_first_not_of("0123456789", comma + 1);
  const bool may_be_thousands = (end == std::string::npos ? text.size() : end) - comma == 4 &&
                                comma - begin >= 1 && comma - begin <= 3 && text[begin] != '0';
  return may_be_thousands ? Mark::Either : Mark::Comma;
}

/// The decimal mark of all numbers that are text.
char decimal_of(const std::string& path, const std::vector<Row>& rows,
                std::optional<char> decimal) {
  const Cell* by_comma = nullptr;
  const Cell* by_point = nullptr;
  const Cell* by_either = nullptr;
  for (const Row& row : rows) {
    for (const Cell& cell : row.cells) {
      if (cell.is_number || !is_number_as_text(cell.text)) continue;
      const Mark mark = mark_of(cell.text);
      if (mark == Mark::Comma) by_comma = &cell;
      if (mark == Mark::Point) by_point = &cell;
      if (mark == Mark::Either) by_either = &cell;
    }
  }
  if (decimal) return *decimal;
  const auto ask = [&](const std::string& cells) {
    throw InputError({path, 0}, "decimal", "",
                     "must be given: " + cells + " stand in cells that are text");
  };
  if (by_comma != nullptr && by_point != nullptr) ask(by_comma->text + " and " + by_point->text);
  if (by_comma == nullptr && by_point == nullptr && by_either != nullptr) {
    ask("numbers such as " + by_either->text);
  }
  return by_comma != nullptr ? ',' : '.';
}

/// Columns in which a text has a "%": what is a percentage there counts as it is shown.
std::vector<bool> percent_columns(const std::vector<Row>& rows) {
  std::vector<bool> columns;
  for (const Row& row : rows) {
    for (const Cell& cell : row.cells) {
      if (cell.is_number || cell.text.find('%') == std::string::npos) continue;
      if (columns.size() <= cell.column) columns.resize(cell.column + 1, false);
      columns[cell.column] = true;
    }
  }
  return columns;
}

std::string number_text(const std::string& path, const Cell& cell, bool times_100, char decimal) {
  std::string text = cell.text;
  if (times_100) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      refuse_workbook(path, "is damaged: a number is " + text);
    }
    std::array<char, 32> digits{};
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), 100.0 * value);
    text.assign(digits.data(), written.ptr);
  }
  std::ranges::replace(text, '.', decimal);
  return text;
}

SheetText text_of(const std::string& path, std::string name, const std::vector<Row>& rows,
                  std::optional<char> decimal) {
  // A sheet of few cells far apart would take seconds and gigabytes as a table.
  constexpr std::size_t kMaxCells = std::size_t{1} << 28U, kMaxEmpty = std::size_t{1} << 24U;
  SheetText sheet{std::move(name), {}, decimal_of(path, rows, decimal)};
  std::size_t width = 0, filled = 0;
  for (const Row& row : rows) {
    filled += row.cells.size();
    if (!row.cells.empty()) width = std::max(width, row.cells.back().column + 1);
  }
  const std::size_t cells = width * rows.size();
  if (cells > kMaxCells || cells > kMaxEmpty + 16 * filled) {
    refuse_workbook(path, "has a sheet with " + std::to_string(width) + " columns and " +
                              std::to_string(rows.size()) + " rows, more than are read");
  }
  const std::vector<bool> percent = percent_columns(rows);
  std::size_t line = 1;
  for (const Row& row : rows) {
    if (row.cells.empty()) continue;
    for (; line < row.number; ++line) sheet.text += '\n';
    std::size_t column = 0;
    for (const Cell& cell : row.cells) {
      for (; column < cell.column; ++column) sheet.text += '\t';
      const bool times_100 =
          cell.is_percentage && cell.column < percent.size() && percent[cell.column];
      sheet.text += cell.is_number ? number_text(path, cell, times_100, sheet.decimal)
                                   : csv_text::tabbed_cell(cell.text);
    }
    for (; column + 1 < width; ++column) sheet.text += '\t';
  }
  if (!sheet.text.empty()) sheet.text += '\n';
  return sheet;
}

}  // namespace

bool is_workbook(const std::string& path) {
  if (!is_file(path)) return false;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> begin{};
  return file.read(begin.data(), begin.size()) &&
         std::string_view(begin.data(), begin.size()) == "PK\x03\x04";
}

SheetText read_sheet(const std::string& path, const std::optional<std::string>& sheet,
                     std::optional<char> decimal) {
  constexpr std::size_t kFewRows = 3;
  const Workbook book(path);
  std::string all, with_tables;
  std::vector<std::pair<std::string, std::vector<Row>>> tables, others;
  for (const Sheet& one : book.sheets()) {
    all += (all.empty() ? "" : ", ") + one.name + (one.is_hidden ? " (hidden)" : "");
    if (sheet) {
      if (one.name == *sheet) return text_of(path, one.name, book.rows_of(one), decimal);
      continue;
    }
    if (one.is_hidden) continue;
    std::vector<Row> rows = book.rows_of(one);
    const std::size_t count = rows_of_numbers(rows, 2);
    if (count >= kFewRows) {
      with_tables +=
          (tables.empty() ? "" : ", ") + one.name + " (" + std::to_string(count) + " rows)";
      tables.emplace_back(one.name, std::move(rows));
    } else if (rows_of_numbers(rows, 1) > 0) {
      others.emplace_back(one.name, std::move(rows));
    }
  }
  if (sheet) {
    throw InputError({path, 0}, "sheet", *sheet, "is no sheet of this workbook, which has " + all);
  }
  if (tables.size() > 1) {
    throw InputError({path, 0}, "sheet", "",
                     "must be named, as several have a table of numbers: " + with_tables);
  }
  if (tables.empty() && others.size() != 1) {
    refuse_workbook(path, "has no table of numbers on any of its sheets: " + all);
  }
  const auto& [name, rows] = tables.empty() ? others.front() : tables.front();
  return text_of(path, name, rows, decimal);
}

}  // namespace plastica::io
