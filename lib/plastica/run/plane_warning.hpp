#pragma once

#include <optional>
#include <string>

#include "plastica/model/scene.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// Says so where a path at rest in space has left the plane that holds all of its scene: nothing
/// acts across, so what rounding began has grown, and how far depends on the steps. It is told
/// where no bifurcation was found.
std::optional<std::string> plane_warning(const Scene& scene, const SolverOptions& solver,
                                         Level level, const Response& response);

}  // namespace plastica
