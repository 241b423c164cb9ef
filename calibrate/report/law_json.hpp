#pragma once

#include <span>

#include "calibrate/report/json_values.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate::report {

/// The comparison of laws of each target and of all, for JSON summaries; not installed. Times are
/// left out: a summary has the same bytes in each run.
Json laws_json(std::span<const FitRecord> records);
Json laws_json(std::span<const SceneFitRecord> records);

}  // namespace plastica::calibrate::report
