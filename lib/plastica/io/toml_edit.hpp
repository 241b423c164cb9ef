#pragma once

#include <string>
#include <string_view>

/// Changes of single values of a TOML text that leave the rest as it is written. A path names a
/// value from the top of the text, "beam.segments", through headers, dotted keys and inline tables
/// alike; "support[2].gap" goes through the second element of a list. Names are bare keys.
namespace plastica::io {

/// Whether a path leads to anything, a value or a table.
/// @throws InputError if the text is not TOML, or the path none
bool has_toml_key(std::string_view text, std::string_view path);

/// Sets the value of a path.
///
/// A value that is there is replaced where it stands. A key that is not there is added at the end
/// of its table: behind the last value below the header, inside the braces, or, for a table that
/// dotted keys made, as one more of these. A table that is not there is added with a header, before
/// the first list of tables or at the end. Comments, order, line ends and all other values stay.
/// @param text   TOML; lines may end in CR LF
/// @param value  as a TOML file has it: `32`, `"20 mm"`, `[1, 2]`
/// @return the text with the value
/// @throws InputError if the text is not TOML, the path or the value none, if the path leads to a
///         table that is not one in braces, through something that is no table, or to an element
///         that the list does not have
std::string set_toml_value(std::string_view text, std::string_view path, std::string_view value);

}  // namespace plastica::io
