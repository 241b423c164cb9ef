#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/target/import.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/base/quantity.hpp"
#include "plastica/io/csv.hpp"

namespace plastica::calibrate {

/// The rows of a file that are one specimen.
struct Part {
  std::string stem;   ///< of the file
  std::string value;  ///< of the columns that split it; empty: all rows
  std::vector<io::RowRange> rows;
  std::string within;  ///< its sheet, or the path of its table of an HDF5 file …
  std::string last;    ///< … or that table's name in its group; empty if another one has it, too

  /// @param row  behind the last one
  void add(std::size_t row) {
    if (rows.empty() || rows.back().end != row) rows.push_back({row, row});
    ++rows.back().end;
  }
};

/// The table beside the curves, with the columns that the block asks for; or what an HDF5 file says
/// of one of its tables, as a table of one row.
class SpecimenTable {
 public:
  /// @param source  with a table; must outlive this
  /// @throws InputError if the table cannot be read or lacks a column
  explicit SpecimenTable(const TargetSource& source);
  /// @param properties  of one specimen
  SpecimenTable(const TargetSource& source, io::CsvTable properties);

  /// The row of the value that splits a file, of the file's stem, of the sheet or table within the
  /// file, or of that table's last name.
  /// @throws InputError if there is not exactly one row
  std::size_t row_of(const Part& part) const;
  /// A value of that row [SI]. @throws InputError if it is no positive number
  double number(std::size_t row, const SpecimenValue& value, Dimension dimension, const char* field,
                std::vector<std::string>& warnings) const;
  void add_groups(std::size_t row, Target& target) const;

 private:
  static constexpr std::size_t kTwice = static_cast<std::size_t>(-1);
  void find_columns();

  const TargetSource& source_;
  io::CsvTable table_;
  std::optional<std::size_t> key_;  ///< empty: all is of one specimen
  std::vector<std::size_t> groups_;
  std::map<std::string, std::size_t> rows_;
};

}  // namespace plastica::calibrate
