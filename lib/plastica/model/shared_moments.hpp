#pragma once

#include <span>

#include "plastica/model/scene.hpp"

namespace plastica::model_detail {

/// Whether a moment acts where a rotational spring holds the beam within. What the spring takes of
/// it follows from the stiffness of the beam, as the scene is laid out.
/// @param ends  of `segment_ends`
bool shares_moments(const Scene& scene, std::span<const double> ends);

}  // namespace plastica::model_detail
