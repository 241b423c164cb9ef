#include "cli/progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace plastica::cli {

ProgressBar::ProgressBar(std::string what, std::size_t total, bool quiet)
    : what_(std::move(what)), total_(total), line_(quiet) {}

void ProgressBar::update(std::size_t done, std::size_t failed, std::size_t resumed) {
  if (done < total_ && !line_.is_due()) return;
  line_.draw(line(what_, done, failed, resumed, total_, line_.seconds()));
}

std::string ProgressBar::line(const std::string& what, std::size_t done, std::size_t failed,
                              std::size_t resumed, std::size_t total, double seconds) {
  const double fraction =
      total == 0 ? 1.0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
  const double rate = seconds > 0.0 ? static_cast<double>(done - resumed) / seconds : 0.0;
  std::string text = fmt::format("{} {} {}/{}, {} failed, {:.3g}/s", what, bar_text(fraction), done,
                                 total, failed, rate);
  if (rate > 0.0 && done < total) {
    text += ", " + time_left(static_cast<double>(total - done) / rate) + " left";
  }
  return text;
}

}  // namespace plastica::cli
