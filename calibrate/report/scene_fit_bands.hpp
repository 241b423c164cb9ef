#pragma once

#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/report/scene_figure.hpp"

/// Confidence bands in pictures of fits through scenes; not installed.
namespace plastica::calibrate::report {

/// Bands of 95 %, at each sample by itself: of the fitted curve by the covariance, and of a new
/// sample by the noise, too. Areas where the abscissa only grows, else lines.
/// @param of_target  has errors of its fitted ordinates; none: no bands
std::vector<plastica::report::FigureCurve> bands_of(const SceneTarget& target,
                                                    const TargetFit& of_target,
                                                    const DisplayUnit& x_unit,
                                                    const DisplayUnit& y_unit);

}  // namespace plastica::calibrate::report
