#pragma once

#include <span>
#include <string>

#include "calibrate/report/plot.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/report/scene_figure.hpp"

/// Pictures of the laws of a comparison; not installed.
namespace plastica::calibrate::report {

using plastica::report::Figure;

/// Two panels per target: what was measured and what each law makes of it, and below how far off
/// each is.
/// @param name  of the target, or of the fit through scenes; empty: the first
/// @throws InputError where no laws are compared, for a name that is not there, and if no law was
///         fitted
Figure laws_figure(std::span<const FitRecord> records, const std::string& name);
Figure laws_figure(std::span<const SceneFitRecord> records, const std::string& name);

/// Refuses a law beside the picture that has all of them. @throws InputError
void refuse_law(const PlotRequest& request);

}  // namespace plastica::calibrate::report
