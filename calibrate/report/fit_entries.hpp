#pragma once

#include <vector>

#include "calibrate/report/described.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

/// What JSON summaries and CSV tables say of fits besides lists and parameters; not installed.
namespace plastica::calibrate::report {

/// Of a fit, the same beginning and end for all kinds. @param record  null: the names alone
std::vector<Entry> fit_entries(const FitRecord* record);
std::vector<Entry> fit_entries(const SceneFitRecord* record);

/// Of a target of a fit through scenes and of what the fit made of it.
/// @param of  which of the fit's it is. @param record  null: the names alone
std::vector<Entry> target_entries(const SceneFitRecord* record, std::size_t of);

}  // namespace plastica::calibrate::report
