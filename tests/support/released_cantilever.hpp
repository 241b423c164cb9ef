#pragma once

#include <cmath>
#include <vector>

#include "tests/support/chain_scene.hpp"

namespace plastica::testing {

/// The beam of tests/reference/w1-cantilever-history: soft, clamped, released straight from rest
/// under gravity; its probe 0 is the tip's way down.
inline Scene released_cantilever(int segments) {
  Scene scene = cantilever_scene(segments);
  scene.material.youngs_modulus = 2e9;
  scene.material.poisson_ratio = 0.3;
  scene.material.density = 1200.0;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

/// Even steps through a motion, of which `samples` are recorded.
inline SolverOptions in_motion(Scheme scheme, double duration, double time_step, int samples) {
  SolverOptions options;
  options.analysis = Analysis::Dynamics;
  options.scheme = scheme;
  options.duration = duration;
  options.time_step = time_step;
  options.steps = samples;
  options.frames = 1;
  return options;
}

/// Root of the mean square of a difference.
inline double rms_between(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace plastica::testing
