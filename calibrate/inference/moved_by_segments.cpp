#include "calibrate/inference/moved_by_segments.hpp"

#include <cmath>
#include <limits>

namespace plastica::calibrate {

SegmentsTrial moved_by_segments(const SceneFitResult& result) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  SegmentsTrial trial;
  if (!result.segments) {
    return {.moved = kUnknown,
            .reason = result.reason.empty() ? "the fit was not repeated" : result.reason};
  }
  trial.segments = result.segments->segments;
  trial.moved = -1.0;
  for (std::size_t i = 0; i < result.segments->parameters.size(); ++i) {
    const FittedParameter& parameter = result.parameters[i];
    if (parameter.at_bound() || !std::isfinite(parameter.noise_error)) continue;
    const SegmentsError& error = result.segments->parameters[i];
    const bool known = error.trend != SegmentsTrend::Unknown && std::isfinite(error.error);
    const double moved = known ? error.error / std::abs(parameter.value) : kUnknown;
    if (!(moved > trial.moved)) continue;
    trial.moved = moved;
    trial.parameter = parameter.path;
  }
  if (trial.moved < 0.0) {
    trial.moved = kUnknown;
    trial.reason = "no parameter is identified";
  } else if (!std::isfinite(trial.moved)) {
    trial.reason =
        result.segments->note.empty() ? "a repetition ended at a bound" : result.segments->note;
  }
  return trial;
}

}  // namespace plastica::calibrate
