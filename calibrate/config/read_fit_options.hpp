#pragma once

#include <vector>

#include "calibrate/fit/options.hpp"
#include "plastica/io/toml.hpp"

namespace plastica::calibrate {

/// Reads [fit] and the tables of the setup ([material], [section], [rules], ...) of a fit file.
/// @throws InputError naming file, line, key, value and rule; leaves unknown keys to
///         `TomlTable::check_unused`
FitOptions read_fit_options(const io::TomlTable& root);

/// The laws that a fit compares, in their order. @throws InputError for none, one that is none or
/// comes twice
std::vector<Law> read_laws(const io::TomlValue& value);

}  // namespace plastica::calibrate
