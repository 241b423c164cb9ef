#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/fit/result.hpp"

namespace plastica::calibrate {

/// The attributes `schema` and `version` of a result file's root.
inline constexpr std::string_view kFitStoreSchema = "plastica/fits";
inline constexpr int kFitStoreVersion = 1;

/// A file that the run was told by, whole.
struct InputText {
  std::string name;  ///< without its folder: "al6061.toml"
  std::string text;
};

/// All that may differ between two runs of the same fits; stored under /meta alone.
struct RunMeta {
  std::string start_time;  ///< UTC, "2024-05-31T12:00:00Z"
  double seconds = 0.0;    ///< [s], of the whole run
  std::string host;
  int threads = 0;
  std::string instruction_set;
  std::string command_line;
  int resumptions = 0;  ///< how often the run was interrupted and resumed
  /// Names and versions: {"plastica", "0.1.0"}, {"hdf5", …}, {"nlopt", …}.
  std::vector<std::pair<std::string, std::string>> versions;
};

/// The meta of a run that begins now on this machine: time, host, instruction set and the version
/// of Plastica are filled in.
/// @param threads  0: as many as the machine has
RunMeta begin_meta(std::string command_line, int threads);

/// What a result file holds. Summaries of groups are derived from it and are not stored.
struct FitStoreContents {
  std::vector<FitRecord> records;
  std::vector<InputText> inputs;  ///< the fit file, tables
  /// What the fits were told. Where in a file a parameter stood (`Parameter::where`) is not stored.
  FitOptions options;
  RunMeta meta;
};

/// Checks where a result is to be written, before anything is computed.
/// @param force  whether a file that is there may be overwritten
/// @throws InputError if it exists already, or its folder is missing or cannot be written to
void check_output_path(const std::string& path, bool force);

/// Writes a result file (HDF5; layout: data/README.md). The records are stored in the order of
/// their targets' names, so that the same contents give the same bytes outside /meta whatever the
/// order in which they come. The file appears under its name when it is whole; what is there
/// already is replaced.
///
/// The records must have names of their own, curves with as many stresses as strains, and either
/// no parameters or those of the options, in their order. A fit that is not Fitted has no cost and
/// no misfit.
/// @throws io::StorageError if it cannot be written; std::logic_error if the records are not so
void write_fit_store(const std::string& path, const FitStoreContents& contents);

/// Reads a result file: every field of every record, bit by bit, in the order of the names. An
/// optional that holds a NaN comes back empty.
/// @throws InputError if it is no such file, of another version, or not whole
FitStoreContents read_fit_store(const std::string& path);

}  // namespace plastica::calibrate
