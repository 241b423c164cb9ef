#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "plastica/io/csv.hpp"
#include "plastica/io/csv_dialect.hpp"
#include "plastica/io/csv_text.hpp"

namespace plastica::io::csv_text {

/// Where things are in a file; indices into its lines.
struct Layout {
  Dialect dialect;
  std::optional<std::size_t> header;
  std::optional<std::size_t> unit_row;
  std::size_t first_data = 0;
};

/// Finds the dialect of lines, and with it the header, the unit row and the first row of data.
///
/// Data begin at the first line that is a row of numbers, unless a header follows soon after it.
/// The line above is the header, or the unit row below it; what stands before is metadata.
/// @throws InputError if there is no row of data, a line above the data is a broken row, or numbers
///         of a column are either decimal fractions or thousands
Layout layout_of(const std::vector<Line>& lines, const std::string& file,
                 const CsvOptions& options);

}  // namespace plastica::io::csv_text
