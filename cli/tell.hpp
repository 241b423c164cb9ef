#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <utility>

namespace plastica::cli {

/// Writes lines to the standard error, as `report::printable` shows them. What the user cannot be
/// told (the stream is closed or full) must not end a run whose result is complete: nothing is
/// thrown.
void tell(const std::string& lines) noexcept;

template <typename... Arguments>
void tell(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  tell(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Whether `tell` and `say` of this process say nothing: another one speaks for it.
void be_silent(bool silent);

/// Tells the old names that files have, each with the new one.
void tell_notes(std::span<const std::string> notes);

/// Says that what a journal has lost by damage runs again.
void tell_of_damage();

/// Writes lines to the standard output, as `report::printable` shows them: for text that has names
/// of the user in it.
void say(const std::string& lines);

template <typename... Arguments>
void say(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  say(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Writes a table or a text for programs to the standard output: as it is, but harmless where that
/// is a terminal.
void put(const std::string& text);

/// Gives the standard streams that the caller has closed something to stand on. Otherwise the
/// first files that a run opens would take their numbers, and what is meant for the terminal would
/// go into them. Writing to a standard output that was closed fails, as it should.
void open_closed_streams();

/// A file that may grow no further (`ulimit -f`) is an error that is told, not the program's end.
void tell_of_full_files();

}  // namespace plastica::cli
