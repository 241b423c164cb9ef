#pragma once

#include "calibrate/inference/intervals.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {

/// Reads the keys of [fit] that ask for intervals: profile, bootstrap, bootstrap_block,
/// bootstrap_specimens. @throws InputError naming file, line, key, value and rule
void read_intervals(const io::TomlTable& fit, IntervalOptions& intervals);

}  // namespace plastica::calibrate
