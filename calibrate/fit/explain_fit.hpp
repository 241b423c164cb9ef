#pragma once

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Sets all that there is to be said of a solution: misfit, parameters with errors and verdicts,
/// warnings, the fitted curve. What the result has of these is replaced; seed, law, stages and
/// trace stay.
/// @param active  the solution, SI (n_active)
void explain_fit(const Target& target, const FitOptions& options, const ParameterSet& set,
                 Misfit& misfit, std::span<const double> active, FitResult& result);

/// Of this what a search goes on from: misfit, and parameters with values and bounds alone.
void describe_fit(const Target& target, const ParameterSet& set, Misfit& misfit,
                  std::span<const double> active, FitResult& result);

}  // namespace plastica::calibrate
