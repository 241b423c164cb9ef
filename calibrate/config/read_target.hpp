#pragma once

#include <string>

#include "calibrate/target/import.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {

/// The column of a table { column = "Stress", unit = "MPa" }.
/// @throws InputError for a unit that does not fit the dimension
ColumnSource read_column(const io::TomlTable& table, Dimension dimension);

/// The key `factor` of such a table; 1 without. @throws InputError for 0
double read_factor(const io::TomlTable& table);

/// What a [[target]] says.
struct TargetBlock {
  TargetSource source;    ///< files and columns; `test`, `measure`, `loading` as in the options
  TargetOptions options;  ///< repairs, corrections, characteristics
};

/// Reads what a [[target]] or [target_defaults] says, apart from `files`, over what `block`
/// already holds: the table's keys replace those of the defaults one by one.
/// @param folder  where relative paths begin
/// @throws InputError naming file, line, key, value and rule
void read_target(const io::TomlTable& table, const std::string& folder, TargetBlock& block);

/// Checks that a target says where strain and stress come from, once each.
/// @param table  the [[target]], for the error line
/// @throws InputError naming the key that is missing or too much
void check_target(const io::TomlTable& table, const TargetSource& source);

}  // namespace plastica::calibrate
