#pragma once

#include "calibrate/search/optimizer.hpp"

namespace plastica::calibrate {

/// Below this a curvature is rounding: the coordinate keeps its scale.
inline constexpr double kMinCurvature = 1e-20;

/// Runs one algorithm alone over the whole box, from the problem's start.
///
/// Those of NLopt see coordinates over the root of the curvature at the start after Gauss and
/// Newton, 2 J^T J: algorithms that begin with a unit matrix of second derivatives (SLSQP) need it
/// to be about right. Powers of two, which scale without rounding.
/// @param problem  with cost and squares
/// @throws as `minimize`
Minimum minimize_alone(const Problem& problem, const MinimizeOptions& how);

}  // namespace plastica::calibrate
