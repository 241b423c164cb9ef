#pragma once

#include "calibrate/result/result.hpp"
#include "plastica/report/scene_figure.hpp"

namespace plastica::calibrate::report {

/// A specimen's curve as it was read, corrected and fitted, with the window of the modulus, the
/// proof stress, the yield point and the break; below it what the fit leaves; not installed.
/// @param with_raw  whether the curve as it was read is drawn where it is another
plastica::report::Figure specimen_figure(const FitRecord& record, bool with_raw = true);

}  // namespace plastica::calibrate::report
