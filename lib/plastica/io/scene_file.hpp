#pragma once

#include <span>
#include <string>
#include <string_view>

#include "plastica/io/toml.hpp"
#include "plastica/model/field.hpp"

namespace plastica::io {

/// What a scene file says.
struct SceneFile {
  std::string path;  ///< as the user gave it
  std::string text;
  Setup setup;
};

/// Reads a scene file: the tables [material], [section], [beam], [rules], [solver], [drive] with
/// the fields of the field table, and
/// - `name`, the scene's name, by default the file's stem;
/// - `material = "S355"`, or `name = "S355"` in [material]: a named material, the base that the
///   other keys of [material] change;
/// - `drive.strain`, one of
///     [0, "1 %", "2 %"]                                          the samples,
///     { table = "path.csv", column = "Strain", unit = "%" }      a column, relative to the file,
///     { turning_points = ["2 %", "-1 %"], points_between = 50 }  straight ways from 0 over these
///   (50 samples between two turning points by default);
/// - [[probe]] with `name` and `quantity` (see `probe_quantities`); the stress by default.
/// @throws InputError for the first thing that is wrong, keys that nobody knows included
SceneFile read_scene_file(const std::string& path);
/// @param name  stands for the file in errors; its folder is where relative paths begin
SceneFile parse_scene_file(std::string text, std::string name);

/// Reads the tables [material], [section], [beam], [rules] and [solver] of any file into a setup;
/// what the file does not say stays as it is. A new field needs no change here.
/// @throws InputError as above, but leaves unknown keys to `TomlTable::check_unused`
void read_setup(const TomlTable& root, Setup& setup);

/// The words for what a probe records, in the order of ProbeQuantity.
std::span<const std::string_view> probe_quantities();

}  // namespace plastica::io
