#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/base/check.hpp"

namespace plastica::io {

class Hdf5Tables;
struct Hdf5TableColumn;

/// How to read a delimited text file; what is unset is found out from the text.
struct CsvOptions {
  std::optional<char> separator = {};      ///< ',', ';', tab, or ' ' for any number of blanks
  std::optional<char> decimal = {};        ///< '.' or ','
  std::optional<std::size_t> header = {};  ///< line of the column names, from 1; 0: there is none
  std::optional<std::string> sheet =
      {};  ///< of a workbook: its name; else the only one with a table
  /// Of an HDF5 file: the path of its table, in which a `*` stands for any characters; else the
  /// only one there is.
  std::optional<std::string> path = {};
  /// The text was made of a table whose structure is known: no row of units, no comments.
  bool is_made = false;

  friend bool operator==(const CsvOptions&, const CsvOptions&) = default;
};

/// Rows of a table from one to before another one.
struct RowRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A delimited text file as laboratories write it: metadata lines, a header, a unit row, data. A
/// line of the data that begins with #, % or // is a comment, unless the first column is one of
/// words. UTF-16 is read as well, and numbers whose thousands stand apart: 1,234.5. Of an Excel
/// workbook (.xlsx) a sheet is read, its rows as lines, and of an HDF5 file a table (see
/// `Hdf5Tables`), its rows as lines, from 1.
///
/// The text is kept, or the columns of an HDF5 file's table; copies are not allowed, moves are.
class CsvTable {
 public:
  /// @throws InputError if the file cannot be read, holds no data row, or rows have unequal widths
  ///         (a shorter last row, cut off while writing, is dropped and reported by
  ///         `torn_last_row`)
  static CsvTable read(const std::string& path, const CsvOptions& options = {});
  static CsvTable parse(std::string_view text, std::string name, const CsvOptions& options = {});
  /// One table of an HDF5 file. @throws InputError as above
  /// @param decimal  mark of numbers in its texts; empty: a point, and what may be another number
  ///                 is none
  static CsvTable read(const Hdf5Tables& tables, const std::string& path,
                       std::optional<char> decimal = {});
  /// What such a file says of a table beside its columns, as a table of one row; empty if nothing.
  /// @throws InputError as above
  static std::optional<CsvTable> read_properties(const Hdf5Tables& tables, const std::string& path);

  CsvTable(CsvTable&&) noexcept = default;
  CsvTable& operator=(CsvTable&&) noexcept = default;
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  const std::string& file() const { return file_; }
  const std::string& sheet() const { return sheet_; }  ///< of a workbook; else empty
  const std::string& path() const { return path_; }    ///< of a table of an HDF5 file; else empty
  char separator() const { return separator_; }
  char decimal() const { return decimal_; }
  bool torn_last_row() const { return torn_last_row_; }
  /// Lines amid the data that are comments, and hold as many cells as a row, the last a number:
  /// taken for comments, they may be rows.
  std::size_t commented_rows() const { return commented_rows_; }
  /// Lines before the header that are not column names (metadata).
  const std::vector<std::string>& preamble() const { return preamble_; }
  /// Column names without quotes, blanks and unit; empty strings where the file has no header.
  const std::vector<std::string>& names() const { return names_; }
  /// Unit of each column from a unit row or from "name (unit)", "name [unit]", "name / unit";
  /// empty if the file gives none.
  const std::vector<std::string>& units() const { return units_; }
  /// The unit that a column's name gives, where the row of units, which counts, gives another one
  /// of its dimension; else empty.
  std::string unit_by_name(std::size_t column) const {
    const auto found = units_by_name_.find(column);
    return found == units_by_name_.end() ? std::string() : found->second;
  }

  /// A column's name for error lines: "column 2" where the file has none.
  std::string label(std::size_t column) const;

  /// What it takes of memory, about.
  std::size_t bytes() const;

  std::size_t rows() const { return line_of_row_.size(); }
  std::size_t columns() const { return names_.size(); }
  int line_of_row(std::size_t row) const { return line_of_row_[row]; }
  /// As the file has it; a number that has no text as one that reads back bit by bit.
  std::string cell(std::size_t row, std::size_t column) const;

  /// A cell as a number; NaN for an empty cell or one that says NaN, NA, n/a, -, null.
  /// @throws InputError if it is anything else
  double number(std::size_t row, std::size_t column) const;
  /// A whole column as numbers. @throws InputError as above
  std::vector<double> numbers(std::size_t column) const;
  /// The same of some rows, in their order.
  std::vector<double> numbers(std::size_t column, std::span<const RowRange> rows) const;

  /// Column by exact name, by name without case, by name with unit as in the file, or by number
  /// ("1" is the first).
  /// @throws InputError that lists the columns there are, or says that two have that name;
  ///         `where`, `field`: who asked
  std::size_t find(std::string_view name_or_number, const SourceLocation& where,
                   std::string_view field) const;
  /// The same, empty if there is none or more than one.
  std::optional<std::size_t> find(std::string_view name_or_number) const;

 private:
  CsvTable() = default;

  static CsvTable of_columns(std::vector<Hdf5TableColumn> columns, const std::string& file);
  std::string_view text_at(std::size_t row, std::size_t column) const;
  void drop_last_column();
  std::vector<std::size_t> matches(std::string_view name_or_number) const;

  std::string file_;
  std::string sheet_;
  std::string path_;
  std::vector<char> text_;  // not a string: a moved short string would move its characters
  char separator_ = ',';
  char decimal_ = '.';
  bool decimal_is_certain_ = false;
  bool torn_last_row_ = false;
  std::size_t commented_rows_ = 0;
  std::vector<std::string> preamble_;
  std::vector<std::string> names_;
  std::vector<std::string> units_;
  std::map<std::size_t, std::string> units_by_name_;
  std::vector<int> line_of_row_;
  std::vector<std::string_view> cells_;  // (rows x columns), row by row; views into the text
  // Columns of an HDF5 file's table, each of numbers or of texts; then there are no cells.
  std::vector<std::vector<double>> numbers_;
  std::vector<std::vector<std::string>> texts_;
};

/// What `CsvTable::read` reads, and of an HDF5 file that has several tables the first that can be
/// read.
/// @throws InputError as `CsvTable::read`
CsvTable first_table(const std::string& path, const CsvOptions& options = {});

/// The text that a table is read from: the file's, that of a workbook's sheet, or an HDF5 file's
/// table as text.
/// @throws InputError as `CsvTable::read`
std::string table_text(const std::string& path, const CsvOptions& options = {});

}  // namespace plastica::io
