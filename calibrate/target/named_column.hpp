#pragma once

#include <string>
#include <utility>

#include "calibrate/target/import.hpp"
#include "plastica/io/csv_column.hpp"

/// What the library's search for a column is told; not installed.
namespace plastica::calibrate {

/// @param key  of the user's words, for error lines
inline io::NamedColumn named(const ColumnSource& source, std::string key) {
  return {source.column, source.unit, source.where, std::move(key), source.override_unit};
}

/// @param value  a column of the table
inline io::NamedColumn named(const SpecimenValue& value, std::string key) {
  return {value.from, value.unit, value.where, std::move(key), value.override_unit};
}

}  // namespace plastica::calibrate
