#include "cli/chosen_segments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "calibrate/fit/choose_segments.hpp"
#include "cli/exit_code.hpp"
#include "cli/search_progress.hpp"
#include "cli/tell.hpp"
#include "plastica/io/toml_edit.hpp"

namespace plastica::cli {
namespace {

using calibrate::SegmentsTrial;

std::vector<SegmentsTrial> tried(const calibrate::SceneFitFile& file,
                                 const CalibrateArguments& arguments, StopFlag stop) {
  SearchProgress line(arguments.quiet);
  calibrate::SceneFitOptions options = file.options;
  options.threads = arguments.threads;
  options.hooks.stop = stop;
  options.hooks.progress = [&line](const calibrate::SceneFitProgress& progress) {
    line.update(progress);
  };
  std::vector<SegmentsTrial> trials =
      calibrate::choose_segments(file.cases.front().targets, options, file.options.segments_within);
  line.clear();
  return trials;
}

/// "16 move yield_stress by 0.91 %"
std::string text_of(const SegmentsTrial& trial) {
  if (!std::isfinite(trial.moved)) {
    return fmt::format("of {} it is not known ({})", trial.segments, trial.reason);
  }
  return fmt::format("{} move {} by {:.2g} %", trial.segments,
                     calibrate::last_part(trial.parameter), 100.0 * trial.moved);
}

}  // namespace

int take_chosen_segments(calibrate::SceneFitFile& file, const CalibrateArguments& arguments,
                         StopFlag stop) {
  if (!file.chooses_segments) return kDone;
  const std::vector<SegmentsTrial> trials = tried(file, arguments, stop);
  const double within = file.options.segments_within;
  const bool found = !trials.empty() && trials.back().moved <= within;
  if (!arguments.quiet || !found) {
    std::string text;
    for (const SegmentsTrial& trial : trials) {
      text += (text.empty() ? "segments: " : ", ") + text_of(trial);
    }
    tell("{}{}\n", text,
         found ? fmt::format(": {} taken", trials.back().segments)
               : fmt::format("; none found for fit.within = {:.3g} %", 100.0 * within));
  }
  if (!found) return kNotAcceptable;
  const int segments = trials.back().segments;
  for (calibrate::SceneFitCase& one : file.cases) calibrate::set_segments(segments, one.targets);
  io::InputText& text = file.inputs.front();
  text.text = io::set_toml_value(text.text, "fit.segments", fmt::format("{}", segments));
  return kDone;
}

}  // namespace plastica::cli
