#pragma once

#include <string>
#include <vector>

#include "plastica/model/scene.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// Says where a beam of ideal plasticity gives way under load control before it goes on, and where
/// a path that arcs lead passes its first peak: what was prescribed falls from there, and led by
/// itself the beam would leave the path. Peaks between two samples that both rise are not seen.
/// Says of a limit load without any load what it may be.
std::vector<std::string> peak_warnings(const Scene& scene, const Response& response);

}  // namespace plastica
