#include "calibrate/config/check_unit.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "plastica/base/check.hpp"
#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

/// What to do about a column whose unit is none of what it is taken for: another column, unless
/// nothing is known of the unit.
std::string advice_on_unit(const std::string& unit, const std::string& column, Dimension dimension,
                           std::string_view option) {
  if (!unit.empty() && dimension == Dimension::Strain && io::is_unit_of(unit, Dimension::Length)) {
    return fmt::format("a length becomes a strain by --elongation \"{}\" and --gauge-length",
                       column);
  }
  if (io::is_unit(unit)) return "is another column meant?";
  return fmt::format("write {} \"{}:{}\"", option, column,
                     dimension == Dimension::Stress ? "MPa" : si_unit(dimension));
}

}  // namespace

void check_unit(const io::CsvTable& table, const ColumnSource& column, Dimension dimension,
                std::string_view option) {
  if (column.unit || column.column.find('*') != std::string::npos) return;
  const std::size_t index = table.find(column.column, {}, option);
  const std::string& unit = table.units()[index];
  try {
    io::unit_conversion(unit, dimension);
  } catch (const InputError& error) {
    throw InputError({table.file(), 0}, option, column.column,
                     (unit.empty() ? "has no unit in the file: " : "\"" + unit + "\" ") +
                         error.rule() + "; " +
                         advice_on_unit(unit, column.column, dimension, option));
  }
}

}  // namespace plastica::calibrate
