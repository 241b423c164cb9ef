#pragma once

#include <chrono>
#include <string>

namespace plastica::cli {

/// A line on stderr that is drawn over and over.
///
/// Silent when stderr is no terminal, so that logs stay clean, but see `Style`. Not for several
/// threads at once.
class TerminalLine {
 public:
  /// @param quiet  never show anything
  explicit TerminalLine(bool quiet);
  ~TerminalLine();
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  enum class Style {
    Redrawn,
    Lines,   ///< where stderr is no terminal, a new line now and then: it may be passed on to one
    Silent,  ///< another process draws
  };
  /// Of all lines that are made from now on.
  static void set_style(Style style);

  /// Whether it is time to draw: at once, and then at most ten times a second; every ten seconds
  /// where each is a new line.
  bool is_due() const;
  void draw(const std::string& text);
  /// Wipes the line, so that other output starts at the left margin.
  void clear();
  double seconds() const;  ///< since it was made

 private:
  bool shown_;
  bool in_lines_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
};

/// "[######..................]", 24 wide. @param fraction  that is done, 0 … 1
std::string bar_text(double fraction);
/// "0:01:02", rounded up.
std::string time_left(double seconds);

}  // namespace plastica::cli
