#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plastica/run/model.hpp"

namespace plastica {

/// What a prepared scene asks for that its model does badly, a line each with the figure that it
/// costs; empty for a coupon.
/// - A beam shorter than ten times its depth: the fraction of shear in a cantilever's deflection
///   (Timoshenko), unless joints shear.
/// - A break limit with joints longer than the hinge length, or without a hinge length.
/// - An ideal joint that is bent and released: what its cap leaves out.
/// - A tube whose wall buckles before it yields, or before its hinges have turned (EN 1993-1-1).
/// - Components clipped one by one where the beam bends about both axes.
/// - A polyline with corners inside of segments.
/// - Two supports with one short segment between them.
///
/// In dynamics also:
/// - Fixed steps that are fewer than 20 in a period of the beam's first frequency.
/// - A first-order scheme: what it takes of that frequency's amplitude in a period.
/// - Generalized-alpha without any damping of its own.
/// - A scheme that leaves an impact on a pillar ringing.
/// - A restitution of an impact, which is that of the touched point.
/// - Gravity that grows without end, and cuts that never come.
std::vector<std::string> scene_warnings(const Model& model);

/// What the results of a beam whose joints have yielded leave out where ideal plasticity has the
/// cap of first yield: the rest of the section. Of a scene that is let go `scene_warnings` tells
/// it.
std::optional<std::string> first_yield_warning(const Model& model);

}  // namespace plastica
