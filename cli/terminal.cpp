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
#include <string>
#include <utility>

#include <langinfo.h>

#ifdef __GLIBCXX__
#include <ext/stdio_sync_filebuf.h>
#endif

namespace plastica::cli {
namespace {

/// Letters of reports. Greek ones keep their width, so that columns stay below their heads.
constexpr std::array<std::pair<std::string_view, std::string_view>, 30> kLetters{{
    {"…", ".."}, {"±", "+-"}, {"ε", "e"},  {"ɛ", "e"}, {"σ", "s"},   {"τ", "t"},   {"γ", "g"},
    {"δ", "d"},  {"µ", "u"},  {"μ", "u"},  {"°", "d"}, {"²", "2"},   {"³", "3"},   {"⁰", "0"},
    {"¹", "1"},  {"⁴", "4"},  {"⁵", "5"},  {"⁶", "6"}, {"⁷", "7"},   {"⁸", "8"},   {"⁹", "9"},
    {"⁻", "-"},  {"−", "-"},  {"–", "-"},  {"×", "x"}, {"·", "."},   {"≤", "<="},  {"≥", ">="},
    {"ä", "a"},  {"é", "e"},
}};

/// Bytes of the letter that begins with a byte.
std::size_t length_of_letter(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xf0) return 4;
  return first >= 0xe0 ? 3 : 2;
}

bool is_terminal(int stream) { return ::isatty(stream) != 0; }

#ifdef __GLIBC__

/// A stream of letters to a file descriptor; letters that are not whole yet wait for the next write.
struct AsciiStream {
  int descriptor = -1;
  std::string waiting{};
};

ssize_t write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0) return written;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

ssize_t write_ascii(void* cookie, const char* bytes, std::size_t size) {
  auto& stream = *static_cast<AsciiStream*>(cookie);
  stream.waiting.append(bytes, size);
  const AsciiText ascii = in_ascii(stream.waiting);
  stream.waiting.erase(0, ascii.taken);
  // 0 bytes written is how such a stream says that it failed.
  return write_all(stream.descriptor, ascii.text) < 0 ? 0 : static_cast<ssize_t>(size);
}

void put_into_ascii(FILE*& file, int descriptor, int buffering) {
  static std::array<AsciiStream, 2> streams;
  AsciiStream& stream = streams[descriptor == STDOUT_FILENO ? 0 : 1];
  stream.descriptor = descriptor;
  FILE* filtered = ::fopencookie(&stream, "w", {nullptr, write_ascii, nullptr, nullptr});
  if (filtered == nullptr) return;  // bytes as they are, as before
  std::setvbuf(filtered, nullptr, buffering, BUFSIZ);
  file = filtered;
#ifdef __GLIBCXX__
  // std::cout goes on with the stream that there was.
  if (descriptor == STDOUT_FILENO) {
    static __gnu_cxx::stdio_sync_filebuf<char> buffer(filtered);
    std::cout.rdbuf(&buffer);
  }
#endif
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

std::size_t width_of_terminal(int stream) {
  winsize size{};
  const bool known = ::ioctl(stream, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return std::max<std::size_t>(20, known ? size.ws_col : 80);
}

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

void write_what_terminals_can_show() {
#ifdef __GLIBC__
  if (!is_terminal(STDOUT_FILENO) && !is_terminal(STDERR_FILENO)) return;
  // Only letters: numbers are written with a point wherever.
  std::setlocale(LC_CTYPE, "");
  const bool has_utf8 = std::string_view(::nl_langinfo(CODESET)) == "UTF-8";
  std::setlocale(LC_CTYPE, "C");
  if (has_utf8) return;
  if (is_terminal(STDOUT_FILENO)) put_into_ascii(stdout, STDOUT_FILENO, _IOLBF);
  if (is_terminal(STDERR_FILENO)) put_into_ascii(stderr, STDERR_FILENO, _IONBF);
#endif
}

}  // namespace plastica::cli
