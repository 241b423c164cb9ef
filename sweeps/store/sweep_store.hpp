#pragma once

#include <string>
#include <string_view>

#include "sweeps/run/sweep_run.hpp"
#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

/// The attributes `schema` and `version` of the root of a sweep's file.
inline constexpr std::string_view kSweepSchema = "plastica/sweep";
inline constexpr int kSweepVersion = 3;
/// The oldest that is read: without references of curves (2), and without joints that broke and
/// what errors lack (3), which is told by their axes.
inline constexpr int kOldestSweepVersion = 1;
/// The column that says who a case is: see `CaseTable::id`.
inline constexpr std::string_view kCaseIds = "/cases/id";

/// Writes the result file of a sweep (HDF5; layout: docs/hdf5.md). The same record gives the
/// same bytes outside /meta. The file appears under its name when it is complete,
/// in place of what is there if that is allowed.
/// @throws io::StorageError if it cannot be written
void write_sweep_store(const std::string& path, const SweepRecord& record,
                       io::Overwrite overwrite = io::Overwrite::Allowed);

/// Reads such a file, every number bit by bit.
/// @throws InputError if it is no such file, of another version, or not complete
SweepRecord read_sweep_store(const std::string& path);

/// The results in such a file by the ids of their cases.
/// @throws InputError as above
EarlierResults earlier_results(const std::string& path);

}  // namespace plastica::sweeps
