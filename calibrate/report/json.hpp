#pragma once

#include <span>
#include <string>

#include "calibrate/report/summary.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// The summary of fits for scripts: one JSON object in SI units, `{"fits": [{"name", "status",
/// "parameters", "correlation", "evaluations", …}], "groups": […], "counts": {…}}`; a fit has
/// "intervals" where profile or bootstrap were asked for. What a curve or a fit does not have is
/// null, so is every number that is not finite. The order of the keys is fixed. Bytes of a user's
/// text that are not UTF-8 become question marks.
/// @param indent  blanks per level; negative: all in one line
/// @param draws  where there are any, a parameter of a group has "mean_standard_error" and
/// "mean_interval"
std::string json_summary(std::span<const FitRecord> records, int indent = 2,
                         const SpecimenDraws& draws = {});

/// The same of fits through scenes, with "targets" and "starts", and a "population" in place of
/// groups; what its numbers are says scene_population.hpp.
/// @param confidence  of the population's intervals
std::string json_summary(std::span<const SceneFitRecord> records, double confidence = 0.95,
                         int indent = 2);

}  // namespace plastica::calibrate
