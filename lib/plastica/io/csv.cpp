#include "plastica/io/csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "plastica/base/listed.hpp"
#include "plastica/io/content_digest.hpp"
#include "plastica/io/csv_layout.hpp"
#include "plastica/io/csv_number.hpp"
#include "plastica/io/csv_text.hpp"
#include "plastica/io/hdf5_tables.hpp"
#include "plastica/io/read_input.hpp"
#include "plastica/io/units.hpp"
#include "plastica/io/workbook.hpp"

namespace plastica::io {
namespace {

using csv_text::CellKind;
using csv_text::Layout;
using csv_text::Line;

std::string count_of_cells(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " cell" : " cells");
}

/// Makes one quote of each doubled one of a quoted cell, in place.
std::string_view unescaped(std::string_view cell, std::vector<char>& text) {
  const auto begin = static_cast<std::size_t>(cell.data() - text.data());
  const bool quoted = begin > 0 && text[begin - 1] == '"';
  if (!quoted || cell.find('"') == std::string_view::npos) return cell;
  std::size_t to = begin;
  for (std::size_t from = begin; from < begin + cell.size(); ++from) {
    text[to++] = text[from];
    const bool more = from + 1 < begin + cell.size();
    if (text[from] == '"' && more && text[from + 1] == '"') ++from;
  }
  return {text.data() + begin, to - begin};
}

enum class Source { Text, Workbook, Hdf5 };
Source source_of(const std::string& path) {
  if (is_workbook(path)) return Source::Workbook;
  return begins_as_result(path) ? Source::Hdf5 : Source::Text;
}

/// Whether two units are of one dimension, and not the same. No unit is unlike none, and "1" may
/// number things: "Strain [1]".
bool are_unlike_units(std::string_view a, std::string_view b) {
  if (a.empty() || a == "1" || a == "-") return false;
  for (const Dimension dimension : {Dimension::Stress, Dimension::Force, Dimension::Length,
                                    Dimension::Strain, Dimension::Time}) {
    if (!is_unit_of(a, dimension) || !is_unit_of(b, dimension)) continue;
    const double ratio = unit_conversion(a, dimension).scale / unit_conversion(b, dimension).scale;
    return std::abs(ratio - 1.0) > 1e-9;
  }
  return false;
}

CsvTable parsed(const Hdf5Tables::Text& text, const std::string& file) {
  return CsvTable::parse(
      text.text, file,
      {.separator = '\t', .decimal = '.', .header = text.has_header ? 1 : 0, .is_made = true});
}

std::string only_table(const Hdf5Tables& tables, const std::optional<std::string>& pattern) {
  const std::vector<std::string> names = tables.matching(pattern);
  if (names.size() == 1) return names.front();
  throw InputError({tables.file(), 0}, "path", pattern.value_or(""),
                   "must be one of its tables: " + listed(names, 8));
}

}  // namespace

CsvTable CsvTable::read(const std::string& path, const CsvOptions& options) {
  const Source source = source_of(path);
  const auto refuse = [&](const char* key, const std::optional<std::string>& value,
                          std::string_view rule) {
    if (value) throw InputError({path, 0}, key, *value, rule);
  };
  if (source != Source::Workbook) {
    refuse("sheet", options.sheet, "is of workbooks (.xlsx), which this is not");
  }
  if (source != Source::Hdf5) refuse("path", options.path, "is of HDF5 files, which this is not");
  if (source == Source::Text) return parse(read_input(path, kMaxTableBytes), path, options);
  if (source == Source::Hdf5) {
    const Hdf5Tables tables(path);
    return read(tables, only_table(tables, options.path), options.decimal);
  }
  const SheetText sheet = read_sheet(path, options.sheet, options.decimal);
  CsvOptions as_written = options;
  as_written.separator = '\t';
  as_written.decimal = sheet.decimal;
  CsvTable table = parse(sheet.text, path, as_written);
  table.sheet_ = sheet.name;
  return table;
}

CsvTable CsvTable::read(const Hdf5Tables& tables, const std::string& path,
                        std::optional<char> decimal) {
  CsvTable table = of_columns(tables.columns(path), tables.file());
  table.path_ = path;
  // Of numbers in texts: "247,900" is one of two, unless it is told which.
  table.decimal_ = decimal.value_or('.');
  table.decimal_is_certain_ = decimal.has_value();
  return table;
}

