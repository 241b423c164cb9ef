#pragma once

#include <algorithm>
#include <cmath>

#include "plastica/run/simulate.hpp"

namespace plastica::testing {

/// M_p of the beams that break: 50 mm square, 250 MPa [N m].
inline constexpr double kBreakingPlasticMoment = 250e6 * 0.05 * 0.05 * 0.05 / 4.0;

/// A steel cantilever of 1 m, h = 0.05 L square, that breaks at 10 % of permanent strain and yields
/// with the whole section.
inline Scene breaking_cantilever(int segments) {
  Scene scene;
  scene.material.youngs_modulus = 200e9;
  scene.material.yield_stress = 250e6;
  scene.material.break_strain = 0.1;
  scene.section.width = 0.05;
  scene.section.height = 0.05;
  scene.beam.segments = segments;
  scene.yield_model = YieldModel::PerAxis;
  scene.yield_cap = YieldCap::FullyPlastic;
  scene.supports.push_back({});
  scene.probes.clear();
  return scene;
}

/// Bends it by its tip until it breaks.
inline Response break_by_tip_force(Scene scene) {
  Load load;
  load.force = {0.0, -6.0 * kBreakingPlasticMoment, 0.0};
  scene.loads = {load};
  SolverOptions options;
  options.control = PathControl::Displacement;
  options.control_motion = {0.0, -0.95, 0.0};
  options.steps = 40;
  return simulate(scene, options);
}

/// Bends it evenly: its end turns and is free to move.
inline Response break_by_uniform_moment(Scene scene) {
  Support end;
  end.at = Place::end();
  end.hold = HeldFreedoms{false, false, false, true, true, true};
  end.rotation = {-6.0, 0.0, 0.0};
  scene.supports.push_back(end);
  SolverOptions options;
  options.steps = 200;
  return simulate(scene, options);
}

/// Plastic rotation about x of all joints together at the last sample [rad].
inline double plastic_rotation(const Response& response) {
  const ChainHistory& chain = response.chain;
  double sum = 0.0;
  for (std::size_t j = 0; j < chain.joints; ++j) {
    sum += chain.plastic_angle[((response.samples - 1) * chain.joints + j) * 3];
  }
  return std::fabs(sum);
}

/// Largest permanent angle about x of the joints that broke [rad].
inline double broken_angle(const Response& response) {
  double largest = 0.0;
  for (const BrokenJoint& joint : response.chain.events.front().joints) {
    largest = std::max(largest, std::fabs(joint.angle[0]));
  }
  return largest;
}

/// Plastic work of all joints at the last sample [J].
inline double plastic_work(const Response& response) {
  return response.chain.energy[response.samples - 1].plastic;
}

}  // namespace plastica::testing
