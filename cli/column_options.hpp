#pragma once

#include "calibrate/config/bare_files.hpp"
#include "cli/command.hpp"

namespace plastica::cli {

/// Adds the options that say which columns of a file hold strain and stress.
void add_column_options(CLI::App& sub, calibrate::BareFiles& bare, const char* group);

}  // namespace plastica::cli
