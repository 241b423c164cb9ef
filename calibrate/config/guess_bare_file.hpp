#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/target/import.hpp"
#include "calibrate/target/kept_tables.hpp"
#include "plastica/base/check.hpp"

/// What the columns of files mean that no fit file describes; not installed.
namespace plastica::calibrate {

/// What a user must not overlook of guesses, and of which files.
struct GuessNote {
  std::string words;
  std::string file;  ///< the first
  std::size_t files = 1;
};

/// Adds a note; one that is known already counts its files.
void add_note(const GuessNote& note, std::vector<GuessNote>& notes);

/// What a file is taken for, or why not.
struct GuessedFile {
  TargetSource source;
  std::vector<GuessNote> notes;
  std::optional<InputError> unreadable;  ///< its import rejects it
  std::optional<InputError> wrong;       ///< no fit can begin
};

/// Completes what the options say by what the columns of a file are called.
/// @param given  what the options say
/// @param kept   takes its table, for the import
GuessedFile guess_bare_file(const std::string& file, const TargetSource& given, KeptTables& kept);

}  // namespace plastica::calibrate
