#pragma once

#include <span>

#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/report/scene_figure.hpp"

/// What the pictures of fits through scenes show; not installed.
namespace plastica::calibrate::report {

using plastica::report::Figure;
using plastica::report::PlotScript;

/// A panel per target: measured and fitted ordinate over the abscissa with bands of 95 % (not on a
/// terminal), the break marked.
Figure fit_figure(const SceneFitRecord& record, bool terminal);
/// A panel per target: measured minus fitted ordinate, and the noise on both sides of zero.
/// @throws InputError if nothing was fitted
Figure residuals_figure(const SceneFitRecord& record);
/// The costs of the searches in rising order. @throws InputError if none ended anywhere
Figure starts_figure(const SceneFitRecord& record);
/// A panel per parameter: its value over the length of the segments, and where that leads.
/// @throws InputError if the fit was not repeated with other segments
Figure segments_figure(const SceneFitRecord& record);
/// A panel per parameter: its value and interval in each fit, with mean and deviation.
/// @throws InputError if no fit determines any
Figure population_figure(std::span<const SceneFitRecord> records);

/// The correlations of a fit's parameters as a map with their numbers; for a terminal the numbers.
/// @throws InputError if it has none
PlotScript correlation_plot(const SceneFitRecord& record, bool terminal);

}  // namespace plastica::calibrate::report
