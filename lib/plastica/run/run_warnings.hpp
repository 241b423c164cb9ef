#pragma once

#include <string>
#include <vector>

#include "plastica/model/scene.hpp"
#include "plastica/run/model.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// What a reader must not overlook of a scene that has run: `scene_warnings`, and what the response
/// shows.
/// @param model     of the scene, as it ran
/// @param response  of that run
std::vector<std::string> run_warnings(const Scene& scene, const SolverOptions& solver,
                                      const Model& model, const Response& response);

}  // namespace plastica
