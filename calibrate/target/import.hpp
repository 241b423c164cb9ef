#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/csv.hpp"

namespace plastica::calibrate {

class KeptTables;

/// A column of a file of curves.
struct ColumnSource {
  /// Name or number (from 1). A `*` stands for any characters: every column that matches is a
  /// specimen of its own; only for stress or force.
  std::string column;
  std::optional<std::string> unit;  ///< empty: the file's own; a strain or pure number needs none
  SourceLocation where;             ///< of the user's words, for error lines
  double factor = 1.0;         ///< measured = factor x the specimen's, not 0: -1 in compression
  bool override_unit = false;  ///< `unit` goes before another one of the file
};

/// A value of each specimen: one for all, or a column of the table, or what an HDF5 file says of
/// it.
struct SpecimenValue {
  std::optional<double> value;  ///< [SI] for all specimens; else:
  std::string from;             ///< column of the table, or the name of an attribute
  std::optional<std::string> unit;
  SourceLocation where;
  bool override_unit = false;  ///< `unit` goes before another one of the table
};

/// A table beside the curves, one row a specimen.
struct TableSource {
  std::string file;
  std::string key;  ///< column that holds the stem of the curve's file
  io::CsvOptions csv;
  SourceLocation where;
};

/// What a `[[target]]` block says: where the curves are and what their columns mean.
struct TargetSource {
  std::vector<std::string> files;  ///< paths, wildcards already expanded
  SourceLocation where;            ///< of the block
  Test test = Test::Tension;
  std::optional<Measure> measure;  ///< of the columns, as measured; empty: engineering
  std::optional<Loading> loading;  ///< empty: found out per specimen

  // One of strain and elongation, one of stress and force; the latter of both in tension only.
  std::optional<ColumnSource> strain;
  std::optional<ColumnSource> elongation;
  std::optional<SpecimenValue> gauge_length;
  std::optional<ColumnSource> stress;
  std::optional<ColumnSource> force;
  std::optional<SpecimenValue> area;
  std::optional<SpecimenValue> strain_rate;  ///< of materials with a rate law [1/s]

  std::optional<TableSource> table;
  std::vector<std::string> group;  ///< as `SpecimenValue::from`, copied as text to Target::group
  /// Columns of the file whose values, together, are the same along one specimen and another for
  /// each; empty: a file is one specimen.
  std::vector<std::string> split;
  io::CsvOptions csv;
  std::shared_ptr<KeptTables> kept{};  ///< of its files, those that were read already

  /// Whether its columns may be of the true measure: strain and stress, in tension.
  bool may_be_true() const { return test == Test::Tension && !elongation && !force; }
  /// Whether something says values of each specimen: a table, or a file of HDF5.
  bool has_values() const;
  /// Whether it asks for what a table, or an HDF5 file, says of each specimen.
  bool asks_for_values() const;
};

/// Reads every specimen of a block and makes it a target; test, measure and loading of the block
/// go before those of the options.
///
/// A name is the file's stem, with ":COLUMN" where a pattern chose the column, with ":VALUE" where
/// the file is split, and with the folder before it where stems are alike. The table's key is the
/// stem, or the value. Of a workbook's sheet that is named, ":SHEET" follows the stem, and the key
/// is that or the sheet's name.
/// A strain that neither the block nor the file gives a unit is taken as a fraction; in tension,
/// above 1, the target gets a warning.
/// @param threads  that read files side by side, 0: as many as the machine has; changes nothing
/// @param spool  takes the curves, each as soon as its target is made; null: they stay in memory
/// @return a target per specimen in order of files and columns; one that cannot be read or
///         repaired, or lacks a column or the unit of its stress, is Rejected with its reason
/// @throws InputError for a block that contradicts itself, a file that is missing, a column that
///         the table or every readable file lacks (so too a unit that the block does not give, or
///         that does not fit), a unit in the block that does not fit
std::vector<Target> import_targets(const TargetSource& source, const TargetOptions& options = {},
                                   int threads = 0,
                                   const std::shared_ptr<CurveSpool>& spool = nullptr);

}  // namespace plastica::calibrate
