#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "calibrate/config/templates.hpp"

namespace plastica::sweeps {

/// What `plastica init` can begin besides fits and scenes: "sweep", "check".
std::span<const std::string_view> template_kinds();

/// The files that `plastica init KIND` writes side by side; they run as they are. The first is the
/// one to run:
///   sweep  sweep.toml and cantilever.toml, the scene that it varies;
///   check  check.toml and both of the above, which it is about.
/// @throws InputError for another kind
std::vector<calibrate::TemplateFile> template_files(std::string_view kind);

}  // namespace plastica::sweeps
