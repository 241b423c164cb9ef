#pragma once

#include "calibrate/target/options.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {

/// Reads the table `plausible` of a target: the bounds of plausibility.hpp, the material that the
/// specimen is of, and whether what lies beyond them is fitted.
/// @throws InputError naming file, line, key, value and rule
void read_plausible(const io::TomlTable& table, TargetOptions& options);

}  // namespace plastica::calibrate
