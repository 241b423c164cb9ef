#pragma once

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/law.hpp"
#include "calibrate/result/result.hpp"

namespace plastica::calibrate {

/// What a fit of one law is told: the options with that law in the material and its parameters.
///
/// Freed by themselves, between bounds and from starts that the curve gives (start_values.hpp), are
/// those that the options do not name: of linear hardening the tangent modulus and, of cyclic
/// curves, the kinematic fraction; of Voce's Q and b; of Chaboche's these and C and gamma of two
/// back-stresses, one fast and one slow. What the options fix stays fixed.
FitOptions options_of(Law law, const FitOptions& options, Loading loading);

/// Fits one law of several. Where a law that contains a simpler one ends with a larger cost than
/// that, it searches again from the simpler law's values of what both have, its own parameters from
/// their usual starts; and if that is not enough, from where they have no effect
/// (`min_effect_value`), so that it ends no worse. A warning says where given bounds keep it from
/// there.
/// @throws InputError as `fit_target`
FitResult fit_law(const Target& target, const FitOptions& options, Law law);

}  // namespace plastica::calibrate
