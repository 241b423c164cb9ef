#include "plastica/io/csv_layout.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace plastica::io::csv_text {
namespace {

using Cells = std::vector<std::string_view>;

/// Finds the parts of a file whose dialect is known.
class Finder {
 public:
  Finder(const std::vector<Line>& lines, const std::string& file, const CsvOptions& options)
      : lines_(lines), file_(file), options_(options), dialect_(dialect_of(lines, options)) {
    any_numeric_ =
        std::find(dialect_.numeric.begin(), dialect_.numeric.end(), true) != dialect_.numeric.end();
  }

  Layout layout() {
    Layout layout;
    layout.dialect = dialect_;
    if (options_.header.value_or(0) > 0) {
      layout.header = line_index(*options_.header);
      layout.first_data = *layout.header + 1;
      const bool more = layout.first_data < lines_.size() && !options_.is_made;
      if (more && !is_data(layout.first_data) && is_unit_row(layout.first_data)) {
        layout.unit_row = layout.first_data++;
      }
    } else if (!options_.is_made) {
      layout.first_data = first_data();
      if (!options_.header && layout.first_data > 0) find_header(layout);
    }
    if (layout.first_data >= lines_.size()) {
      throw InputError({file_, 0}, "", "", "holds no data row");
    }
    return layout;
  }

 private:
  const Cells& cells_of(std::size_t line) {
    if (!split(lines_[line].text, dialect_.separator, cells_)) cells_.clear();
    return cells_;
  }

  /// The same of a line that may hold the columns' names.
  const Cells& names_of(std::size_t line) {
    if (!split_names(lines_[line].text, dialect_.separator, dialect_.width, cells_)) cells_.clear();
    return cells_;
  }

  CellKind kind_of(std::string_view cell) const { return read_number(cell, dialect_.format).kind; }

  bool is_data(std::size_t line) {
    const Cells& cells = cells_of(line);
    bool any = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      // A row of another width is a broken one, to be reported, if it is numbers all through.
      if (cells.size() == dialect_.width && !dialect_.numeric[i]) continue;
      const CellKind kind = kind_of(cells[i]);
      if (kind == CellKind::Text) return false;
      any = any || kind != CellKind::Missing || says_nan(cells[i]);
    }
    return any && (cells.size() == dialect_.width || cells.size() > 1);
  }

  bool is_unit_row(std::size_t line) {
    const Cells& cells = cells_of(line);
    const bool fits = cells.size() == dialect_.width || cells.size() + 1 == dialect_.width;
    // Units are those of numbers: "A-1,,A" is a specimen without its number.
    bool is_of_numbers = cells.size() != dialect_.width || !any_numeric_;
    for (std::size_t i = 0; i < cells.size() && !is_of_numbers; ++i) {
      is_of_numbers = dialect_.numeric[i] && !cells[i].empty();
    }
    return fits && is_of_numbers && std::ranges::all_of(cells, [](std::string_view cell) {
             return unit_cell(cell).is_unit;
           });
  }

  /// Could be a row of names over the data: few numbers in it, not a line of metadata.
  bool is_header(std::size_t line) {
    std::string_view text = without_blanks(lines_[line].text);
    if (text.starts_with('{')) return false;
    const Cells& cells = names_of(line);
    const bool has_words = std::ranges::any_of(
        cells, [&](std::string_view cell) { return kind_of(cell) == CellKind::Text; });
    if (!has_words) return false;  // "NaN", "-" and "n/a" are numbers that are missing
    const auto numbers = std::count_if(cells.begin(), cells.end(), [&](std::string_view cell) {
      return kind_of(cell) == CellKind::Number || kind_of(cell) == CellKind::OutOfRange;
    });
    // "Strain,Stress,2" is one; "Area,120" is metadata or a broken row.
    if (numbers > 0 && (cells.size() != dialect_.width || numbers * 3 > std::ssize(cells))) {
      return false;
    }
    const auto filled = static_cast<std::size_t>(std::count_if(
        cells.begin(), cells.end(), [](std::string_view cell) { return !cell.empty(); }));
    if (cells.size() == dialect_.width || filled == dialect_.width) return true;
    if (cells.size() + 1 == dialect_.width && cells.size() > 1) return true;
    return cells.size() > dialect_.width && filled > 1;
  }

