#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "plastica/chain/layout.hpp"
#include "plastica/model/scene.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// Permanent angles of a joint in its axes: bending about x, about y, torsion [rad].
using JointAngles = std::array<double, 3>;

/// What the break criterion needs to know of a joint.
struct WatchedJoint {
  double share = 0.0;  ///< where it is, of the beam's length [1]
  double begin = 0.0;  ///< the part of the axis that it stands for [m]
  double end = 0.0;
  double length = 1.0;       ///< tributary l [m]
  double width = 0.0;        ///< b [m]; of a round section its diameter
  double height = 0.0;       ///< h [m]
  double shear_lever = 0.0;  ///< J/W_t [m]
  bool round = false;
  /// Limits of bending about x, about y, torsion, and of bending about both [1]; infinite: none.
  std::array<double, 4> limit{};
};

/// Permanent strains of a chain's joints, and which of them are over their limit (design 2.3).
///
/// A joint's strain is (h/2) Theta/L_p with the hinge length L_p. Where l >= L_p: Theta = theta_p
/// if yielding gathers in one joint, theta_p L_p/l if the law spreads it. Where l < L_p: Theta is
/// the sum of theta_p over the window of length L_p around the joint, cut off at the beam's ends,
/// a joint counting with the share of its length that the window covers. L_p = 0: theta_p over the
/// joint's own length, as in the report.
class BreakWatch {
 public:
  BreakWatch() = default;
  /// @param gathers  whether the law lets yielding gather in one joint (perfect plasticity)
  BreakWatch(const Scene& scene, std::vector<WatchedJoint> joints, bool gathers);

  bool active() const { return active_; }
  double hinge_length() const { return hinge_length_; }
  std::size_t size() const { return joints_.size(); }

  /// Largest strain over its limit minus 1, of all joints; negative: nothing breaks.
  /// @param angles  in the break measure, net or accumulated (joints)
  double excess(const std::vector<JointAngles>& angles) const;

  /// The strain of a joint that is nearest to its limit; the largest of all where there is none.
  double strain(const std::vector<JointAngles>& angles, std::size_t joint) const;

  /// All joints over their limit, with cause, strain and limit.
  std::vector<BrokenJoint> broken(const std::vector<JointAngles>& angles) const;

 private:
  /// Strains of bending about x, about y, torsion and of bending about both.
  std::array<double, 4> strains(const std::vector<JointAngles>& angles, std::size_t joint) const;
  JointAngles windowed(const std::vector<JointAngles>& angles, std::size_t joint) const;

  std::vector<WatchedJoint> joints_;
  double hinge_length_ = 0.0;
  bool gathers_ = true;
  bool report_ = false;
  bool accumulated_ = false;
  bool active_ = false;
};

}  // namespace plastica
