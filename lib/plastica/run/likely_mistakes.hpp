#pragma once

#include <string>
#include <vector>

#include "plastica/run/model.hpp"
#include "plastica/run/response.hpp"

/// Not installed.
namespace plastica {

/// What is likely to be a mistake in a scene: numbers that no solid has, as after a wrong unit, and
/// what has no effect.
/// @param model     of the scene, as it ran
/// @param response  of that run
std::vector<std::string> likely_mistakes(const Scene& scene, const Model& model,
                                         const Response& response);

}  // namespace plastica
