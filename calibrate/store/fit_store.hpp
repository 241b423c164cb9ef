#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "plastica/io/result_file.hpp"

namespace plastica::calibrate {

/// The attributes `schema` and `version` of a result file's root.
inline constexpr std::string_view kFitStoreSchema = "plastica/fits";
inline constexpr int kFitStoreVersion = 11;
inline constexpr int kOldestFitStore = 3;  ///< that is read

/// What a result file holds. Summaries of groups are derived from it and are not stored.
struct FitStoreContents {
  std::vector<FitRecord> records;
  std::vector<io::InputText> inputs;  ///< the fit file, tables
  /// What the fits were told. Where in a file a parameter stood (`Parameter::where`) is not stored.
  FitOptions options;
  io::RunMeta meta;
  /// Of `run_id`: the same for two runs of the same bits. Empty in files of older versions.
  std::string run{};
};

/// Writes a result file (HDF5; layout: docs/hdf5.md). The records are stored in the order of
/// their targets' names and laws, so that the same contents give the same bytes outside /meta
/// whatever the order in which they come. The file appears under its name when it is complete, in
/// place of what is there if that is allowed.
///
/// The records must have names of their own, or laws of their own beside the same name; curves with
/// as many stresses as strains (fitted ones that only count their samples are made again); and
/// either no parameters or those of the options (of their law), in their order. A fit that is not
/// Fitted has no cost and no misfit.
/// @throws io::StorageError if it cannot be written; std::logic_error if the records are not so
void write_fit_store(const std::string& path, const FitStoreContents& contents,
                     io::Overwrite overwrite = io::Overwrite::Allowed);

/// Puts records in the order in which a file has them: of their targets' names, then of their laws.
void put_in_order(std::vector<FitRecord>& records);

/// Reads a result file: every field of every record, bit by bit, in the order of the names. An
/// optional that holds a NaN comes back empty.
/// @param samples  Counted: all but curves and evaluations, where no laws are compared (their
///                 comparison asks for curves)
/// @throws InputError if it is no such file, of another version, or not complete
FitStoreContents read_fit_store(const std::string& path, FitSamples samples = FitSamples::Read);

}  // namespace plastica::calibrate
