#pragma once

#include <string>

#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/report/ink.hpp"

/// The parts of a report that say how much to trust the numbers; not installed.
namespace plastica::calibrate::report {

/// What noise, sampling and segments do to each parameter, side by side as standard errors; empty
/// if nothing was fitted.
std::string errors_text(const SceneFitRecord& record, const plastica::report::Ink& ink);

/// The values with half, once and twice the segments, and what they lead to; empty if the fit was
/// not repeated.
std::string segments_text(const SceneFitRecord& record, const plastica::report::Ink& ink);

}  // namespace plastica::calibrate::report
