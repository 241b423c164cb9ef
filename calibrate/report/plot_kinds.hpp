#pragma once

#include <cstddef>
#include <span>

#include "calibrate/report/plot_data.hpp"
#include "calibrate/result/result.hpp"

namespace plastica::calibrate::report {

/// One specimen: measured and fitted curve, yield and break marked, parameters in the title.
/// @throws InputError if it has no curve
PlotScript curve_plot(const FitRecord& record);
/// The same as characters, for a terminal of 80 columns and 24 lines.
PlotScript curve_terminal(const FitRecord& record);

/// The batch: a panel per group with all its curves, their mean, the fits and the breaks.
/// @throws InputError if no specimen has a curve that can be drawn
PlotScript overview_plot(std::span<const FitRecord> records);
/// The same as characters: the mean of each group, of a single one the mean of the fits, too.
PlotScript overview_terminal(std::span<const FitRecord> records);

/// The free parameters: a panel each, every specimen a point above its group, with mean and
/// standard deviation. @throws InputError if nothing was fitted
PlotScript parameters_plot(std::span<const FitRecord> records);
/// The same as characters, without the errors; the panels one below the other.
PlotScript parameters_terminal(std::span<const FitRecord> records);

}  // namespace plastica::calibrate::report
