#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/lib/model/chain_scenes.hpp"

namespace plastica {

/// The warnings of the cantilever of `chain_scenes.hpp`, changed.
inline std::vector<std::string> warnings_of(const std::function<void(Scene&)>& change) {
  Scene scene = testing::cantilever();
  change(scene);
  check_scene(scene, {});
  return scene_warnings(prepare(scene, {}));
}

/// Whether one of them has these words.
inline bool warns(const std::vector<std::string>& warnings, const std::string& text) {
  for (const std::string& warning : warnings) {
    if (warning.find(text) != std::string::npos) return true;
  }
  return false;
}

}  // namespace plastica
