#pragma once

#include <string>

#include "plastica/model/scene.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// What a run says of an axial force that its yielding joints leave out, or cannot follow; empty:
/// nothing. See `Response::axial`.
std::string axial_warning(const Scene& scene, const SolverOptions& options,
                          const Response& response);

}  // namespace plastica
