#pragma once

#include <optional>
#include <string>

#include "plastica/model/choose_level.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::model_detail {

/// A motion of the whole undeformed beam that no support resists at a level: "move along z",
/// "rotate about x". Springs and pillars count as holding; empty if nothing is free.
std::optional<std::string> free_motion(const Scene& scene, const LevelChoice& level);

}  // namespace plastica::model_detail
