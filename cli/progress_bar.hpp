#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace plastica::cli {

/// A line on stderr that tells how far a batch is: done, failed, rate, remaining time.
///
/// Silent when stderr is no terminal, so that logs stay clean. Not for several threads at once.
class ProgressBar {
 public:
  /// @param quiet  never show anything
  ProgressBar(std::string what, std::size_t total, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Redraws at most ten times a second.
  void update(std::size_t done, std::size_t failed);

  /// Wipes the line, so that other output starts at the left margin.
  void clear();

  /// The line's text, without the terminal's codes. @param seconds since the start
  static std::string line(const std::string& what, std::size_t done, std::size_t failed,
                          std::size_t total, double seconds);

 private:
  std::string what_;
  std::size_t total_;
  bool shown_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace plastica::cli
