#pragma once

#include <string>
#include <vector>

#include "calibrate/scene/scene_fit.hpp"

namespace plastica::calibrate {

/// One fit of several that are run together.
struct SceneFitCase {
  std::string name;  ///< the target's; of a fit that shares its parameters the file's
  std::vector<ScenePart> parts;
};

/// One fit through scenes, what it was held against and what came out: what a file holds of it, and
/// reports and pictures are made of.
struct SceneFitRecord {
  std::string name;  ///< unique in a file: the target's, or the file's of a joint fit
  std::vector<SceneTarget> targets;  ///< as `SceneFitResult::parts`
  std::vector<double> weights;       ///< of these
  SceneFitResult result;
};

}  // namespace plastica::calibrate
