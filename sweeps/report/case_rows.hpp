#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sweeps/store/sweep_record.hpp"

/// The table of a sweep's cases, said once for all that print it; not installed.
namespace plastica::sweeps {

struct CaseColumn {
  std::string name;
  std::string unit{};  ///< empty: none
  bool words = false;  ///< else numbers
};

/// The cases of a group of refinement, or all cases where nothing refines.
struct CaseBlock {
  std::string label;                           ///< what tells the group apart; may be empty
  std::vector<std::vector<std::string>> rows;  ///< a cell a column
  std::vector<std::string> notes;              ///< order, extrapolated value, and the like
};

struct CaseRows {
  std::vector<CaseColumn> columns;  ///< the last one, of remarks, has no name
  std::vector<CaseBlock> blocks;
  std::size_t left_out = 0;  ///< cases beyond those that were asked for
};

/// @param max_cases  rows end after that many in all; 0: never
CaseRows case_rows(const SweepRecord& record, std::size_t max_cases);

/// What was swept, in lines: "NAME: 14 cases, 14 completed", then the scene, then what is compared.
std::vector<std::string> what_was_swept(const SweepRecord& record);
/// The same, then what is to be said of the errors, then warnings.
std::vector<std::string> head_lines(const SweepRecord& record);

/// What stands behind a case that is not as it should be; empty for others.
std::string remark_of(const SweepRecord& record, std::size_t index);

/// The word of files for a level: "planar".
std::string level_word(Level level);

/// A fraction as a number of percent: "0.4472".
std::string percent_text(double fraction);

/// The unit as tables show it: none for pure numbers.
std::string shown_unit_of(std::string_view unit);

/// Numbers of the axes that take more than one value.
std::vector<std::size_t> varied_axes(const SweepRecord& record);

/// Whether an axis moves with the refined one, or is it.
bool moves_with_refined(const SweepRecord& record, std::size_t axis);

}  // namespace plastica::sweeps
