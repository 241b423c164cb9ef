#pragma once

#include <span>

#include "calibrate/inference/mean_interval.hpp"
#include "calibrate/report/json_values.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

/// Parts of pages about several specimens, and about the targets of fits through scenes; not
/// installed.
namespace plastica::calibrate::report {

/// Adds a picture of each parameter over the groups, every specimen a point beside mean and
/// deviation, the specimens that are out of line, and a table of all groups' statistics.
/// @param records  of one law; the page's details are in their order
/// @param draws    how intervals of means are found
void add_groups(Json& blocks, std::span<const FitRecord> records, const SpecimenDraws& draws);

/// Adds the picture of the fits' values with mean and deviation, where there are several.
void add_population(Json& blocks, std::span<const SceneFitRecord> records);

/// Adds measured and fitted curves of all targets, what the fit leaves of them, and what its
/// searches, and other segments, came to.
void add_scene_figures(Json& blocks, const SceneFitRecord& record);

}  // namespace plastica::calibrate::report
