#include "cli/tell.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <new>
#include <string_view>

#include "plastica/report/format.hpp"

namespace plastica::cli {

namespace {

std::atomic<bool> is_silent = false;

/// The lines with all control characters but their ends made harmless.
std::string shown(std::string_view lines) {
  std::string text;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    text += report::printable(lines.substr(0, end));
    if (end < lines.size()) text += '\n';
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return text;
}

}  // namespace

void be_silent(bool silent) { is_silent = silent; }

void tell(const std::string& lines) noexcept {
  if (is_silent) return;
  try {
    std::fputs(shown(lines).c_str(), stderr);
  } catch (const std::bad_alloc&) {
    std::fputs("out of memory\n", stderr);
  }
}

void tell_notes(std::span<const std::string> notes) {
  for (const std::string& note : notes) tell("plastica: {}\n", note);
}

void tell_of_damage() {
  tell("plastica: what is finished was kept in a file that is damaged: what is lost runs again\n");
}

void say(const std::string& lines) {
  if (!is_silent) fmt::print("{}", shown(lines));
}

void put(const std::string& text) {
  if (::isatty(STDOUT_FILENO) != 0) {
    say(text);
  } else {
    fmt::print("{}", text);
  }
}

void tell_of_full_files() { std::signal(SIGXFSZ, SIG_IGN); }

void open_closed_streams() {
  // open() gives the lowest number that is free. Opened the wrong way round, so that reading what
  // was closed, or writing to it, fails; but for the standard error, which nobody misses.
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    if (::open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY) != stream) return;
  }
}

}  // namespace plastica::cli
