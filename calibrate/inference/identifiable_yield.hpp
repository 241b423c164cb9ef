#pragma once

#include <span>

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/parameter_set.hpp"
#include "calibrate/target/curve.hpp"

/// Whether a yield stress is identifiable from a curve; not installed.
namespace plastica::calibrate {

/// Takes the yield stress, and what else acts beyond it, out of the slopes of a solution whose
/// curve does not show that it yields.
///
/// Of a curve that stays elastic the best yield stress is often that of some samples at its end,
/// where their noise is downwards: the slopes say that these determine it. So the cost without it
/// (at its upper bound, the others searched anew; nothing is said where that is so low that the
/// model yields) must be higher by what the confidence asks for: the quantile of chi-squared for as
/// many parameters as act beyond it, as Student's t has it, times the noise, with a risk that is
/// shared between log2(samples) places where it might have begun.
/// @param curve  that the misfit is of
/// @param active  solution, SI (n)
void drop_unidentifiable_yield(Misfit& misfit, const ParameterSet& parameters, const Curve& curve,
                               std::span<const double> active, const FitOptions& options,
                               Misfit::Details& details);

}  // namespace plastica::calibrate
