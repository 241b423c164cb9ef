#pragma once

#include <string>
#include <string_view>

namespace plastica::io {

/// Starts gnuplot (no shell, no settings of the user's), feeds it a script and waits for its end.
///
/// @param script   gnuplot commands; the picture goes to standard output, so no `set output`
/// @param program  name or path of the program, searched on the PATH
/// @return what gnuplot wrote to standard output: the picture
/// @throws MachineError if the program is missing, fails (with its first message) or draws nothing
std::string run_gnuplot(std::string_view script, const std::string& program = "gnuplot");

/// A text as a gnuplot string in single quotes, in which gnuplot replaces nothing. Line ends and
/// other control characters, which would end the command, become blanks.
std::string gnuplot_string(std::string_view text);

}  // namespace plastica::io
