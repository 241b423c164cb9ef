#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plastica/base/quantity.hpp"
#include "plastica/io/csv.hpp"

namespace plastica::io {

/// A column of a table that some other file names.
struct NamedColumn {
  std::string name;                 ///< as `CsvTable::find` takes it
  std::optional<std::string> unit;  ///< empty: the table's own
  SourceLocation where;             ///< of the words that name it …
  std::string key;                  ///< … and their key
};

/// "Stress:MPa" or "Stress": what stands behind the last colon is the unit.
NamedColumn named_column(const std::string& words, const SourceLocation& where, std::string key);

/// A whole column in SI.
/// @throws InputError if there is no such column, its unit does not fit, or a cell is no number
std::vector<double> read_column(const CsvTable& table, const NamedColumn& column,
                                Dimension dimension);

}  // namespace plastica::io
