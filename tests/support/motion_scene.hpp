#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "tests/support/chain_scene.hpp"

namespace plastica::testing {

/// Dynamics with fixed steps, a sample each.
inline SolverOptions motion_options(Scheme scheme, double time_step, int steps) {
  SolverOptions options;
  options.analysis = Analysis::Dynamics;
  options.scheme = scheme;
  options.time_step = time_step;
  options.steps = steps;
  options.duration = time_step * steps;
  options.frames = 1;
  return options;
}

/// A plastic bar of 2 GPa and 1200 kg/m^3, 1 m of 20 mm x 30 mm, that flies freely: turning, and
/// its outer half turning faster.
inline Scene flying_scene(int segments, bool in_space) {
  Scene scene = chain_scene(segments);
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  scene.section.height = 0.03;
  InitialMotion all;
  all.velocity = {0.0, 0.3, 0.1};
  all.spin = {4.0, 0.0, 0.0};
  InitialMotion outer;
  outer.from = {0.5, {}};
  outer.about = {0.5, {}};
  outer.spin = {3.0, 0.0, 0.0};
  if (in_space) {
    all.spin = {4.0, 1.5, 2.0};
    outer.spin = {3.0, -2.0, 1.0};
  }
  scene.initial_motions = {all, outer};
  return scene;
}

/// A steel cantilever whose outer half is struck sideways [m/s], with its weight.
inline Scene struck_scene(int segments, double speed, YieldModel model = YieldModel::Interaction) {
  Scene scene = cantilever_scene(segments);
  scene.material.density = 7850.0;
  scene.yield_model = model;
  InitialMotion blow;
  blow.from = {0.5, {}};
  blow.velocity = {0.0, -speed, 0.0};
  scene.initial_motions = {blow};
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  return scene;
}

/// One that breaks at a permanent strain of 5 %.
inline Scene breaking_scene(int segments, double speed = 30.0) {
  Scene scene = struck_scene(segments, speed);
  scene.material.break_strain = 0.05;
  return scene;
}

inline const Energies& last_energy(const Response& response) {
  return response.chain.energy.at(response.samples - 1);
}

/// Largest residual of the energy balance over the largest energy.
inline double largest_residual(const Response& response) {
  double size = 0.0;
  double residual = 0.0;
  for (std::size_t i = 0; i < response.samples; ++i) {
    const Energies& energy = response.chain.energy[i];
    size = std::max({size, energy.kinetic, energy.elastic, std::fabs(energy.external)});
    residual = std::max(residual, std::fabs(energy.residual));
  }
  return residual / size;
}

/// Largest change of a probe from its first value, over its largest size.
inline double drift_of(const Response& response, std::size_t probe) {
  double change = 0.0;
  double size = 0.0;
  const auto& values = response.probes.at(probe);
  for (std::size_t i = 0; i < response.samples; ++i) {
    change = std::max(change, std::fabs(values[i] - values[0]));
    size = std::max(size, std::fabs(values[i]));
  }
  return size > 0.0 ? change / size : 0.0;
}

}  // namespace plastica::testing
