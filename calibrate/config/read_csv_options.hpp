#pragma once

#include <string>

#include "plastica/io/csv.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {

/// A column's header, or its number from 1 on as text. @throws InputError
std::string column_name(const io::TomlValue& value);

/// The keys `separator`, `decimal` and `header` of a table that names a CSV file. @throws
/// InputError
void read_csv_options(const io::TomlTable& table, io::CsvOptions& csv);

}  // namespace plastica::calibrate
