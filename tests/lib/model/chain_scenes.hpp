#pragma once

#include "plastica/model/scene.hpp"

namespace plastica::testing {

/// A cantilever along z, 1 m long, clamped at its start, with a force at its end.
inline Scene cantilever(std::array<double, 3> force = {0.0, -100.0, 0.0}) {
  Scene scene;
  scene.section.width = 0.02;
  scene.section.height = 0.02;
  scene.beam.segments = 64;
  scene.supports.push_back({Place::start(), SupportKind::Clamp});
  Load load;
  load.force = force;
  scene.loads.push_back(load);
  scene.probes.clear();
  return scene;
}

}  // namespace plastica::testing
