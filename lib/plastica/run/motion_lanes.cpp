#include "plastica/run/motion_lanes.hpp"

#include <algorithm>

namespace plastica {
namespace {

/// Supports move along and about the same axes.
bool same_moves(const Scene& a, const Scene& b) {
  const auto same = [](const Support& x, const Support& y) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((x.translation[k] != 0.0) != (y.translation[k] != 0.0)) return false;
      if ((x.rotation[k] != 0.0) != (y.rotation[k] != 0.0)) return false;
    }
    return true;
  };
  return std::equal(a.supports.begin(), a.supports.end(), b.supports.begin(), b.supports.end(),
                    same);
}

bool same_rule(const SolverOptions& a, const SolverOptions& b) {
  return a.scheme == b.scheme && a.rho_infinity == b.rho_infinity && a.damping == b.damping &&
         a.damping_time == b.damping_time && a.time_step == b.time_step &&
         a.max_iterations == b.max_iterations && a.tolerance == b.tolerance &&
         a.largest_rotation == b.largest_rotation && a.smallest_step == b.smallest_step;
}

}  // namespace

bool moves_in_lanes(const ChainModel& model) {
  return model.options.analysis == Analysis::Dynamics && !steps_in_lanes(model) &&
         why_alone(model).empty();
}

bool same_motion_lanes(const ChainModel& a, const ChainModel& b) {
  return moves_in_lanes(a) && moves_in_lanes(b) && same_shape(a, b) && same_times(a, b) &&
         same_rule(a.options, b.options) && same_moves(a.scene, b.scene);
}

std::unique_ptr<LaneProgram> make_motion_lanes(const ChainModel& model) {
  if (model.level == Level::Planar) return make_planar_motion_lanes(model);
  return make_spatial_motion_lanes(model);
}

}  // namespace plastica
