#include "cli/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace plastica::cli {

using std::chrono::steady_clock;

ProgressBar::ProgressBar(std::string what, std::size_t total, bool quiet)
    : what_(std::move(what)),
      total_(total),
      shown_(!quiet && isatty(STDERR_FILENO) != 0),
      start_(steady_clock::now()),
      last_(start_) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::clear() {
  if (drawn_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

void ProgressBar::update(std::size_t done, std::size_t failed) {
  if (!shown_) return;
  const auto now = steady_clock::now();
  if (drawn_ && done < total_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  drawn_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "\r{}\033[K", line(what_, done, failed, total_, seconds));
  std::fflush(stderr);
}

std::string ProgressBar::line(const std::string& what, std::size_t done, std::size_t failed,
                              std::size_t total, double seconds) {
  constexpr std::size_t kWidth = 24;
  const std::size_t filled = total == 0 ? kWidth : kWidth * done / total;
  const double rate = seconds > 0.0 ? static_cast<double>(done) / seconds : 0.0;
  std::string text = fmt::format("{} [{:#<{}}{:.<{}}] {}/{}, {} failed, {:.3g}/s", what, "", filled,
                                 "", kWidth - filled, done, total, failed, rate);
  if (rate > 0.0 && done < total) {
    const auto left = static_cast<long>(std::ceil(static_cast<double>(total - done) / rate));
    text += fmt::format(", {}:{:02}:{:02} left", left / 3600, left / 60 % 60, left % 60);
  }
  return text;
}

}  // namespace plastica::cli