  std::size_t line_index(std::size_t number) const {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (lines_[i].number == static_cast<int>(number)) return i;
    }
    throw InputError({file_, static_cast<int>(number)}, "", "",
                     "is blank or past the end, so it cannot be the header");
  }

  std::size_t first_data() {
    constexpr std::size_t kFollowers = 3;
    if (!any_numeric_) {
      // Text only: the first row of the usual width is the header.
      std::size_t first = 0;
      while (first < lines_.size() && cells_of(first).size() != dialect_.width) ++first;
      // The usual width is that of a line that can be cut into cells: there is no such line.
      if (first == lines_.size()) {
        throw InputError({file_, lines_[0].number}, "", "", "has a quote that is not closed");
      }
      return options_.header ? first : first + 1;
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!is_data(i)) continue;
      // Under a header, or with no header soon to come: then a broken row below is no excuse to
      // take this one for metadata.
      if (i > 0 && is_header(i - 1) && !is_table_of_results(i)) return i;
      bool header_follows = false;
      for (std::size_t k = i + 1; k <= i + kFollowers && k < lines_.size(); ++k) {
        header_follows = header_follows || is_header(k);
      }
      if (!header_follows) return i;
    }
    return lines_.size();
  }

  /// A row of names in each column, unlike a row of data that lacks its numbers.
  bool has_words_alone(std::size_t line) {
    const Cells& cells = names_of(line);
    return cells.size() == dialect_.width && std::ranges::all_of(cells, [&](std::string_view cell) {
             return kind_of(cell) == CellKind::Text;
           });
  }

  bool lacks_numbers(std::size_t line) {
    const Cells& cells = cells_of(line);
    if (cells.size() != dialect_.width) return false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (dialect_.numeric[i] && kind_of(cells[i]) != CellKind::Missing) return false;
    }
    return true;
  }

  /// Whether the rows from a line on are a short table, of results, above the one of the curve.
  bool is_table_of_results(std::size_t begin) {
    constexpr std::size_t kMostRows = 2;
    std::size_t end = begin;
    while (end < lines_.size() && end <= begin + kMostRows && is_data(end)) ++end;
    if (end > begin + kMostRows || end + 1 >= lines_.size()) return false;
    const bool has_units = is_unit_row(end + 1);
    const std::size_t next = end + (has_units ? 2 : 1);
    if (!has_words_alone(end) || next + kMostRows >= lines_.size()) return false;
    for (std::size_t i = next; i <= next + kMostRows; ++i) {
      if (!is_data(i)) return false;
    }
    return true;
  }

  void find_header(Layout& layout) {
    const std::size_t above = layout.first_data - 1;
    if (above > 0 && is_unit_row(above) && is_header(above - 1)) {
      layout.unit_row = above;
      layout.header = above - 1;
    } else if (is_header(above)) {
      // Rows without their numbers, right below the names, are rows all the same.
      std::size_t names = above;
      while (names > 0 && lacks_numbers(names)) --names;
      layout.header = has_words_alone(names) ? names : above;
      layout.first_data = *layout.header + 1;
    } else if (is_unit_row(above)) {
      layout.unit_row = above;
    } else {
      refuse_broken_row(above);
    }
  }

  /// A line over the data that is no header is metadata, but not below a header, nor when it has
  /// the width of the data and numbers in it: then it is a broken row.
  void refuse_broken_row(std::size_t line) {
    const Cells& cells = cells_of(line);
    const auto numbers = std::count_if(cells.begin(), cells.end(), [&](std::string_view cell) {
      return kind_of(cell) == CellKind::Number;
    });
    if (cells.size() == dialect_.width && numbers > 1) refuse_text_in(line);
    std::size_t checked = line + 1;  // below a header, and found to be without text
    for (std::size_t above = line; above-- > 0;) {
      if (!is_header(above) || names_of(above).size() != dialect_.width) continue;
      for (std::size_t broken = above + 1; broken < checked; ++broken) {
        if (!is_unit_row(broken)) refuse_text_in(broken);
      }
      checked = above + 1;
    }
  }

  void refuse_text_in(std::size_t line) {
    for (const std::string_view cell : cells_of(line)) {
      if (kind_of(cell) != CellKind::Text) continue;
      throw InputError({file_, lines_[line].number}, "", cell, "is not a number");
    }
  }

  const std::vector<Line>& lines_;
  const std::string& file_;
  const CsvOptions& options_;
  Dialect dialect_;
  bool any_numeric_ = false;
  Cells cells_;
};

/// Refuses a column such as 998, 999, 1,000 in a file without a number that shows what its marks
/// are: they may begin decimals or part thousands. A column whose other numbers all have decimals
/// is clear: nobody writes 999.0 and 1.000 for a thousand.
void refuse_ambiguous(const std::vector<Line>& lines, const Layout& layout,
                      const std::string& file) {
  struct Column {
    bool has_whole = false;
    bool is_clear = false;  ///< a number can be read in one way only
    std::size_t line = 0;   ///< of one that can be read in two
    std::string_view cell;
  };
  std::vector<Column> columns(layout.dialect.width);
  Cells cells;
  const auto is_clear = [](const Column& column) { return column.is_clear; };
  const auto of_whole = [](char c) { return c == '+' || c == '-' || (c >= '0' && c <= '9'); };
  for (std::size_t i = layout.first_data; i < lines.size(); ++i) {
    if (std::ranges::all_of(columns, is_clear)) return;
    if (!split(lines[i].text, layout.dialect.separator, cells)) continue;
    for (std::size_t k = 0; k < std::min(cells.size(), columns.size()); ++k) {
      Column& column = columns[k];
      if (column.is_clear) continue;
      const Number number = read_number(cells[k], layout.dialect.format);
      if (number.kind != CellKind::Number) continue;
      if (is_ambiguous(cells[k])) {
        if (!column.cell.empty()) continue;
        column.line = i;
        column.cell = cells[k];
      } else if (std::ranges::all_of(cells[k], of_whole) && std::abs(number.value) < 1000.0) {
        column.has_whole = true;
      } else {
        column.is_clear = true;
      }
    }
  }
  for (const Column& column : columns) {
    if (column.cell.empty() || !column.has_whole || column.is_clear) continue;
    throw InputError({file, lines[column.line].number}, "", column.cell,
                     "has a decimal mark or one of thousands: say which by decimal = \".\" or "
                     "\",\" (--decimal)");
  }
}

}  // namespace

Layout layout_of(const std::vector<Line>& lines, const std::string& file,
                 const CsvOptions& options) {
  if (lines.empty()) throw InputError({file, 0}, "", "", "is empty");
  Layout layout = Finder(lines, file, options).layout();
  const NumberFormat& format = layout.dialect.format;
  // Who parts thousands by points has decimal commas, and no commas between cells.
  const bool is_plain = layout.dialect.separator == ',' && format.decimal == '.';
  if (!format.is_certain && !is_plain) refuse_ambiguous(lines, layout, file);
  return layout;
}

}  // namespace plastica::io::csv_text
