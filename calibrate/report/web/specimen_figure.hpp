#pragma once

#include "calibrate/result/result.hpp"
#include "plastica/report/scene_figure.hpp"

namespace plastica::calibrate::report {

/// A specimen's curve as it was read, corrected and fitted, with the window of the modulus, the
/// proof stress, the yield point and the break; below it what the fit leaves; not installed.
plastica::report::Figure specimen_figure(const FitRecord& record);

}  // namespace plastica::calibrate::report
