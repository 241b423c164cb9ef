#pragma once

#include "calibrate/config/scene_fit_file.hpp"
#include "cli/calibrate_arguments.hpp"
#include "plastica/base/stop_flag.hpp"

namespace plastica::cli {

/// Where the fit file leaves the number of segments to us, finds it with the first of its fits,
/// gives it to all beams, writes it into the file's text that the result keeps, and says on stderr
/// what was tried.
/// @return exit code: 0 if there is a number, 1 if no number is within what was asked for
/// @throws InputError; calibrate::FitInterrupted
int take_chosen_segments(calibrate::SceneFitFile& file, const CalibrateArguments& arguments,
                         StopFlag stop);

}  // namespace plastica::cli
