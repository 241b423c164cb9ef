#pragma once

#include <string>
#include <string_view>

namespace plastica::io {

/// Refuses a TOML text whose tables and lists are nested too deep to be walked through: by a key of
/// many names, "a.a.a.…", by a header of such, or by brackets.
///
/// What is not TOML may pass; its first error is the parser's to report.
/// @param text  without byte order mark
/// @throws InputError with the line
void check_toml_depth(std::string_view text, const std::string& file);

}  // namespace plastica::io
