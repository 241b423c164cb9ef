#pragma once

#include <span>

#include "plastica/model/scene.hpp"

namespace plastica::model_detail {

/// Whether a load's moment acts where a rotational spring holds the beam within. What the spring
/// takes of it follows from the stiffness of the beam, as the scene is laid out.
/// @param ends  of `segment_ends`
bool shares_moment(const Scene& scene, const Load& load, std::span<const double> ends);

/// Whether any load of the scene's has one.
bool shares_moments(const Scene& scene, std::span<const double> ends);

}  // namespace plastica::model_detail
