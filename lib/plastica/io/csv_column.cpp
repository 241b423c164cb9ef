#include "plastica/io/csv_column.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plastica::io {
namespace {

/// Whether the table's unit is the same as one that was given, or none.
bool agrees(const std::string& own, const UnitConversion& given, Dimension dimension) {
  if (own.empty() || own == "-" || own == "1") return true;
  constexpr double kRounding = 1e-9;
  try {
    const UnitConversion to_si = unit_conversion(own, dimension);
    return std::abs(to_si.scale - given.scale) <= kRounding * std::abs(given.scale) &&
           std::abs(to_si.offset - given.offset) <= kRounding * std::abs(given.offset);
  } catch (const InputError&) {
    // The unit of something else, unless the user takes it for a pure number.
    return dimension == Dimension::None;
  }
}

/// What in a column's name stands against its unit; empty if nothing does.
std::string contradiction_of(const CsvTable& table, std::size_t index, Dimension dimension) {
  const std::string& unit = table.units()[index];
  if (const std::string by_name = table.unit_by_name(index); !by_name.empty()) {
    return fmt::format(
        "is in {} by its name and in {} by the row of units of {}: correct one of them", by_name,
        unit, table.file());
  }
  const std::string factor = factor_in_name(table.names()[index], dimension, !unit.empty());
  if (factor.empty()) return {};
  return fmt::format("has \"{}\" in its name in {}, and factors are not read: scale the column",
                     factor, table.file());
}

}  // namespace

NamedColumn named_column(const std::string& words, const SourceLocation& where, std::string key) {
  const std::size_t colon = words.rfind(':');
  if (colon == std::string::npos) return {words, std::nullopt, where, std::move(key)};
  return {words.substr(0, colon), words.substr(colon + 1), where, std::move(key)};
}

FoundColumn column_at(const CsvTable& table, std::size_t index, const NamedColumn& column,
                      Dimension dimension) {
  const std::string contradiction = contradiction_of(table, index, dimension);
  if (!contradiction.empty() && !column.override_unit) {
    throw InputError(column.where, column.key, column.name,
                     contradiction +
                         ", or give a unit and let it go before (override_unit = "
                         "true, --override-unit)");
  }
  if (column.unit) {
    const UnitConversion given = unit_conversion(*column.unit, dimension, column.where, column.key);
    const std::string& own = table.units()[index];
    if (agrees(own, given, dimension)) return {index, given};
    if (column.override_unit) return {index, given, true, own};
    throw InputError(column.where, column.key, *column.unit,
                     fmt::format("contradicts {}, where \"{}\" is in {}: correct one of them, or "
                                 "let this one go before (override_unit = true, --override-unit)",
                                 table.file(), table.names()[index], own));
  }
  const std::string& unit = table.units()[index];
  const bool is_fraction = dimension == Dimension::None || dimension == Dimension::Strain;
  if (unit.empty() && !is_fraction) {
    throw InputError(column.where, column.key, column.name,
                     "needs a unit, as " + table.file() + " gives none");
  }
  return {index, unit_conversion(unit, dimension, {table.file(), 0}, "unit of " + column.name),
          !unit.empty()};
}

FoundColumn find_column(const CsvTable& table, const NamedColumn& column, Dimension dimension) {
  return column_at(table, table.find(column.name, column.where, column.key), column, dimension);
}

std::vector<double> numbers_of(const CsvTable& table, const FoundColumn& column) {
  const RowRange all{0, table.rows()};
  return numbers_of(table, column, {&all, 1});
}

std::vector<double> numbers_of(const CsvTable& table, const FoundColumn& column,
                               std::span<const RowRange> rows) {
  std::vector<double> values = table.numbers(column.index, rows);
  for (double& value : values) value = column.to_si(value);
  return values;
}

std::vector<double> read_column(const CsvTable& table, const NamedColumn& column,
                                Dimension dimension) {
  const FoundColumn found = find_column(table, column, dimension);
  std::vector<double> values = numbers_of(table, found);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::isfinite(values[row])) continue;
    throw InputError({table.file(), table.line_of_row(row)}, column.name,
                     std::string(table.cell(row, found.index)), "must be a number");
  }
  return values;
}

}  // namespace plastica::io
