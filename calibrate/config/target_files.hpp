#pragma once

#include <string>
#include <vector>

#include "plastica/io/toml.hpp"

namespace plastica::calibrate {

/// The files that the patterns in a target's key `files` match, each once.
/// @param folder  where relative patterns begin
/// @throws InputError for a pattern that matches none, or one that an earlier one has
std::vector<std::string> target_files(const io::TomlTable& table, const std::string& folder);

}  // namespace plastica::calibrate
