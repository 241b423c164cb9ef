#pragma once

#include <cstddef>
#include <string>

#include "cli/terminal_line.hpp"

namespace plastica::cli {

/// A line on stderr that tells how far a batch is: done, failed, rate, remaining time.
class ProgressBar {
 public:
  /// @param quiet  never show anything
  ProgressBar(std::string what, std::size_t total, bool quiet);

  void set_total(std::size_t total) { total_ = total; }

  /// Redraws at most ten times a second, and at the end.
  /// @param resumed  of the done: from an earlier run, so that they took no time
  void update(std::size_t done, std::size_t failed, std::size_t resumed = 0);

  /// Wipes the line, so that other output starts at the left margin.
  void clear() { line_.clear(); }

  /// The line's text, without the terminal's codes. @param seconds since the start
  static std::string line(const std::string& what, std::size_t done, std::size_t failed,
                          std::size_t resumed, std::size_t total, double seconds);

 private:
  std::string what_;
  std::size_t total_;
  TerminalLine line_;
};

}  // namespace plastica::cli
