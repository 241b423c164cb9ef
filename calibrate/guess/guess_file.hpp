#pragma once

#include <string>
#include <utility>
#include <vector>

#include "calibrate/guess/column_role.hpp"
#include "calibrate/target/import.hpp"

namespace plastica::calibrate {

/// A `[[target]]` that is proposed for a file.
struct BlockGuess {
  TargetSource source;
  /// What is said of a key, behind its line: "strain", "area", …
  std::vector<std::pair<std::string, std::string>> comments;
  /// Keys that only the user knows: "area", "gauge_length", "stress", "strain" (their columns), or
  /// "stress.unit", … (their units).
  std::vector<std::string> missing;
};

/// What a file of curves holds, as its names, units and numbers show.
struct FileGuess {
  std::vector<ColumnMeaning> columns;  ///< of each column
  std::vector<BlockGuess> blocks;      ///< one; more where specimens stand side by side
  /// What else the user should know: other columns that may be meant, specimens that cannot be
  /// told apart.
  std::vector<std::string> notes;
};

/// Proposes columns, units, geometry and specimens of a bare file of curves.
///
/// Of several columns the first of the best kind is taken: a strain before an elongation by an
/// extensometer, this before crosshead travel; a stress before a force; engineering measures before
/// true ones. A stress or strain that is negative throughout is turned (factor -1). Without names
/// the first column that is no clock is the strain, and the next one the stress.
/// @param given  columns and values that the user names are kept
FileGuess guess_file(const io::CsvTable& table, const TargetSource& given = {});

}  // namespace plastica::calibrate
