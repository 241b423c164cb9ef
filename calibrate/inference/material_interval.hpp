#pragma once

#include <span>

#include "calibrate/inference/segments_error.hpp"
#include "calibrate/result/fitted_parameter.hpp"

namespace plastica::calibrate {

/// Whether residuals are no independent noise: in fewer runs than noise has (`kFewRuns`), or with
/// neighbours alike by more than 0.5, or by more than those of so many independent ones would be
/// once in two thousand times. Errors that take them for independent are then too small. The
/// correlation of neighbours has a standard deviation of 1/sqrt(n) there (Bartlett, J. R. Stat.
/// Soc. Suppl. 8 (1946) 27).
/// @param runs_test_p  NaN: too few to count
/// @param samples      what they count by their weights
bool are_in_runs(double runs_test_p, double autocorrelation, double samples);

/// By what residuals in runs raise the variance of a parameter over that of independent ones: what
/// the samples count over what they are worth (`samples_worth`), where no fewer are left than one
/// more than there are parameters.
/// @param samples     what they count by their weights
/// @param parameters  that the curve determines
double variance_inflation(double autocorrelation, double samples, int parameters);

/// Sets standard error and confidence interval of a parameter as one of the material, from all that
/// parts it from the fitted value: noise and lack of fit (Student's t with the parameter's degrees
/// of freedom), breaks between samples, and segments (both evenly likely over their intervals).
///
/// With segments the interval lies about what the fits lead to, f_0 +- F_s |f_0 - f(2N)|, and not
/// about the value, which is that of a beam with N segments; the standard error holds the distance
/// of both, F_s |f_0 - f(N)|/sqrt(3), and is that of the value.
/// Where what the segments leave open, f_0 +- F_s |f_0 - f(2N)|, holds all that lies within the
/// parameter's bounds, as of values that diverge, there is no error and no interval (NaN).
/// @param halves    half the intervals of breaks between samples [SI]
/// @param segments  what they do to the parameter; unknown, or of coupons, nothing
/// @param p         its errors by source and its degrees_of_freedom are set
void set_material_interval(double confidence, std::span<const double> halves,
                           const SegmentsError& segments, FittedParameter& p);

/// Whether a parameter's interval lies about what its segments lead to. In result files of scene
/// fits before version 7 it lies about the value, and is of noise and sampling alone.
bool is_of_material(const FittedParameter& p, const SegmentsError& segments);

}  // namespace plastica::calibrate
