#pragma once

#include <span>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/search/ladder.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Fits one target, without priors and without what the options ask for beside a fit
/// (IntervalOptions). Parameters and errors as `fit_target`, whose options are checked.
FitResult search_target(const Target& target, const FitOptions& options,
                        std::span<const StartPoint> further = {});

/// Weighs a fit with its priors, those that parameters state and that of the elastic slope of its
/// curve (weighed_priors.hpp): searches on from its values with them, until their variance no
/// longer changes. Leaves a result that is not Fitted, or has no prior, as it is.
/// @param options  those that it was searched with
void weigh_priors(const Target& target, const FitOptions& options, FitResult& result);

}  // namespace plastica::calibrate
