#pragma once

#include <string>

#include "cli/terminal_line.hpp"

namespace plastica::cli {

/// A line on stderr that tells how far a motion is: part of its duration, rate, remaining time.
class MotionProgress {
 public:
  /// @param duration  of the motion [s], > 0
  /// @param quiet     never show anything
  MotionProgress(double duration, bool quiet) : duration_(duration), line_(quiet) {}

  /// Redraws at most ten times a second. @param time  of the motion [s]
  void update(double time);

  /// Wipes the line, so that other output starts at the left margin.
  void clear() { line_.clear(); }

  /// The line's text, without the terminal's codes. @param seconds since the start
  static std::string line(double time, double duration, double seconds);

 private:
  double duration_;
  TerminalLine line_;
};

}  // namespace plastica::cli
