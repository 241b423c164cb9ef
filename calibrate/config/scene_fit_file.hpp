#pragma once

#include <string>
#include <vector>

#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {

/// A fit file whose targets name scenes; docs/file-formats.md lists its keys.
struct SceneFitFile {
  std::string path;                     ///< as the user gave it
  std::vector<io::InputText> inputs;    ///< the fit file, then its scenes, each once
  std::vector<std::string> read_files;  ///< all that was read, for those who must not write there
  SceneFitOptions options;
  std::vector<SceneFitCase> cases;
  /// `segments = "auto"`: all beams are to have what `choose_segments` finds for
  /// `options.segments_within` (`settle_segments`).
  bool chooses_segments = false;
  std::vector<std::string> notes{};  ///< old names in the files, each with the new one
};

/// Whether any target of a fit file names a scene.
bool names_scenes(const std::string& path);

/// Reads a fit file, its scenes and its measured curves.
/// @throws InputError naming file, line, key, value and rule, for the first thing that is wrong
SceneFitFile read_scene_fit_file(const std::string& path);
SceneFitFile parse_scene_fit_file(std::string text, const std::string& path);

/// Tells bad input of any fit before the first one runs, with the laws that the file's options
/// compare. @throws InputError
void check_fits(const SceneFitFile& file);

}  // namespace plastica::calibrate
