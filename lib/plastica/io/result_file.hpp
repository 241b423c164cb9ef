#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/io/hdf5.hpp"
#include "plastica/model/field.hpp"

/// What all result files have in common, whatever they hold: schema and version, the inputs, the
/// setup, and /meta, the only part that may differ between two runs of the same.
namespace plastica::io {

/// A file that the run was told by, whole.
struct InputText {
  std::string name;  ///< without its folder: "al6061.toml"
  std::string text;
};

/// The group of all that may differ between two runs of the same.
inline constexpr std::string_view kMetaGroup = "meta";
/// The group of a scene's surface, by VTK's specification: it says for ParaView what the rest says.
inline constexpr std::string_view kVtkGroup = "VTKHDF";
/// The attribute of the root that says who the run is: see `write_run_id`.
inline constexpr std::string_view kRunAttribute = "run";

/// All that may differ between two runs of the same; stored under /meta alone.
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

/// The meta of a run that begins now on this machine: time, host, instruction set and the versions
/// of Plastica and HDF5 are filled in.
/// @param threads  0: as many as the machine has
RunMeta begin_meta(std::string command_line, int threads);

/// Checks where a result is to be written, before anything is computed.
/// @param force  whether a file that is there may be overwritten
/// @throws InputError if it is "-", exists already, is a folder, link, device or pipe, or its
///         folder is missing or cannot be written to
void check_output_path(const std::string& path, bool force);

/// The attribute `schema` of a result file: "plastica/fits".
/// @throws InputError if it is no HDF5 file, or has none
std::string schema_of(const std::string& path);

/// The words of files for how a run ended, in the order of Status.
std::span<const std::string_view> status_words();

/// Marks a new file with its schema.
void write_schema(Hdf5Group& root, std::string_view schema, int version);
/// @throws InputError if the file has another schema, or another version of it
void check_schema(const Hdf5Group& root, std::string_view schema, int version);
/// The same of a reader that knows several versions. @return the file's
int check_schema(const Hdf5Group& root, std::string_view schema, int oldest, int newest);

/// The attribute `run`: who the run is, the same for two runs of the same bits. Nothing is written
/// of an empty one, as nothing is there in files of older versions.
void write_run_id(Hdf5Group& root, const std::string& id);
std::string read_run_id(const Hdf5Group& root);

void write_inputs(Hdf5Group& root, const std::vector<InputText>& inputs);
std::vector<InputText> read_inputs(const Hdf5Group& root);

/// Written last: what differs in it moves nothing else.
void write_meta(Hdf5Group& root, const RunMeta& meta);
RunMeta read_meta(const Hdf5Group& root);

/// A value for each field of the scene and the solver, with its unit: `material.yield_stress` as
/// `setup/material/yield_stress`; an optional one that is not set is NaN.
void write_setup(Hdf5Group& options, const Setup& setup);
/// @throws InputError if something is missing or out of a field's range
void read_setup(const Hdf5Group& options, Setup& setup);

}  // namespace plastica::io
