#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/guess/column_numbers.hpp"
#include "calibrate/guess/column_role.hpp"
#include "plastica/io/csv.hpp"

namespace plastica::calibrate {

using ColumnIndex = std::optional<std::size_t>;

/// The columns of a file that are taken for its curves.
struct ChosenColumns {
  /// Deformation and load, one pair; more of specimens side by side. Empty where none is known.
  std::vector<std::pair<ColumnIndex, ColumnIndex>> pairs;
  std::vector<std::string> notes;  ///< which others may be meant, and what does not go together
};

/// Chooses by what the columns are and how their numbers run: first those that vary, then what was
/// measured before what was wanted of the machine or taken out of the curve, what a name says
/// before what a unit says; a strain, an elongation, travel; a stress, a force; a deformation of
/// the load's sign; engineering measures, and a load of the deformation's measure.
/// @param deformation  column that the user names; empty: to be chosen. So is the load.
ChosenColumns choose_columns(const io::CsvTable& table, const std::vector<ColumnMeaning>& columns,
                             ColumnIndex deformation, ColumnIndex load);

}  // namespace plastica::calibrate
