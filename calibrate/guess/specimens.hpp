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

/// Columns whose values tell specimens apart.
struct FoundSplit {
  std::vector<std::size_t> columns;  ///< from 0; empty: none do
  std::size_t parts = 0;             ///< that they make of the rows
  std::size_t untold = 0;            ///< how often the deformation begins anew within a part
  bool tells_all() const;
};

/// The columns whose values tell specimens apart that stand one under the other: each is the same
/// down to where the deformation begins anew, and together they differ from run to run. The fewest
/// that tell most of them, those with names such as "specimen" or "id" first; others, such as a
/// temperature, only if they tell all. A column with an empty cell, and one that counts stages of a
/// test ("Cycle", "Step"), is none.
/// @param deformation  of all rows (n_rows)
/// @param taken  columns that hold something else
FoundSplit find_split(const io::CsvTable& table, std::span<const double> deformation,
                      const std::vector<std::size_t>& taken);

}  // namespace plastica::calibrate
