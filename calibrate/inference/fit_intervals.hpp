#pragma once

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Finds the intervals that the options ask for beside those of the covariance, of a coupon fit.
///
/// Profile: the least cost over one parameter, the others searched anew, up to where it has risen
/// by the threshold: the squared quantile of Student's t times the noise. Where samples are
/// weighted, the threshold is stretched as the squared error is (uncertainty.hpp), so that both
/// intervals are the same for a linear model. A break limit is not searched: its profile is that of
/// the permanent strain which the model has when the specimen breaks, and its ends have the break's
/// place between two samples in them (theory::half_interval).
///
/// Residual bootstrap: the residuals of the samples that enter, resampled with replacement about
/// the fitted curve, a search from the fitted values on for each; the break is anywhere between its
/// samples. Of a parameter that the curve does not determine there is no interval. The draws are
/// the fit's own (`FitResult::seed`), whatever else is fitted.
///
/// Nothing else of the result changes. Never throws for what a curve is like: what fails leaves a
/// warning. A result that is not Fitted is left as it is.
/// @param options  those that it was fitted with
void add_intervals(const Target& target, const FitOptions& options, FitResult& result);

}  // namespace plastica::calibrate
