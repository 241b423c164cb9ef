#pragma once

#include <string>
#include <string_view>

#include "calibrate/target/import.hpp"

namespace plastica::calibrate {

/// A text as TOML writes it, in quotes.
std::string toml_string(std::string_view text);

/// The [[target]] of a fit file that says what a source says: what `plastica inspect` proposes,
/// and what curves on the command line stand for. Columns that are not set are left out.
std::string target_text(const TargetSource& source);

}  // namespace plastica::calibrate
