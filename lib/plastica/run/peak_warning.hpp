#pragma once

#include <string>
#include <vector>

#include "plastica/run/response.hpp"

namespace plastica {

/// Says where a path that arcs lead passes its first peak: what was prescribed falls from there,
/// and led by itself the beam would leave the path. Peaks between two samples that both rise are
/// not seen.
std::vector<std::string> peak_warnings(const Response& response);

}  // namespace plastica
