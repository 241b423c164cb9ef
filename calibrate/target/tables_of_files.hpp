#pragma once

#include <memory>
#include <string>
#include <vector>

#include "calibrate/target/import.hpp"
#include "plastica/base/check.hpp"
#include "plastica/io/hdf5_tables.hpp"

/// Which tables a block's files have; not installed.
namespace plastica::calibrate {

/// A table of curves: a file, or a table of an HDF5 file.
struct TableOfFile {
  std::string file;
  std::string path{};  ///< of the table; empty: the file is the table
  /// Of the HDF5 file; null: it is opened anew, since few files may be open at once.
  std::shared_ptr<const io::Hdf5Tables> tables{};
  std::string within{};  ///< its path; empty where the whole file is the table
  std::string key{};     ///< of its row beside the curves: its path …
  std::string last{};    ///< … or its last name; empty where another specimen has it, too
  std::shared_ptr<const InputError> lacking{};  ///< why there is no table
};

/// The tables of a block's files, in order. Where an HDF5 file cannot be read, its reading says
/// why, and a path that matches none of its tables is that file's error alone.
std::vector<TableOfFile> tables_of(const TargetSource& source);

}  // namespace plastica::calibrate
