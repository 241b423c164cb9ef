#pragma once

#include <vector>

#include "plastica/model/choose_level.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::model_detail {

/// What the checks of a scene have worked out.
struct CheckedScene {
  LevelChoice level;
  std::vector<double> ends;  ///< where segments end (`segment_ends`); of a coupon empty
  std::vector<int> cuts;     ///< the segment end that each cut of the scene is nearest to (cuts)
};

/// As `check_scene`.
CheckedScene checked_scene(const Scene& scene, const SolverOptions& options);

}  // namespace plastica::model_detail
