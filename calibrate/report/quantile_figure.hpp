#pragma once

#include <vector>

#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/report/scene_figure.hpp"

/// Whether residuals are normal, as the eye sees it; not installed.
namespace plastica::calibrate::report {

using plastica::report::Figure;
using plastica::report::FigurePanel;

/// Sorted residuals over their noise, against the quantiles of the standard normal distribution at
/// (i - 3/8)/(n + 1/4), i = 1 … n (Blom, Statistical Estimates and Transformed Beta-Variables,
/// 1958). Normal residuals lie along the straight line; about it the band in which 95 of 100 would
/// lie that are independent: z ± 1.96 sqrt(p (1 - p)/n)/phi(z), the large-sample error of a
/// sample's quantile (Cramér, Mathematical Methods of Statistics, 1946, 28.5).
/// @param noise  standard deviation, > 0
FigurePanel quantile_panel(std::vector<double> residuals, double noise);

/// Of one specimen; the noise is the stated one, else the rms of its residuals.
/// @throws InputError if it was not fitted, or is fitted without a misfit
Figure quantiles_figure(const FitRecord& record);
/// A panel for each target. @throws InputError as above
Figure quantiles_figure(const SceneFitRecord& record);

}  // namespace plastica::calibrate::report
