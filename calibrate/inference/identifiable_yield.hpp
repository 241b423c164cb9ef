#pragma once

#include <span>

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"

/// Whether a yield stress is identifiable from a curve; not installed.
namespace plastica::calibrate {

/// Takes yield stresses that are not identifiable from the curve out of the slopes of a solution.
///
/// Of a curve that stays elastic the best yield stress is often that of its last sample or two,
/// where their noise is downwards: the slopes say that these determine it. So where no more than
/// three samples depend on a yield stress, the cost without it (at its upper bound, the others
/// searched anew) must be higher by what the confidence asks for, the squared quantile of Student's
/// t times the noise.
/// @param active  solution, SI (n)
void drop_unidentifiable_yield(Misfit& misfit, const ParameterSet& parameters,
                               std::span<const double> active, const FitOptions& options,
                               Misfit::Details& details);

}  // namespace plastica::calibrate
