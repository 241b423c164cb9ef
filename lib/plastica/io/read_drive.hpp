#pragma once

#include <string>
#include <vector>

#include "plastica/io/toml.hpp"

namespace plastica::io {

/// The strain history of [drive], see `read_scene_file`; not installed.
/// @param file  relative to whose folder tables are looked up
std::vector<double> read_strain(const TomlTable& drive, const std::string& file);

}  // namespace plastica::io
