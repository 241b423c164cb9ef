#pragma once

#include <cstdint>

#include "plastica/model/field.hpp"

namespace plastica::io {

/// Digest of all that decides what a run of a scene gives: every field of scene and solver, and
/// what no field names (places, histories, supports, loads, regions, probes, …). Names of scenes
/// and materials, comments and the order of a file's lines do not count.
std::uint64_t scene_digest(const Setup& setup);

}  // namespace plastica::io
