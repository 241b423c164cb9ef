#pragma once

#include <span>
#include <string>

#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// The summary of fits through scenes for scripts: one JSON object in SI units, `{"fits": [{"name",
/// "status", "parameters", "intervals", "targets", "correlation", "starts", …}], "population": {…},
/// "counts": {…}}`; what the population's numbers are says scene_population.hpp. What a fit does
/// not have is null, so is every number that is not finite. The order of the keys is fixed. Bytes
/// of a user's text that are not UTF-8 become question marks.
/// @param confidence  of the population's intervals
/// @param indent  blanks per level; negative: all in one line
std::string scene_fits_json(std::span<const SceneFitRecord> records, double confidence = 0.95,
                            int indent = 2);

}  // namespace plastica::calibrate
