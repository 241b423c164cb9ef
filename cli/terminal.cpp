#include "cli/terminal.hpp"

#include <sys/ioctl.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

#include "cli/launched.hpp"
#include "plastica/report/ink.hpp"

#include <langinfo.h>

#ifdef __GLIBCXX__
#include <ext/stdio_sync_filebuf.h>
#endif

namespace plastica::cli {
namespace {

/// Letters of reports. Greek ones keep their width, so that columns stay below their heads.
constexpr std::array<std::pair<std::string_view, std::string_view>, 30> kLetters{{
    {"…", ".."}, {"±", "+-"}, {"ε", "e"},  {"ɛ", "e"},  {"σ", "s"}, {"τ", "t"},
    {"γ", "g"},  {"δ", "d"},  {"µ", "u"},  {"μ", "u"},  {"°", "d"}, {"²", "2"},
    {"³", "3"},  {"⁰", "0"},  {"¹", "1"},  {"⁴", "4"},  {"⁵", "5"}, {"⁶", "6"},
    {"⁷", "7"},  {"⁸", "8"},  {"⁹", "9"},  {"⁻", "-"},  {"−", "-"}, {"–", "-"},
    {"×", "x"},  {"·", "."},  {"≤", "<="}, {"≥", ">="}, {"ä", "a"}, {"é", "e"},
}};

/// Bytes of the letter that begins with a byte.
std::size_t length_of_letter(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xf0) return 4;
  return first >= 0xe0 ? 3 : 2;
}

/// Columns of a text: its letters without colours.
std::size_t columns_of(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\033') {
      at = std::min(text.find('m', at), text.size() - 1) + 1;
      continue;
    }
    at += length_of_letter(static_cast<unsigned char>(text[at]));
    ++columns;
  }
  return columns;
}

bool is_terminal(int stream) { return ::isatty(stream) != 0; }

/// None where the terminal does not say.
std::optional<std::size_t> known_width(int stream) {
  winsize size{};
  if (::ioctl(stream, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return std::max<std::size_t>(20, size.ws_col);
}

#ifdef __GLIBC__

/// A stream to a terminal; what is not a whole letter, or a whole line, waits for what follows.
struct TerminalStream {
  int descriptor = -1;
  bool ascii = false;
  std::size_t width = 0;  ///< at which lines are broken; 0: nowhere
  std::string bytes{};    ///< of a letter that is not whole
  std::string line{};     ///< that has not ended
};

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// The letters of the bytes so far.
std::string take_letters(TerminalStream& stream) {
  if (!stream.ascii) return std::exchange(stream.bytes, {});
  const AsciiText ascii = in_ascii(stream.bytes);
  stream.bytes.erase(0, ascii.taken);
  return ascii.text;
}

ssize_t write_shown(void* cookie, const char* bytes, std::size_t size) {
  auto& stream = *static_cast<TerminalStream*>(cookie);
  stream.bytes.append(bytes, size);
  std::string text = take_letters(stream);
  if (stream.width > 0) {
    stream.line += std::exchange(text, {});
    for (std::size_t end = stream.line.find('\n'); end != stream.line.npos;
         end = stream.line.find('\n')) {
      text += broken_line(std::string_view(stream.line).substr(0, end), stream.width) + '\n';
      stream.line.erase(0, end + 1);
    }
  }
  // 0 bytes written is how such a stream says that it failed.
  return write_all(stream.descriptor, text) ? static_cast<ssize_t>(size) : 0;
}

/// Of the standard output and the standard error.
std::array<TerminalStream, 2> streams;

void show_on_terminal(FILE*& file, TerminalStream stream, int buffering) {
  TerminalStream& kept = streams[stream.descriptor == STDOUT_FILENO ? 0 : 1];
  kept = std::move(stream);
  FILE* filtered = ::fopencookie(&kept, "w", {nullptr, write_shown, nullptr, nullptr});
  if (filtered == nullptr) return;  // bytes as they are, as before
  std::setvbuf(filtered, nullptr, buffering, BUFSIZ);
  file = filtered;
#ifdef __GLIBCXX__
  // std::cout goes on with the stream that there was.
  if (kept.descriptor == STDOUT_FILENO) {
    static __gnu_cxx::stdio_sync_filebuf<char> buffer(filtered);
    std::cout.rdbuf(&buffer);
  }
#endif
}

/// What has no line end by the end of the program.
void write_rest() {
  std::fflush(stdout);
  for (const TerminalStream& stream : streams) write_all(stream.descriptor, stream.line);
}

#endif

}  // namespace

bool has_color(int stream) {
  const auto value_of = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string_view(value == nullptr ? "" : value);
  };
  return is_terminal(stream) && value_of("NO_COLOR").empty() && value_of("TERM") != "dumb";
}

