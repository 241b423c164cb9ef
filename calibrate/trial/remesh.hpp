#pragma once

#include "calibrate/fit/scene_fit.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate {

/// How a beam is remeshed.
enum class Division { Half, Twice };

/// The same chain with half or twice the segments: each is cut in two, or two are made one. What
/// stands at the end of a segment stays at one.
/// @throws InputError if that cannot be: a number of segments that is odd or below 4, a place that
///         would fall within a segment, lengths given for each joint
Setup remeshed(const Setup& setup, Division division);

/// The same of a target's scene.
/// @throws InputError also if its target was measured as the angle of one joint, which follows the
///         joint's length
Setup remeshed(const WeightedTarget& weighted, Division division);

/// Order in the segments' length at which the joints of a chain answer as a continuous beam does:
/// 2, or 1 where a rigidly clamped end leaves a joint out.
double order_of_joints(const Scene& scene);

}  // namespace plastica::calibrate
