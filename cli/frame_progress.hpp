#pragma once

#include <cstddef>
#include <string>

#include "cli/terminal_line.hpp"

namespace plastica::cli {

/// A line on stderr that tells how many frames of a scene are written: part of all, remaining time,
/// rate.
class FrameProgress {
 public:
  /// @param total  frames of the scene
  /// @param quiet  never show anything
  FrameProgress(std::size_t total, bool quiet) : total_(total), line_(quiet) {}

  /// Redraws at most ten times a second. @param done  frames that are written
  void update(std::size_t done);

  /// Wipes the line, so that other output starts at the left margin.
  void clear() { line_.clear(); }

  /// The line's text, without the terminal's codes. The rate is last: a narrow terminal cuts it
  /// off.
  /// @param seconds since the start
  static std::string line(std::size_t done, std::size_t total, double seconds);

 private:
  std::size_t total_;
  TerminalLine line_;
};

}  // namespace plastica::cli
