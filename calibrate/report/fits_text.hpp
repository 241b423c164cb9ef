#pragma once

#include <string>
#include <vector>

#include "calibrate/report/text.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// The report of all fits of a file: the comparison of laws, if there is one, then the fits of the
/// law that is advised; of a single specimen its whole report.
/// @param records  put into another order where laws are compared
/// @param all  the whole report of each fit, and of all that there are
std::string fits_text(std::vector<FitRecord>& records, ReportOptions options, bool all = false);
std::string fits_text(std::vector<SceneFitRecord>& records, ReportOptions options,
                      bool all = false);

}  // namespace plastica::calibrate
