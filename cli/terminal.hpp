#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// What the terminals are like that the program writes to.
namespace plastica::cli {

/// Whether a stream is a terminal that shows colours, and the user wants any (the environment
/// variable NO_COLOR is not set, or empty; TERM is not "dumb").
bool has_color(int stream);

/// Columns of a terminal: as it says itself, else 80. >= 20
std::size_t width_of_terminal(int stream);

/// From now on what is written to a standard stream that is a terminal is put as that can show it:
/// - into ASCII where its locale has no UTF-8 (LANG=C), see `in_ascii`;
/// - of the standard output, whose reports are up to 100 columns wide, lines that are longer than a
///   narrower terminal are broken between two words, see `broken_line`; pictures of characters are
///   as wide as it (the environment variable COLUMNS, see plastica/report/picture.hpp).
/// Pipes and files get every byte as it is. To be called before anything is written.
void write_what_terminals_can_show();

/// Text in the letters of ASCII: "σ" as "s", "±" as "+-", what has no such letter as "?".
/// @param text  UTF-8; a letter that ends beyond it is left over. @return and how many bytes were
///              taken
struct AsciiText {
  std::string text;
  std::size_t taken = 0;
};
AsciiText in_ascii(std::string_view text);

/// A line in pieces of at most so many columns, a line end between them, broken at blanks where it
/// has any; those behind the first stand further in than it does. Colours take no column.
/// @param line  UTF-8, without a line end
/// @param width  >= 20
std::string broken_line(std::string_view line, std::size_t width);

}  // namespace plastica::cli
