#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "plastica/model/scene.hpp"

namespace plastica {

/// What a scene puts at the end of a segment by its number, which is another place with another
/// number of segments: "load.at"; the beam's start, segment 0, stays. None: nothing.
std::optional<std::string_view> numbered_place(const Scene& scene, const SolverOptions& solver);

/// Why a scene may not get another number of segments: what it moves. Empty: it may.
std::string why_not_segments(const Scene& scene, const SolverOptions& solver, int segments);

/// The same of another beam that it may not get: with segments that end elsewhere.
std::string why_not_beam(const Scene& scene, const SolverOptions& solver, const Scene& other);

}  // namespace plastica
