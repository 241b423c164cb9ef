#pragma once

#include "calibrate/fit/options.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {

/// Reads [fit] and the tables of the setup ([material], [section], [rules], ...) of a fit file.
/// @throws InputError naming file, line, key, value and rule; leaves unknown keys to
///         `TomlTable::check_unused`
FitOptions read_fit_options(const io::TomlTable& root);

}  // namespace plastica::calibrate
