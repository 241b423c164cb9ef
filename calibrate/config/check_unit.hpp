#pragma once

#include <string_view>

#include "calibrate/target/import.hpp"
#include "plastica/base/quantity.hpp"
#include "plastica/io/csv.hpp"

namespace plastica::calibrate {

/// The unit of a column must stand in its option or in the file, unless it needs none.
/// @throws InputError that says what to write
void check_unit(const io::CsvTable& table, const ColumnSource& column, Dimension dimension,
                std::string_view option);

}  // namespace plastica::calibrate
