#include "cli/chosen_segments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "calibrate/config/settle_segments.hpp"
#include "cli/exit_code.hpp"
#include "cli/search_progress.hpp"
#include "cli/tell.hpp"

namespace plastica::cli {
namespace {

/// "16 move yield_stress by 0.91 %"
std::string text_of(const calibrate::SegmentsTrial& trial) {
  if (!std::isfinite(trial.moved)) {
    return fmt::format("of {} it is not known ({})", trial.segments, trial.reason);
  }
  return fmt::format("{} move {} by {:.2g} %", trial.segments,
                     calibrate::last_part(trial.parameter), 100.0 * trial.moved);
}

}  // namespace

int take_chosen_segments(calibrate::SceneFitFile& file, const CalibrateArguments& arguments,
                         StopFlag stop) {
  SearchProgress line(arguments.quiet);
  calibrate::SceneFitHooks hooks;
  hooks.stop = stop;
  hooks.progress = [&line](const calibrate::SceneFitProgress& progress) { line.update(progress); };
  const calibrate::SettledSegments settled =
      calibrate::settle_segments(file, arguments.threads, hooks);
  line.clear();
  if (settled.found && (settled.trials.empty() || arguments.quiet)) return kDone;
  std::string text = settled.trials.empty() ? "segments: no number suits the scenes" : "";
  for (const calibrate::SegmentsTrial& trial : settled.trials) {
    text += (text.empty() ? "segments: " : ", ") + text_of(trial);
  }
  tell("{}{}\n", text,
       settled.found ? fmt::format(": {} taken", settled.trials.back().segments)
                     : fmt::format("; none found for fit.within = {:.3g} %",
                                   100.0 * file.options.segments_within));
  return settled.found ? kDone : kNotAcceptable;
}

}  // namespace plastica::cli
