#include "cli/frame_progress.hpp"

#include <fmt/format.h>

namespace plastica::cli {

void FrameProgress::update(std::size_t done) {
  if (line_.is_due()) line_.draw(line(done, total_, line_.seconds()));
}

std::string FrameProgress::line(std::size_t done, std::size_t total, double seconds) {
  const double fraction = total == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(total);
  std::string text = fmt::format("frames {} {}/{}", bar_text(fraction), done, total);
  if (!(seconds > 0.0) || done == 0) return text;
  const double rate = static_cast<double>(done) / seconds;
  if (done < total) text += ", " + time_left(static_cast<double>(total - done) / rate) + " left";
  return text + fmt::format(", {:.3g}/s", rate);
}

}  // namespace plastica::cli
