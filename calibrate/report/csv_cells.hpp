#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

/// What CSV files of results are made of; not installed.
namespace plastica::calibrate::report {

/// A number with all its digits; nothing where there is none, or it is not finite.
std::string cell_of(std::optional<double> value);

/// One line, each cell in quotes if it needs them.
void put_row(std::ostream& out, const std::vector<std::string>& cells);

}  // namespace plastica::calibrate::report