/// Names and units are found as those of a text are, of which the first row is enough.
CsvTable CsvTable::of_columns(std::vector<Hdf5TableColumn> columns, const std::string& file) {
  std::vector<Hdf5TableColumn> heads;
  heads.reserve(columns.size());
  for (const Hdf5TableColumn& column : columns) {
    heads.push_back(
        {column.header, std::vector<double>(std::min<std::size_t>(column.size(), 1)), {}});
  }
  CsvTable table = parsed(Hdf5Tables::text_of(heads), file);
  table.cells_.clear();
  table.text_.clear();
  table.line_of_row_.resize(columns.front().size());
  std::iota(table.line_of_row_.begin(), table.line_of_row_.end(), 1);
  for (Hdf5TableColumn& column : columns) {
    table.numbers_.push_back(std::move(column.numbers));
    for (std::string& text : column.texts) text = csv_text::on_one_line(text);
    table.texts_.push_back(std::move(column.texts));
  }
  return table;
}

std::optional<CsvTable> CsvTable::read_properties(const Hdf5Tables& tables,
                                                  const std::string& path) {
  const std::vector<Hdf5TableColumn> properties = tables.properties(path);
  if (properties.empty()) return std::nullopt;
  CsvTable table = parsed(Hdf5Tables::text_of(properties), tables.file());
  table.decimal_is_certain_ = false;
  return table;
}

CsvTable first_table(const std::string& path, const CsvOptions& options) {
  if (source_of(path) != Source::Hdf5) return CsvTable::read(path, options);
  const Hdf5Tables tables(path);
  std::optional<InputError> first;
  for (const std::string& name : tables.matching(options.path)) {
    try {
      return CsvTable::read(tables, name, options.decimal);
    } catch (const InputError& error) {
      if (!first) first = error;
    }
  }
  throw InputError(*first);
}

std::string table_text(const std::string& path, const CsvOptions& options) {
  switch (source_of(path)) {
    case Source::Workbook: return read_sheet(path, options.sheet, options.decimal).text;
    case Source::Hdf5: {
      const Hdf5Tables tables(path);
      return Hdf5Tables::text_of(tables.columns(only_table(tables, options.path))).text;
    }
    case Source::Text: break;
  }
  return read_input(path, kMaxTableBytes);
}

