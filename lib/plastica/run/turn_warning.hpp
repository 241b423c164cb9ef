#pragma once

#include <string>
#include <vector>

#include "plastica/model/rules.hpp"
#include "plastica/model/scene.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// Names the probes of rotations that have passed half a turn in space: a rotation vector is no
/// longer than that, and comes back from the other side.
std::vector<std::string> turn_warnings(const Scene& scene, Level level, const Response& response);

}  // namespace plastica
