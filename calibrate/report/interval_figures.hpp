#pragma once

#include "calibrate/report/shown_intervals.hpp"
#include "plastica/report/scene_figure.hpp"

/// Pictures of the intervals of a fit, of a coupon or through scenes; not installed.
namespace plastica::calibrate::report {

using plastica::report::Figure;

/// A panel per parameter: the rise of the least cost over its value, the parabola of the covariance
/// beside it, the threshold, the interval's ends marked. @throws InputError if it has no profile
Figure profile_figure(const ShownIntervals& shown);

/// A panel per parameter: how the resamples' values lie, and the normal curve of the covariance
/// beside them, the percentiles marked; then a panel per pair. Of the residuals if they were drawn,
/// else of the specimens. @throws InputError if there is no bootstrap
Figure bootstrap_figure(const ShownIntervals& shown);

}  // namespace plastica::calibrate::report
