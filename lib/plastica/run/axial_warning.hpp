#pragma once

#include <string>
#include <vector>

#include "plastica/model/scene.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// What a run says of axial forces: what its yielding joints leave out or cannot follow
/// (`Response::axial`), and a thrust that nothing holds in the plane (`Response::unheld_thrust`).
std::vector<std::string> axial_warnings(const Scene& scene, const SolverOptions& options,
                                        const Response& response);

}  // namespace plastica
