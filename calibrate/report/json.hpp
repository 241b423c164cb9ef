#pragma once

#include <span>
#include <string>

#include "calibrate/fit/result.hpp"

namespace plastica::calibrate {

/// The summary of a batch for scripts: one JSON object in SI units,
/// `{"fits": [{"name", "status", "characteristics", "parameters", "objective", "evaluations", …}],
/// "groups": […], "counts": {…}}`. What a curve or a fit does not have is null, so is every number
/// that is not finite. The order of the keys is fixed. Bytes of a user's text that are not UTF-8
/// become question marks.
/// @param indent  blanks per level; negative: all in one line
std::string json_summary(std::span<const FitRecord> records, int indent = 2);

}  // namespace plastica::calibrate
