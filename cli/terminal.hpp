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

/// Where a standard stream is a terminal whose locale has no UTF-8 (LANG=C), all that is written to
/// it is put into ASCII from now on, see `in_ascii`. Pipes and files get every byte as it is.
/// To be called before anything is written.
void write_what_terminals_can_show();

/// Text in the letters of ASCII: "σ" as "s", "±" as "+-", what has no such letter as "?".
/// @param text  UTF-8; a letter that ends beyond it is left over. @return and how many bytes were
///              taken
struct AsciiText {
  std::string text;
  std::size_t taken = 0;
};
AsciiText in_ascii(std::string_view text);

}  // namespace plastica::cli
