#pragma once

#include <string>
#include <string_view>

#include "calibrate/guess/guess_file.hpp"
#include "calibrate/target/import.hpp"

namespace plastica::calibrate {

/// A text as TOML writes it, in quotes.
std::string toml_string(std::string_view text);

/// The [[target]] of a fit file that says what a source says: what `plastica inspect` proposes,
/// and what curves on the command line stand for. Columns that are not set are left out.
std::string target_text(const TargetSource& source);

/// The same of a guess, with its comments, and a "?" for each thing that only the user knows: a run
/// refuses it by its line.
std::string target_text(const BlockGuess& block);

}  // namespace plastica::calibrate
