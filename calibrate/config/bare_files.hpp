#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibrate/config/fit_file.hpp"

namespace plastica::calibrate {

/// Curves named on the command line, and what its options say of them.
///
/// A column is "NAME", "NAME:UNIT" or "NUMBER:UNIT"; the unit stands after the last colon, so a
/// name that has colons itself ends with one more. What is not given is guessed from each file.
struct BareFiles {
  std::vector<std::string> files;
  std::optional<std::string> strain;        ///< --strain COLUMN[:UNIT]
  std::optional<std::string> elongation;    ///< --elongation COLUMN[:UNIT]
  std::optional<std::string> gauge_length;  ///< --gauge-length "50 mm", or a column of the table
  std::optional<std::string> stress;        ///< --stress COLUMN[:UNIT]
  std::optional<std::string> force;         ///< --load COLUMN[:UNIT]
  std::optional<std::string> area;          ///< --area "120 mm^2", or a column of the table
  std::optional<std::string> decimal;       ///< --decimal "." or ","
  std::optional<std::string> sheet;         ///< --sheet NAME, of workbooks
  std::optional<std::string> path;          ///< --path PATTERN, of HDF5 files
  bool override_unit = false;               ///< --override-unit
  std::optional<std::string> test;          ///< --test tension|bending|torsion
  std::optional<std::string> measure;       ///< --measure engineering|true
  std::optional<std::string> table;         ///< --table FILE:KEY
  std::vector<std::string> group;           ///< --group COLUMN, as often as wanted
  std::vector<std::string> fixed;           ///< --fix NAME=VALUE, as often as wanted
  /// What a fit file says besides [[target]], in place of `fixed`; empty: the default parameters.
  std::string says;
};

/// What the options say of columns, values, table and test, without files.
/// @throws InputError naming the option, value and rule
TargetSource source_of(const BareFiles& bare);

/// The fit file that the command line stands for; its text can be kept and run again in the same
/// folder. Files of the same columns make one [[target]]. Parameters are the default ones; those of
/// --fix are fixed. A file that cannot be read stands in the first [[target]], whose import rejects
/// it; it is an error here if all of them are so. Its notes say what was guessed and may be wrong.
/// @param threads  that read files side by side, 0: as many as the machine has; changes nothing
/// @throws InputError naming the option (or file), value and rule
FitFile fit_of_bare_files(const BareFiles& bare, int threads = 0);

}  // namespace plastica::calibrate
