#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "plastica/model/choose_level.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::model_detail {

/// Which small motions a level has: along x, y, z, and about x, y, z.
std::array<bool, 6> freedoms_of(const LevelChoice& level);

/// A motion of the whole undeformed beam, or of a part of it beside a hinge, that no support
/// resists at a level: "move along z", "rotate about x". Springs and pillars count as holding;
/// empty if nothing is free.
std::optional<std::string> free_motion(const Scene& scene, const LevelChoice& level,
                                       std::span<const double> ends);

}  // namespace plastica::model_detail
