#pragma once

#include <optional>
#include <string_view>

#include "plastica/model/scene.hpp"

namespace plastica::sweeps {

/// What a scene puts at the end of a segment by its number, which is another place with another
/// number of segments: "load.at"; the beam's start, segment 0, stays. None: nothing.
std::optional<std::string_view> numbered_place(const Scene& scene, const SolverOptions& solver);

}  // namespace plastica::sweeps
