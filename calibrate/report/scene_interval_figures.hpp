#pragma once

#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/report/scene_fit_figures.hpp"

/// Pictures of the intervals of a fit through scenes; not installed.
namespace plastica::calibrate::report {

/// A panel per parameter: the rise of the least cost over its value, the parabola of the covariance
/// beside it, the threshold, the interval's ends marked. @throws InputError if it has no profile
Figure profile_figure(const SceneFitRecord& record);

/// A panel per parameter: how the resamples' values lie, and the normal curve of the covariance
/// beside them, the percentiles marked; then a panel per pair. Of the residuals if they were drawn,
/// else of the specimens. @throws InputError if there is no bootstrap
Figure bootstrap_figure(const SceneFitRecord& record);

/// Bands of 95 %, at each sample by itself: of the fitted curve by the covariance, and of a new
/// sample by the noise, too. Areas where the abscissa only grows, else lines.
/// @param part  has errors of its fitted ordinates; none: no bands
std::vector<plastica::report::FigureCurve> bands_of(const SceneTarget& target,
                                                    const ScenePartFit& part,
                                                    double degrees_of_freedom,
                                                    const DisplayUnit& x_unit,
                                                    const DisplayUnit& y_unit);

}  // namespace plastica::calibrate::report