CsvTable CsvTable::parse(std::string_view text, std::string name, const CsvOptions& options) {
  CsvTable table;
  table.file_ = std::move(name);
  table.text_ = csv_text::decoded(text, table.file_);
  const std::string_view all(table.text_.data(), table.text_.size());
  const std::vector<Line> lines = csv_text::lines_of(all);
  const Layout layout = csv_text::layout_of(lines, table.file_, options);
  const char separator = layout.dialect.separator;
  table.separator_ = separator;
  table.decimal_ = layout.dialect.format.decimal;
  table.decimal_is_certain_ = layout.dialect.format.is_certain;

  std::vector<std::string_view> cells;
  const std::size_t before =
      layout.header ? *layout.header : layout.unit_row.value_or(layout.first_data);
  for (std::size_t i = 0; i < before; ++i) table.preamble_.emplace_back(lines[i].text);

  if (layout.header) {
    std::string_view header = csv_text::without_blanks(lines[*layout.header].text, separator);
    if (header.starts_with('#') && !options.is_made) header.remove_prefix(1);  // as NumPy writes it
    if (!csv_text::split_names(header, separator, layout.dialect.width, cells)) {
      throw InputError({table.file_, lines[*layout.header].number}, "", "",
                       "has a quote that is not closed");
    }
    while (cells.size() > layout.dialect.width && cells.back().empty()) cells.pop_back();
    for (const std::string_view cell : cells) {
      auto [column, unit] = csv_text::name_and_unit(unescaped(cell, table.text_));
      table.names_.push_back(std::move(column));
      table.units_.push_back(std::move(unit));
    }
  }
  const std::size_t named = table.names_.size();
  const std::size_t width = std::max(named, layout.dialect.width);
  table.names_.resize(width);
  table.units_.resize(width);
  if (layout.unit_row) {
    csv_text::split(lines[*layout.unit_row].text, separator, cells);
    for (std::size_t i = 0; i < std::min(cells.size(), width); ++i) {
      std::string unit = csv_text::unit_cell(cells[i]).unit;
      if (unit.empty()) continue;
      if (are_unlike_units(table.units_[i], unit)) table.units_by_name_[i] = table.units_[i];
      table.units_[i] = std::move(unit);
    }
  }
  const auto wanted = [&] {
    return layout.header ? "the header on line " + std::to_string(lines[*layout.header].number) +
                               " has " + std::to_string(named)
                         : "the other rows have " + std::to_string(width);
  };

  const bool ends_in_newline = all.ends_with('\n') || all.ends_with('\r');
  std::vector<bool> filled(width, false);
  const auto is_comment = [&](std::size_t i) {
    return !options.is_made && csv_text::is_comment(lines[i].text);
  };
  std::size_t last_line = lines.size();
  while (last_line > layout.first_data + 1 && is_comment(last_line - 1)) --last_line;
  table.cells_.reserve((lines.size() - layout.first_data) * width);
  for (std::size_t i = layout.first_data; i < lines.size(); ++i) {
    const bool closed = csv_text::split(lines[i].text, separator, cells);
    // "# paused" amid numbers; a column of words may hold such a one.
    const bool of_words = cells.size() == width && !layout.dialect.numeric.front();
    if (is_comment(i) && !of_words) {
      table.commented_rows_ +=
          cells.size() == width && width > 1 &&
                  csv_text::read_number(cells.back(), layout.dialect.format).kind ==
                      CellKind::Number
              ? 1
              : 0;
      continue;
    }
    const bool last = i + 1 == last_line;
    while (cells.size() > width && cells.back().empty()) cells.pop_back();
    bool torn = last && (!closed || cells.size() < width);
    if (last && !torn && !ends_in_newline && cells.size() == width) {
      const auto kind = csv_text::read_number(cells.back(), layout.dialect.format).kind;
      const bool number_wanted = layout.dialect.numeric.size() == width &&
                                 layout.dialect.numeric.back() && table.rows() > 0;
      // Cut off inside its last cell ("1.2e-"), or just before it.
      torn = number_wanted && (kind == CellKind::Text || cells.back() == "-" ||
                               (cells.back().empty() && !table.cells_.back().empty()));
    }
    if (torn && table.rows() > 0) {
      table.torn_last_row_ = true;
      break;
    }
    if (!closed) {
      throw InputError({table.file_, lines[i].number}, "", "", "has a quote that is not closed");
    }
    if (cells.size() != width) {
      throw InputError({table.file_, lines[i].number}, "", "",
                       "has " + count_of_cells(cells.size()) + ", " + wanted());
    }
    for (std::size_t k = 0; k < width; ++k) {
      const std::string_view cell = cells[k];
      if (!cell.empty()) filled[k] = true;
      table.cells_.push_back(unescaped(cell, table.text_));
    }
    table.line_of_row_.push_back(lines[i].number);
  }
  if (table.rows() == 0) throw InputError({table.file_, 0}, "", "", "holds no data row");

  // A separator behind the last cell of each row makes a column without name or content.
  if (width > 1 && named < width && layout.header) {
    if (filled.back()) {
      throw InputError({table.file_, table.line_of_row_[0]}, "", "",
                       "has " + count_of_cells(width) + ", " + wanted());
    }
    table.drop_last_column();
  } else if (width > 1 && !filled.back() && table.names_.back().empty()) {
    table.drop_last_column();
  }
  return table;
}

void CsvTable::drop_last_column() {
  const std::size_t old_width = columns();
  names_.pop_back();
  units_.pop_back();
  const std::size_t width = columns();
  for (std::size_t row = 0; row < rows(); ++row) {
    for (std::size_t k = 0; k < width; ++k) cells_[row * width + k] = cells_[row * old_width + k];
  }
  cells_.resize(rows() * width);
}

std::size_t CsvTable::bytes() const {
  std::size_t count = text_.size() + cells_.size() * sizeof(std::string_view);
  for (const std::vector<double>& column : numbers_) count += column.size() * sizeof(double);
  for (const std::vector<std::string>& column : texts_)
    count += column.size() * sizeof(std::string);
  return count;
}

