#pragma once

#include <string>
#include <string_view>

namespace plastica::io {

/// Refuses what the parser must not be given, in one scan of a text:
/// - tables and lists nested too deep to be traversed by recursion: by a key of many names,
///   "a.a.a.…", by a header of such, or by brackets;
/// - a character beyond ASCII outside of strings and comments, a quote amid a word, a header
///   without a name, and a bracket that another one closes: no TOML, which toml++ asserts not to
///   meet.
///
/// What else is not TOML passes; it is the parser's to report.
/// @param text  without byte order mark
/// @throws InputError with the line
void scan_toml(std::string_view text, const std::string& file);

}  // namespace plastica::io
