#pragma once

#include "calibrate/engine/engine_beam.hpp"
#include "tests/support/chain_scene.hpp"

namespace plastica::testing {

/// A bar of 4 segments, 20 mm x 30 mm, clamped at its start, that yields and breaks.
inline Scene breakable_scene() {
  Scene scene = cantilever_scene(4);
  scene.name = "bar";
  scene.yield_model = YieldModel::PerAxis;
  scene.section.height = 0.03;
  scene.material.break_strain = 0.02;
  return scene;
}

/// A beam with all that an export writes: two sections, hardening, half joints at both ends, of
/// which one may move along, and a roller inside of a segment.
inline Scene rich_scene() {
  Scene scene = breakable_scene();
  scene.beam.segment_fractions = {0.25, 0.25, 0.25, 0.25};
  scene.material.hardening = {.law = HardeningLaw::Linear, .tangent_modulus = 2e9};
  Region thick{.from = {0.5, {}}, .section = scene.section, .material = scene.material};
  thick.section.width = 0.025;
  thick.own = {"section.width"};
  scene.regions.push_back(thick);
  scene.supports.push_back({.at = {0.3, {}}, .kind = SupportKind::Roller});
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Clamp,
                            .hold = HeldFreedoms{true, true, false, true, true, true}});
  scene.gravity = {0.0, -9.81, 0.0};
  return scene;
}

/// A strip of a soft material, which gravity bends far.
inline Scene soft_strip(int segments) {
  Scene scene = cantilever_scene(segments);
  scene.material.youngs_modulus = 5e7;
  scene.material.density = 1200.0;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  return scene;
}

/// The numbers of a scene.
inline calibrate::EngineBeam beam_of(const Scene& scene, const SolverOptions& options = {}) {
  return calibrate::engine_beam(scene, options);
}

}  // namespace plastica::testing
