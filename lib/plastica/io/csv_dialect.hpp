#pragma once

#include <cstddef>
#include <vector>

#include "plastica/io/csv.hpp"
#include "plastica/io/csv_number.hpp"
#include "plastica/io/csv_text.hpp"

namespace plastica::io::csv_text {

/// How a file writes its rows, as its lines show.
struct Dialect {
  char separator = ',';
  NumberFormat format;
  std::size_t width = 1;      ///< cells of a data row
  std::vector<bool> numeric;  ///< (width): the column holds numbers, mostly
};

/// Finds the separator and decimal mark under which the lines hold the most numbers in rows of one
/// width.
Dialect dialect_of(const std::vector<Line>& lines, const CsvOptions& options);

}  // namespace plastica::io::csv_text
