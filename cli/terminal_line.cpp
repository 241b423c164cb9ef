#include "cli/terminal_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "cli/terminal.hpp"
#include "plastica/report/format.hpp"

namespace plastica::cli {

using std::chrono::steady_clock;

namespace {

TerminalLine::Style style_of_all = TerminalLine::Style::Redrawn;

bool is_terminal() { return isatty(STDERR_FILENO) != 0; }

}  // namespace

TerminalLine::TerminalLine(bool quiet)
    : shown_(!quiet && style_of_all != Style::Silent &&
             (is_terminal() || style_of_all == Style::Lines)),
      in_lines_(!is_terminal()),
      start_(steady_clock::now()),
      last_(start_) {}

void TerminalLine::set_style(Style style) { style_of_all = style; }

TerminalLine::~TerminalLine() { clear(); }

bool TerminalLine::is_due() const {
  if (!shown_) return false;
  if (in_lines_) return steady_clock::now() - last_ >= std::chrono::seconds(10);
  return !drawn_ || steady_clock::now() - last_ >= std::chrono::milliseconds(100);
}

void TerminalLine::draw(const std::string& text) {
  if (!shown_ || (in_lines_ && !is_due())) return;
  last_ = steady_clock::now();
  if (in_lines_) {
    std::fputs((text + '\n').c_str(), stderr);
    return;
  }
  drawn_ = true;
  // A line that goes on in the next one would not be drawn over.
  const std::size_t width = width_of_terminal(STDERR_FILENO) - 2;
  std::fputs(fmt::format("\r{}\033[K", report::cut(text, width)).c_str(), stderr);
  std::fflush(stderr);
}

void TerminalLine::clear() {
  if (drawn_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

double TerminalLine::seconds() const {
  return std::chrono::duration<double>(steady_clock::now() - start_).count();
}

std::string bar_text(double fraction) {
  constexpr std::size_t kWidth = 24;
  const auto filled = static_cast<std::size_t>(std::floor(kWidth * fraction));
  return fmt::format("[{:#<{}}{:.<{}}]", "", filled, "", kWidth - filled);
}

std::string time_left(double seconds) {
  const auto left = static_cast<long>(std::ceil(seconds));
  return fmt::format("{}:{:02}:{:02}", left / 3600, left / 60 % 60, left % 60);
}

}  // namespace plastica::cli
