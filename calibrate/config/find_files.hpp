#pragma once

#include <string>
#include <vector>

namespace plastica::calibrate {

/// The files that a pattern with *, ?, [a-z] or {a,b} matches, sorted by name; empty if none does.
/// @param folder  where a relative pattern begins; empty: the working directory
std::vector<std::string> find_files(const std::string& folder, const std::string& pattern);

/// The pattern that matches one file alone, whatever characters its name has.
std::string literal_pattern(const std::string& path);

}  // namespace plastica::calibrate
