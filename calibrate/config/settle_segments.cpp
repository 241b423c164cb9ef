#include "calibrate/config/settle_segments.hpp"

#include <string>

#include "calibrate/fit/choose_segments.hpp"
#include "plastica/io/toml_edit.hpp"

namespace plastica::calibrate {

SettledSegments settle_segments(SceneFitFile& file, int threads, const SceneFitHooks& hooks) {
  if (!file.chooses_segments) return {};
  SceneFitOptions options = file.options;
  options.threads = threads;
  options.hooks = hooks;
  SettledSegments settled;
  settled.trials =
      choose_segments(file.cases.front().targets, options, file.options.segments_within);
  settled.found =
      !settled.trials.empty() && settled.trials.back().moved <= file.options.segments_within;
  if (!settled.found) return settled;
  const int segments = settled.trials.back().segments;
  for (SceneFitCase& one : file.cases) set_segments(segments, one.targets);
  io::InputText& text = file.inputs.front();
  text.text = io::set_toml_value(text.text, "fit.segments", std::to_string(segments));
  file.chooses_segments = false;
  return settled;
}

}  // namespace plastica::calibrate
