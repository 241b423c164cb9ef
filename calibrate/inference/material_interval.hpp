#pragma once

#include <span>

#include "calibrate/inference/segments_error.hpp"
#include "calibrate/result/fitted_parameter.hpp"

namespace plastica::calibrate {

/// Whether residuals are no noise: in fewer runs than noise has (`kFewRuns`), or with neighbours
/// alike. Errors that take them for independent are then too small.
/// @param runs_test_p  NaN: too few to count
bool are_in_runs(double runs_test_p, double autocorrelation);

/// What residuals in runs add to an error that takes them for noise, as the root of the difference
/// of squares: neighbours that are alike by rho, as of an autoregressive process, count for
/// (1 - rho)/(1 + rho) as many samples (Bayley & Hammersley, J. R. Stat. Soc. Suppl. 8 (1946) 184),
/// and so many samples must be left as there are degrees of freedom to lose.
/// @param noise_error  of a noise as large as the residuals
/// @param samples      what they count by their weights
/// @param parameters   that the curve determines
double misfit_error(double noise_error, double autocorrelation, double samples, int parameters);

/// Sets standard error and confidence interval of a parameter as one of the material, from all that
/// parts it from the fitted value: noise and lack of fit (Student's t with the parameter's degrees
/// of freedom), breaks between samples, and segments (both evenly likely over their intervals).
///
/// With segments the interval lies about what the fits lead to, f_0 +- F_s |f_0 - f(2N)|, and not
/// about the value, which is that of a beam with N segments; the standard error holds the distance
/// of both, F_s |f_0 - f(N)|/sqrt(3), and is that of the value.
/// @param halves    half the intervals of breaks between samples [SI]
/// @param segments  what they do to the parameter; unknown, or of coupons, nothing
/// @param p         its errors by source and its degrees_of_freedom are set
void set_material_interval(double confidence, std::span<const double> halves,
                           const SegmentsError& segments, FittedParameter& p);

}  // namespace plastica::calibrate
