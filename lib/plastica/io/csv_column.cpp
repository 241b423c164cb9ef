#include "plastica/io/csv_column.hpp"

#include <cmath>

#include "plastica/io/units.hpp"

namespace plastica::io {

NamedColumn named_column(const std::string& words, const SourceLocation& where, std::string key) {
  const std::size_t colon = words.rfind(':');
  if (colon == std::string::npos) return {words, std::nullopt, where, std::move(key)};
  return {words.substr(0, colon), words.substr(colon + 1), where, std::move(key)};
}

std::vector<double> read_column(const CsvTable& table, const NamedColumn& column,
                                Dimension dimension) {
  const std::size_t index = table.find(column.name, column.where, column.key);
  const UnitConversion to_si =
      column.unit ? unit_conversion(*column.unit, dimension, column.where, column.key)
                  : unit_conversion(table.units()[index], dimension, {table.file(), 0},
                                    "unit of " + column.name);
  std::vector<double> values = table.numbers(index);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!std::isfinite(values[row])) {
      throw InputError({table.file(), table.line_of_row(row)}, column.name,
                       std::string(table.cell(row, index)), "must be a number");
    }
    values[row] = to_si(values[row]);
  }
  return values;
}

}  // namespace plastica::io
