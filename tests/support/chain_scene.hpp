#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "plastica/model/section.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::testing {

/// A straight steel beam without supports and probes: 1 m of 20 mm square, E = 200 GPa,
/// sigma_y = 250 MPa; elastic until a test says otherwise.
inline Scene chain_scene(int segments) {
  Scene scene;
  scene.material.youngs_modulus = 200e9;
  scene.material.yield_stress = 250e6;
  scene.section.width = 0.02;
  scene.section.height = 0.02;
  scene.beam.segments = segments;
  scene.yield_model = YieldModel::Elastic;
  scene.probes.clear();
  return scene;
}

/// The same, clamped at the start.
inline Scene cantilever_scene(int segments) {
  Scene scene = chain_scene(segments);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Clamp});
  return scene;
}

/// Adds a probe; probes are numbered in the order in which they are added.
inline void add_probe(Scene& scene, ProbeQuantity quantity, Place at, Component component) {
  scene.probes.push_back({.name = "probe" + std::to_string(scene.probes.size()),
                          .quantity = quantity,
                          .at = at,
                          .component = component});
}

inline SectionProperties properties_of(const Scene& scene) {
  return section_properties(scene.section, scene.material.poisson_ratio);
}

/// E I about x [N m^2].
inline double bending_stiffness_of(const Scene& scene) {
  return scene.material.youngs_modulus * properties_of(scene).second_moment_x;
}

/// M_y about x [N m].
inline double yield_moment_of(const Scene& scene) {
  return scene.material.yield_stress * properties_of(scene).section_modulus_x;
}

/// Runs a scene that must go to its end.
inline Response completed(const Scene& scene, const SolverOptions& options = {}) {
  Response response = simulate(scene, options);
  EXPECT_EQ(response.status, Status::Completed) << name_of(response.status);
  return response;
}

/// A probe's value at the last sample.
inline double last_of(const Response& response, std::size_t probe) {
  return response.probes.at(probe).at(response.samples - 1);
}

/// Where node k is at the last sample, world axes [m].
inline std::array<double, 3> last_position(const Response& response, std::size_t node) {
  const ChainHistory& chain = response.chain;
  const std::size_t at = ((response.samples - 1) * chain.joints + node) * 3;
  return {chain.position.at(at), chain.position.at(at + 1), chain.position.at(at + 2)};
}

}  // namespace plastica::testing
