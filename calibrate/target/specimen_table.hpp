#pragma once

#include <cstddef>
#include <map>
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
  std::vector<std::size_t> rows;

  std::vector<double> of(std::vector<double> values) const {
    if (value.empty()) return values;
    std::vector<double> own;
    own.reserve(rows.size());
    for (const std::size_t row : rows) own.push_back(values[row]);
    return own;
  }
};

/// The table beside the curves, with the columns that the block asks for.
class SpecimenTable {
 public:
  /// @param source  with a table; must outlive this
  /// @throws InputError if the table cannot be read or lacks a column
  explicit SpecimenTable(const TargetSource& source);

  /// The row of a file's stem, or of the value that splits it.
  /// @throws InputError if there is not exactly one row
  std::size_t row_of(const Part& part) const;
  /// A value of that row [SI]. @throws InputError if it is no positive number
  double number(std::size_t row, const SpecimenValue& value, Dimension dimension, const char* field,
                std::vector<std::string>& warnings) const;
  void add_groups(std::size_t row, Target& target) const;

 private:
  static constexpr std::size_t kTwice = static_cast<std::size_t>(-1);
  const TargetSource& source_;
  io::CsvTable table_;
  std::size_t key_;
  std::vector<std::size_t> groups_;
  std::map<std::string, std::size_t> rows_;
};

}  // namespace plastica::calibrate
