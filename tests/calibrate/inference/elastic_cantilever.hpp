#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "tests/calibrate/fit/bent_bar.hpp"

namespace plastica::testing {

using calibrate::FittedParameter;
using calibrate::SceneFitOptions;
using calibrate::SceneTarget;

inline constexpr double kModulus = 205e9;

/// A cantilever under small forces at its end.
inline Setup cantilever(int segments) {
  Setup setup;
  Scene& scene = setup.scene;
  scene.section.width = scene.section.height = 0.02;
  scene.beam.segments = segments;
  scene.yield_model = YieldModel::Elastic;
  scene.supports.resize(1);
  scene.loads.resize(1);
  scene.loads[0].force = {0.0, 1.0, 0.0};
  scene.probes = {{"tip", ProbeQuantity::Displacement}};
  return setup;
}

/// The continuous beam's tip, P L^3/(3 E I), over its force.
inline SceneTarget continuous() {
  SceneTarget target;
  target.name = "tip";
  target.kind = calibrate::Abscissa::Load;
  target.ordinate_probe = "tip";
  const double stiffness = 3.0 * kModulus * std::pow(0.02, 4) / 12.0;
  for (int i = 1; i <= 10; ++i) {
    target.abscissa.push_back(0.01 * i);
    target.ordinate.push_back(0.01 * i / stiffness);
  }
  return target;
}

inline SceneFitOptions stiffness() {
  return {.parameters = {free_parameter("youngs_modulus", 50e9, 500e9)}, .starts = 1};
}

/// Of so many seeds of noise, over the largest tip, the fraction whose interval holds the
/// continuous beam's modulus. The chain's own is larger by 1/(2 N^2).
inline double coverage(int segments, double noise, int seeds,
                       const SceneFitOptions& options = stiffness()) {
  const SceneTarget clean = continuous();
  int held = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    std::normal_distribution<double> scatter(0.0, noise * clean.ordinate.back());
    SceneTarget target = clean;
    for (double& w : target.ordinate) w += scatter(random);
    const FittedParameter p =
        calibrate::fit_scene(cantilever(segments), target, options).parameters.at(0);
    held += p.interval_low <= kModulus && kModulus <= p.interval_high ? 1 : 0;
  }
  return held / static_cast<double>(seeds);
}

}  // namespace plastica::testing
