#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "plastica/io/csv.hpp"

namespace plastica::calibrate {

/// How often a deformation begins anew: rows at which it falls below a tenth of what it reached
/// since the last such row. A cycle that is unloaded does so as well.
std::vector<std::size_t> restarts_of(std::span<const double> deformation);

/// The columns whose values tell specimens apart that stand one under the other: each is the same
/// down to where the deformation begins anew, and together they differ from run to run. The fewest
/// that do, those with names such as "specimen" or "id" first; empty if there are none.
/// @param deformation  of all rows (n_rows)
/// @param taken  columns that hold something else
/// @return their numbers, from 0
std::vector<std::size_t> find_split(const io::CsvTable& table, std::span<const double> deformation,
                                    const std::vector<std::size_t>& taken);

}  // namespace plastica::calibrate
