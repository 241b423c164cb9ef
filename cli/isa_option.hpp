#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "plastica/model/scene.hpp"

namespace plastica::cli {

/// Adds `--isa` to a subcommand.
void add_isa_option(CLI::App& sub, std::string& isa);

/// Lets `--isa`, if it was given, take the place of what the file says.
/// @throws InputError if this processor does not have it
void take_isa(const std::string& isa, SolverOptions& options);

}  // namespace plastica::cli
