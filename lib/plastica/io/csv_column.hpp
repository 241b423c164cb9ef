#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plastica/base/quantity.hpp"
#include "plastica/io/csv.hpp"
#include "plastica/io/units.hpp"

namespace plastica::io {

/// A column of a table that some other file names.
struct NamedColumn {
  std::string name;                 ///< as `CsvTable::find` takes it
  std::optional<std::string> unit;  ///< empty: the table's own
  SourceLocation where;             ///< of the words that name it …
  std::string key;                  ///< … and their key
  bool override_unit = false;       ///< `unit` goes before another one of the table
};

/// "Stress:MPa" or "Stress": what stands behind the last colon is the unit.
NamedColumn named_column(const std::string& words, const SourceLocation& where, std::string key);

/// A column that was found, and what makes SI of its numbers.
struct FoundColumn {
  std::size_t index = 0;
  UnitConversion to_si{};
  bool has_unit = true;      ///< else it is taken for a fraction
  std::string overridden{};  ///< unit of the table that another one goes before; empty: none
};

/// A column by its name: in its given unit, or the table's. A strain or a pure number without
/// either is a fraction. A table's "-" or "1" is no unit.
/// @throws InputError if there is none, if another one has no unit, or one that does not fit, or
///         if the given unit is not the table's and does not override it
FoundColumn find_column(const CsvTable& table, const NamedColumn& column, Dimension dimension);

/// The same of a column whose place is known.
FoundColumn column_at(const CsvTable& table, std::size_t index, const NamedColumn& column,
                      Dimension dimension);

/// The numbers of a column in SI, NaN where a cell has none.
/// @throws InputError as `CsvTable::numbers`
std::vector<double> numbers_of(const CsvTable& table, const FoundColumn& column);
/// The same of some rows, in their order.
std::vector<double> numbers_of(const CsvTable& table, const FoundColumn& column,
                               std::span<const RowRange> rows);

/// A whole column in SI.
/// @throws InputError if there is no such column, its unit does not fit, or a cell is no number
std::vector<double> read_column(const CsvTable& table, const NamedColumn& column,
                                Dimension dimension);

}  // namespace plastica::io
