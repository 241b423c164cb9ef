#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plastica::calibrate {

/// The files that a pattern with *, ?, [a-z] or {a,b} matches, sorted by name; empty if none does.
/// A link that leads nowhere is among them, so that it is missed; folders, pipes and devices are
/// not.
/// @param folder  where a relative pattern begins; empty: the working directory
std::vector<std::string> find_files(const std::string& folder, const std::string& pattern);

/// Why the braces of a pattern are too many to be tried out: each pair multiplies the patterns that
/// it stands for; empty if they are not.
std::string too_many_braces(std::string_view pattern);

/// The pattern that matches one file alone, whatever characters its name has.
std::string literal_pattern(const std::string& path);

}  // namespace plastica::calibrate
