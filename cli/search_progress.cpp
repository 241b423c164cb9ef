#include "cli/search_progress.hpp"

#include <fmt/format.h>

namespace plastica::cli {

void SearchProgress::update(const calibrate::SceneFitProgress& progress) {
  if (line_.is_due()) line_.draw(line(progress, line_.seconds()));
}

std::string SearchProgress::line(const calibrate::SceneFitProgress& progress, double seconds) {
  const double fraction =
      progress.total > 0 ? static_cast<double>(progress.done) / progress.total : 1;
  std::string text = fmt::format("fitting, {} {} {}/{}, {} runs", progress.stage,
                                 bar_text(fraction), progress.done, progress.total, progress.runs);
  if (seconds > 0.0) text += fmt::format(", {:.3g}/s", progress.runs / seconds);
  return text;
}

}  // namespace plastica::cli
