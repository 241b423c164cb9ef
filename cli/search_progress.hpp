#pragma once

#include <string>

#include "calibrate/fit/scene_fit_hooks.hpp"
#include "cli/terminal_line.hpp"

namespace plastica::cli {

/// A line on stderr that tells how far a lone fit through scenes is: stage, searches, runs.
class SearchProgress {
 public:
  /// @param quiet  never show anything
  explicit SearchProgress(bool quiet) : line_(quiet) {}

  /// Redraws at most ten times a second.
  void update(const calibrate::SceneFitProgress& progress);

  /// Wipes the line, so that other output starts at the left margin.
  void clear() { line_.clear(); }

  /// The line's text, without the terminal's codes. @param seconds since the start
  static std::string line(const calibrate::SceneFitProgress& progress, double seconds);

 private:
  TerminalLine line_;
};

}  // namespace plastica::cli