std::size_t width_of_terminal(int stream) { return known_width(stream).value_or(80); }

AsciiText in_ascii(std::string_view text) {
  AsciiText ascii;
  while (ascii.taken < text.size()) {
    const std::size_t length = length_of_letter(static_cast<unsigned char>(text[ascii.taken]));
    if (ascii.taken + length > text.size()) break;
    const std::string_view letter = text.substr(ascii.taken, length);
    const auto* known =
        std::ranges::find(kLetters, letter, [](const auto& pair) { return pair.first; });
    if (length == 1) {
      ascii.text += letter;
    } else {
      ascii.text += known == kLetters.end() ? "?" : known->second;
    }
    ascii.taken += length;
  }
  return ascii;
}

std::string broken_line(std::string_view line, std::size_t width) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  const std::string further(std::min(indent + 4, width / 2), ' ');
  std::string text;
  std::string piece;        // of the line, not longer than the terminal is wide
  std::size_t columns = 0;  // of the piece
  std::size_t begins = 0;   // in the piece, where its words begin
  std::size_t blank = 0;    // behind the last blank between two words; 0: none
  for (std::size_t at = 0; at < line.size();) {
    if (line[at] == '\033') {
      const std::size_t end = std::min(line.find('m', at), line.size() - 1);
      piece += line.substr(at, end + 1 - at);
      at = end + 1;
      continue;
    }
    const std::size_t length =
        std::min(length_of_letter(static_cast<unsigned char>(line[at])), line.size() - at);
    if (columns == width) {
      const bool ends_word = line[at] == ' ';
      const std::size_t cut = blank > begins && !ends_word ? blank : piece.size();
      const std::string rest = piece.substr(cut);
      piece.erase(std::min(piece.find_last_not_of(' ', cut - 1) + 1, cut));
      text += piece + '\n';
      piece = further + rest;
      begins = further.size();
      columns = begins + columns_of(rest);
      blank = 0;
      if (ends_word) {
        at += length;
        continue;
      }
    }
    piece += line.substr(at, length);
    ++columns;
    if (line[at] == ' ' && piece.size() > std::max(begins, indent) + 1) blank = piece.size();
    at += length;
  }
  return text + piece;
}

void write_what_terminals_can_show() {
#ifdef __GLIBC__
  // mpirun makes terminals for what it passes on, wherever that goes.
  if (launched()) return;
  if (!is_terminal(STDOUT_FILENO) && !is_terminal(STDERR_FILENO)) return;
  // Only letters: numbers are written with a point wherever.
  std::setlocale(LC_CTYPE, "");
  const bool has_utf8 = std::string_view(::nl_langinfo(CODESET)) == "UTF-8";
  std::setlocale(LC_CTYPE, "C");
  const std::size_t width = known_width(STDOUT_FILENO).value_or(report::kWidth);
  const bool narrow = is_terminal(STDOUT_FILENO) && width < report::kWidth;
  if (narrow && width < 80) ::setenv("COLUMNS", std::to_string(width).c_str(), 1);
  if (is_terminal(STDOUT_FILENO) && (narrow || !has_utf8)) {
    show_on_terminal(stdout, {STDOUT_FILENO, !has_utf8, narrow ? width : 0}, _IOLBF);
    std::atexit(write_rest);
  }
  if (is_terminal(STDERR_FILENO) && !has_utf8) {
    show_on_terminal(stderr, {STDERR_FILENO, true}, _IONBF);
  }
#endif
}

}  // namespace plastica::cli
