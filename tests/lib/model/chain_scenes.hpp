#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "plastica/model/scene.hpp"
#include "tests/support/message.hpp"

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

/// The error of a cantilever of eight segments that `spoil` has changed.
inline std::string error_of(const std::function<void(Scene&, SolverOptions&)>& spoil) {
  Scene scene = cantilever();
  scene.beam.segments = 8;
  SolverOptions options;
  spoil(scene, options);
  return message_of([&] { check_scene(scene, options); });
}

inline std::string error_of(const std::function<void(Scene&)>& spoil) {
  return error_of([&](Scene& scene, SolverOptions&) { spoil(scene); });
}

/// The error of the same cantilever in motion; its load is a ramp of a second.
inline std::string error_of_motion(const std::function<void(Scene&, SolverOptions&)>& spoil) {
  return error_of([&](Scene& scene, SolverOptions& options) {
    options.analysis = Analysis::Dynamics;
    spoil(scene, options);
  });
}

/// The same without supports and loads: a beam in free flight, for a second.
inline std::string error_of_flight(const std::function<void(Scene&, SolverOptions&)>& spoil) {
  return error_of_motion([&](Scene& scene, SolverOptions& options) {
    scene.supports.clear();
    scene.loads.clear();
    options.duration = 1.0;
    spoil(scene, options);
  });
}

/// Makes a polyline of the beam; its length is left as it is.
inline void curve(Scene& scene, std::vector<std::array<double, 3>> points) {
  scene.beam.shape = BeamShape::Polyline;
  scene.beam.points = std::move(points);
}

}  // namespace plastica::testing
