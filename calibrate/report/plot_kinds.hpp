#pragma once

#include <cstddef>
#include <span>

#include "calibrate/fit/result.hpp"
#include "calibrate/report/plot_data.hpp"

namespace plastica::calibrate::report {

/// One specimen: measured and fitted curve, yield and break marked, parameters in the title.
PlotScript curve_plot(const FitRecord& record);

/// The batch: a panel per group with all its curves, their mean, the fits and the breaks.
PlotScript overview_plot(std::span<const FitRecord> records);

/// The free parameters: a panel each, every specimen a point above its group, with mean and
/// standard deviation. @throws InputError if nothing was fitted
PlotScript parameters_plot(std::span<const FitRecord> records);

}  // namespace plastica::calibrate::report
