#pragma once

#include <string>
#include <vector>

#include "plastica/model/scene.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// Names the elastic supports whose stiffness makes forces or moments of the rounding of places
/// and angles that are above a millionth of the largest reaction.
std::vector<std::string> rounding_warnings(const Scene& scene, const Response& response);

}  // namespace plastica
