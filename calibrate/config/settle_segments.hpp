#pragma once

#include <vector>

#include "calibrate/config/scene_fit_file.hpp"
#include "calibrate/inference/moved_by_segments.hpp"

namespace plastica::calibrate {

/// What was tried for the segments of a fit file.
struct SettledSegments {
  bool found = true;  ///< false: no number moves the values by as little as is asked for
  std::vector<SegmentsTrial> trials{};  ///< none where the file leaves nothing to choose
};

/// Where a fit file leaves the number of segments open (`chooses_segments`), finds it by the first
/// of its fits, gives it to the beams of all, and writes it into the file's text, which results
/// keep; then nothing is open any more.
/// @param hooks  of the trial fits; what they keep is not used
/// @throws InputError as `choose_segments`; FitInterrupted
SettledSegments settle_segments(SceneFitFile& file, int threads, const SceneFitHooks& hooks);

}  // namespace plastica::calibrate
