#pragma once

#include <string>

#include "calibrate/result/scene_fit_result.hpp"

namespace plastica::calibrate {

/// What a number of segments does to the values of a fit.
struct SegmentsTrial {
  int segments = 0;  ///< of every beam
  /// How far the values are off those of a continuous beam at the most, over each (`SegmentsError`)
  /// [1]; infinite where that is not known.
  double moved = 0.0;
  std::string parameter{};  ///< path of the one that is moved the most
  std::string reason{};     ///< why it is not known
};

/// What the segments do to the values of a fit. A parameter at a bound, or of which the curves say
/// nothing, has no value that they could move.
SegmentsTrial moved_by_segments(const SceneFitResult& result);

}  // namespace plastica::calibrate
