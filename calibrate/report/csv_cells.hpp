#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "calibrate/report/described.hpp"

/// What CSV files of results are made of; not installed.
namespace plastica::calibrate::report {

/// A number with all its digits; nothing where there is none, or it is not finite.
std::string cell_of(std::optional<double> value);

/// Adds the titles of entries, with their units: "runs [1]"; behind a prefix "fit.yield_stress
/// [Pa]" of what is called "value", "fit.yield_stress.lower [Pa]" of others.
/// @param own_units  see kOwnUnits
void add_titles(std::vector<std::string>& header, const std::vector<Entry>& entries,
                const std::string& prefix = {}, std::string_view own_units = {});
/// Adds their values: empty where there is none.
void add_cells(std::vector<std::string>& cells, const std::vector<Entry>& entries);

/// One line, each cell in quotes if it needs them.
void put_row(std::ostream& out, const std::vector<std::string>& cells);

}  // namespace plastica::calibrate::report
