#include "cli/motion_progress.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plastica::cli {

void MotionProgress::update(double time) {
  if (line_.is_due()) line_.draw(line(time, duration_, line_.seconds()));
}

std::string MotionProgress::line(double time, double duration, double seconds) {
  const double fraction = std::clamp(time / duration, 0.0, 1.0);
  std::string text = fmt::format("simulating {} {:.1f} %, {:.3g} of {:.3g} s", bar_text(fraction),
                                 100.0 * fraction, time, duration);
  if (!(seconds > 0.0) || !(time > 0.0)) return text;
  const double rate = time / seconds;
  text += fmt::format(", {:.3g} s/s", rate);
  if (fraction < 1.0) text += ", " + time_left((duration - time) / rate) + " left";
  return text;
}

}  // namespace plastica::cli
