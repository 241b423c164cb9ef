#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/io/result_file.hpp"

namespace plastica::calibrate {

/// The attributes `schema` and `version` of a result file's root.
inline constexpr std::string_view kSceneFitSchema = "plastica/scene-fits";
inline constexpr int kSceneFitVersion = 11;
inline constexpr int kOldestSceneFit = 3;  ///< that is read

/// What a file of fits through scenes holds.
struct SceneFitContents {
  std::vector<SceneFitRecord> records;
  double confidence = 0.95;           ///< of the intervals, within (0, 1)
  std::vector<io::InputText> inputs;  ///< the fit file, its scenes, tables
  io::RunMeta meta;
  /// Of `run_id`: the same for two runs of the same bits. Empty in files of older versions.
  std::string run{};
};

/// Writes a result file (HDF5; layout: docs/hdf5.md). The records are stored in the order of
/// their names and laws, so that the same contents give the same bytes outside /meta whatever the
/// order in which they come; targets keep theirs. The file appears under its name when it is
/// complete, in place of what is there if that is allowed.
///
/// The records must have names of their own, or laws of their own beside the same name, a weight
/// for each target, either no targets or one for each target and under its name, ordinates and
/// fitted values (or none) for each abscissa.
/// @throws io::StorageError if it cannot be written; std::logic_error if the records are not so
void write_scene_fit_store(const std::string& path, const SceneFitContents& contents,
                           io::Overwrite overwrite = io::Overwrite::Allowed);

/// Puts records in the order in which a file has them: of their names, then of their laws.
void put_in_order(std::vector<SceneFitRecord>& records);

/// Reads a result file: every field of every record, bit by bit, in the order of the names
/// and laws. A noise that is a NaN comes back empty.
/// @throws InputError if it is no such file, of another version, or not complete
SceneFitContents read_scene_fit_store(const std::string& path);

}  // namespace plastica::calibrate