std::string_view CsvTable::text_at(std::size_t row, std::size_t column) const {
  return texts_.empty() ? cells_[row * columns() + column] : std::string_view(texts_[column][row]);
}

std::string CsvTable::cell(std::size_t row, std::size_t column) const {
  const bool is_number = !numbers_.empty() && !numbers_[column].empty();
  return is_number ? csv_text::number_text(numbers_[column][row])
                   : std::string(text_at(row, column));
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  csv_text::Number number;
  if (numbers_.empty() || numbers_[column].empty()) {
    number = csv_text::read_number(text_at(row, column), {decimal_, decimal_is_certain_});
  } else if (!std::isinf(numbers_[column][row])) {
    return numbers_[column][row];
  }
  if (number.kind == CellKind::Number || number.kind == CellKind::Missing) return number.value;
  throw InputError(
      {file_, line_of_row_[row]}, label(column), cell(row, column),
      number.kind == CellKind::OutOfRange ? "is a number out of range" : "is not a number");
}

std::string CsvTable::label(std::size_t column) const {
  return names_[column].empty() ? "column " + std::to_string(column + 1) : names_[column];
}

std::vector<double> CsvTable::numbers(std::size_t column) const {
  const RowRange all{0, rows()};
  return numbers(column, {&all, 1});
}

std::vector<double> CsvTable::numbers(std::size_t column, std::span<const RowRange> rows) const {
  std::size_t count = 0;
  for (const RowRange& range : rows) count += range.end - range.begin;
  std::vector<double> values;
  values.reserve(count);
  for (const RowRange& range : rows) {
    for (std::size_t row = range.begin; row < range.end; ++row)
      values.push_back(number(row, column));
  }
  return values;
}

std::vector<std::size_t> CsvTable::matches(std::string_view name_or_number) const {
  const std::string_view wanted = csv_text::without_blanks(name_or_number);
  if (wanted.empty()) return {};
  std::vector<std::size_t> found;
  const auto collect = [&](auto&& fits) {
    for (std::size_t i = 0; found.size() < columns() && i < columns(); ++i) {
      if (!names_[i].empty() && fits(i)) found.push_back(i);
    }
    return !found.empty();
  };
  const std::string lower = csv_text::lower_case(wanted);
  // "Stress (MPa)" as the file has it, though its name here is "Stress".
  const std::pair<std::string, std::string> parts = csv_text::name_and_unit(wanted);
  if (collect([&](std::size_t i) { return names_[i] == wanted; }) ||
      collect([&](std::size_t i) { return csv_text::lower_case(names_[i]) == lower; }) ||
      (!parts.second.empty() && collect([&](std::size_t i) {
        return names_[i] == parts.first && units_[i] == parts.second;
      }))) {
    return found;
  }
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  const bool whole = error == std::errc{} && end == wanted.data() + wanted.size();
  if (whole && number >= 1 && number <= columns()) found.push_back(number - 1);
  return found;
}

std::optional<std::size_t> CsvTable::find(std::string_view name_or_number) const {
  const std::vector<std::size_t> found = matches(name_or_number);
  if (found.size() != 1) return std::nullopt;
  return found[0];
}

std::size_t CsvTable::find(std::string_view name_or_number, const SourceLocation& where,
                           std::string_view field) const {
  const std::vector<std::size_t> found = matches(name_or_number);
  if (found.size() == 1) return found[0];
  if (found.size() > 1) {
    throw InputError(where, field, name_or_number,
                     "is the name of columns " + std::to_string(found[0] + 1) + " and " +
                         std::to_string(found[1] + 1) + " of " + file_ + "; give the number");
  }
  std::string list;
  constexpr std::size_t kShown = 12;
  for (std::size_t i = 0; i < std::min(columns(), kShown); ++i) {
    if (!names_[i].empty()) list += (list.empty() ? "" : ", ") + names_[i];
  }
  if (!list.empty() && columns() > kShown) list += ", ...";
  const std::string count = std::to_string(columns()) + (columns() == 1 ? " column" : " columns");
  throw InputError(where, field, name_or_number,
                   "is not a column of " + file_ + ", which has " + count +
                       (list.empty() ? " without names" : ": " + list));
}

}  // namespace plastica::io
