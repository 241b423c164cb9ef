#pragma once

#include <optional>
#include <string>

#include "plastica/model/choose_level.hpp"
#include "plastica/model/scene.hpp"

/// Warnings of `scene_warnings` about what sections and their material leave out.
namespace plastica::model_detail {

/// Caps on each axis by itself, where the section has less for several together.
std::optional<std::string> per_axis_warning(const Scene& scene, const LevelChoice& level);

/// Open sections warp when they twist, and what holds that is not modelled.
std::optional<std::string> warping_warning(const Scene& scene, const LevelChoice& level);

/// A beam that bends and leaves its plane does so by twisting, too.
std::optional<std::string> tipping_warning(const Scene& scene);

/// A joint that yields first where the stress falls unloads its neighbours.
std::optional<std::string> softening_warning(const Scene& scene);

}  // namespace plastica::model_detail
