#include "plastica/model/free_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "plastica/model/beam_axis.hpp"

namespace plastica::model_detail {
namespace {

/// A small rigid motion, or what a support resists of it: translation along x, y, z, and rotation
/// about x, y, z through the beam's start, in radians times the beam's length.
using Motion = std::array<double, 6>;

double dot(const Motion& a, const Motion& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// What a resistance along `direction` at `point` (over the length) resists: the velocity there of
/// a motion (v, w) is v + w x point, so along the direction it is v.d + w.(point x d).
Motion along(const std::array<double, 3>& direction, const std::array<double, 3>& point) {
  const auto& d = direction;
  const auto& p = point;
  return {d[0],
          d[1],
          d[2],
          p[1] * d[2] - p[2] * d[1],
          p[2] * d[0] - p[0] * d[2],
          p[0] * d[1] - p[1] * d[0]};
}

std::vector<Motion> resisted_motions(const Scene& scene, std::span<const double> ends) {
  std::vector<Motion> motions;
  const auto add = [&](const Support& support, double share) {
    std::array<double, 3> point = axis_point(scene.beam, share);
    for (double& component : point) component /= scene.beam.length;
    const HeldFreedoms held = support.held();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<double, 3> direction{};
      direction[axis] = 1.0;
      if (held[axis] || support.stiffness[axis] > 0.0) motions.push_back(along(direction, point));
      Motion rotation{};
      rotation[axis + 3] = 1.0;
      if (held[axis + 3] || support.rotational_stiffness[axis] > 0.0) motions.push_back(rotation);
    }
    if (support.has_normal()) motions.push_back(along(support.normal, point));
  };
  for (const Support& support : scene.supports) {
    add(support, share_of(support.at, ends));
    // A bed holds as springs at both of its ends.
    if (support.to) add(support, share_of(*support.to, ends));
  }
  return motions;
}

/// Takes out of a motion what an orthonormal basis holds of it, twice, which leaves rounding alone.
void subtract(std::span<const Motion> basis, Motion& motion) {
  for (int pass = 0; pass < 2; ++pass) {
    for (const Motion& held : basis) {
      const double part = dot(held, motion);
      for (std::size_t i = 0; i < motion.size(); ++i) motion[i] -= part * held[i];
    }
  }
}

}  // namespace

std::array<bool, 6> freedoms_of(const LevelChoice& level) {
  switch (level.level) {
    case Level::Twist: return {false, false, false, false, false, true};
    case Level::Planar:
      return level.bending == BendingAxis::X
                 ? std::array<bool, 6>{false, true, true, true, false, false}
                 : std::array<bool, 6>{true, false, true, false, true, false};
    default: return {true, true, true, true, true, true};
  }
}

std::optional<std::string> free_motion(const Scene& scene, const LevelChoice& level,
                                       std::span<const double> ends) {
  constexpr double kNothing = 1e-9;  // well above the rounding of unit vectors
  const std::array<bool, 6> freedoms = freedoms_of(level);
  std::vector<Motion> basis;
  for (Motion motion : resisted_motions(scene, ends)) {
    for (std::size_t i = 0; i < motion.size(); ++i) motion[i] *= freedoms[i] ? 1.0 : 0.0;
    subtract(basis, motion);
    const double size = std::sqrt(dot(motion, motion));
    if (size < kNothing) continue;
    for (double& component : motion) component /= size;
    basis.push_back(motion);
  }
  // What is left of a unit motion after the basis is its part that nothing resists; of a motion
  // that is free altogether, all of it.
  std::size_t freest = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < freedoms.size(); ++i) {
    if (!freedoms[i]) continue;
    Motion motion{};
    motion[i] = 1.0;
    subtract(basis, motion);
    const double left = std::sqrt(dot(motion, motion));
    if (left <= most + kNothing) continue;
    most = left;
    freest = i;
  }
  if (most < kNothing) return std::nullopt;
  constexpr std::array<const char*, 6> kNames{"move along x",   "move along y",   "move along z",
                                              "rotate about x", "rotate about y", "rotate about z"};
  return kNames[freest];
}

}  // namespace plastica::model_detail
