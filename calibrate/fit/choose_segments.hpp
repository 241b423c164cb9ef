#pragma once

#include <span>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/inference/moved_by_segments.hpp"

namespace plastica::calibrate {

/// Gives every beam among the targets a number of segments; coupons stay.
/// @throws InputError for a beam whose segments' lengths are given one by one, or a place by the
///         number of a segment
void set_segments(int segments, std::vector<WeightedTarget>& targets);

/// Finds the fewest segments that move no value of a fit by more than a fraction of it.
///
/// The first trial has the fewest segments that can be halved, and the whole search of the options;
/// each further one begins at the values of the one before. From an error e of order p follow the
/// next: (e/within)^(1/p) times as many, 1.25 to 4 times. A trial is a fit that is repeated with
/// half and twice the segments, so that the last one's error is measured and not foretold.
/// @param options  their intervals and laws are not used, nor does `segments_error` matter
/// @param within  > 0
/// @return the trials; the last one's segments do if its `moved` is at most `within`, else none of
///         1 024 does
/// @throws InputError as `fit`, if no target is a beam, or as `set_segments`; FitInterrupted
std::vector<SegmentsTrial> choose_segments(std::span<const WeightedTarget> targets,
                                           const SceneFitOptions& options, double within);

}  // namespace plastica::calibrate
