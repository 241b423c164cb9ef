#pragma once

#include <span>

#include "calibrate/fit/scene_fit.hpp"
#include "plastica/io/digest.hpp"

namespace plastica::calibrate {

/// All of a target that decides what a fit of it gives; not its name.
void add_to(io::Digest& digest, const SceneTarget& target);

/// All of the options that does; not the number of threads.
void add_to(io::Digest& digest, const SceneFitOptions& options);

/// Targets with their names and scenes, and options.
std::uint64_t digest_of(std::span<const WeightedTarget> targets, const SceneFitOptions& options);

}  // namespace plastica::calibrate
