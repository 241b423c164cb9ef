#pragma once

#include "calibrate/scene/scene_fit.hpp"

namespace plastica::calibrate {

/// Whether a parameter is a limit, which is not searched but set.
inline bool is_break(const Parameter& p) {
  return p.field->material == MaterialField::BreakStrain ||
         p.field->material == MaterialField::BreakShearStrain;
}

/// @throws InputError for what a fit of no scene can have
void check_scene_fit(const SceneTarget& target, const SceneFitOptions& options);

}  // namespace plastica::calibrate
