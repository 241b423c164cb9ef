#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "plastica/run/break_watch.hpp"

/// Beams of a metre whose joints a break watch looks at.
namespace plastica::testing::watched {

inline constexpr double kNone = std::numeric_limits<double>::infinity();
inline constexpr double kHeight = 0.2;  ///< h [m], the hinge length about x too
inline constexpr double kWidth = 0.1;   ///< b [m]

/// A scene whose law gathers rotation in one joint: ideal plasticity of the whole section.
inline Scene ideal_scene() {
  Scene scene;
  scene.section.width = kWidth;
  scene.section.height = kHeight;
  scene.yield_model = YieldModel::PerAxis;
  return scene;
}

inline Scene hardening_scene() {
  Scene scene = ideal_scene();
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 2e9;
  return scene;
}

/// The joints of a beam of 1 m, half joints at its ends, all with the same limits.
inline std::vector<chain::JointModel> joints_of(int segments, const std::array<double, 4>& limit) {
  std::vector<chain::JointModel> joints;
  const double l = 1.0 / segments;
  for (int i = 0; i <= segments; ++i) {
    chain::JointModel joint;
    joint.joint = static_cast<std::size_t>(i);
    joint.fraction = i * l;
    joint.begin = i == 0 ? 0.0 : (i - 0.5) * l;
    joint.end = i == segments ? 1.0 : (i + 0.5) * l;
    joint.length.fill(joint.end - joint.begin);
    joint.resists = {true, true, true};
    joint.width = kWidth;
    joint.height = kHeight;
    joint.lever[law::kTorsion] = 0.08;
    joint.limit = limit;
    joints.push_back(joint);
  }
  return joints;
}

inline BreakWatch watch_of(const Scene& scene, int segments,
                           const std::array<double, 4>& limit = {0.1, kNone, kNone, kNone}) {
  return {scene, joints_of(segments, limit)};
}

/// The strains of all joints that have turned by these angles.
inline std::vector<double> strains_of(BreakWatch& watch, const std::vector<JointFlow>& angles) {
  NodeStrains turned, of;
  turned.permanent = turned.accumulated = angles;
  of.reset(watch.size());
  of.take(turned);
  return watch.strains(of);
}

/// The strain of one joint.
inline double strain_of(BreakWatch watch, const std::vector<JointFlow>& angles, std::size_t joint) {
  return strains_of(watch, angles)[joint];
}

/// Uniform curvature about x: every joint turns by its tributary length times it.
inline std::vector<JointFlow> uniform(int segments, double curvature) {
  std::vector<JointFlow> angles;
  for (const chain::JointModel& joint : joints_of(segments, {})) {
    angles.push_back({curvature * joint.own_length(), 0.0, 0.0});
  }
  return angles;
}

/// One joint alone turns.
inline std::vector<JointFlow> lone(int segments, std::size_t joint, const JointFlow& angle) {
  std::vector<JointFlow> angles(static_cast<std::size_t>(segments) + 1);
  angles[joint] = angle;
  return angles;
}

}  // namespace plastica::testing::watched
