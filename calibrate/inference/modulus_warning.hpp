#pragma once

#include <span>
#include <string>

#include "calibrate/result/fitted_parameter.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Compares a fitted Young's modulus with the slope of the curve's elastic part, which knows
/// nothing of the fit: they are of one material if they agree within 10 %, or within three standard
/// errors of both.
/// @return the warning for a curve of which they do not; empty for others, for a modulus that was
///         not free, and for curves without a slope of their own (bending, torsion, too few
///         samples)
std::string modulus_warning(const Target& target, std::span<const FittedParameter> parameters);

}  // namespace plastica::calibrate
