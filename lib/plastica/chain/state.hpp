#pragma once

#include <cstddef>
#include <vector>

#include "plastica/base/always_inline.hpp"
#include "plastica/chain/chain.hpp"

namespace plastica::chain {

/// A motion of a segment: of its inner joint, and its spin.
template <class L>
struct Motion {
  typename L::Point shift;
  typename L::Spin spin;
};

/// A force on a segment and the moment about its inner joint.
template <class L>
struct Wrench {
  typename L::Point force;
  typename L::Spin moment;

  friend Wrench operator+(const Wrench& a, const Wrench& b) {
    return {a.force + b.force, a.moment + b.moment};
  }
};

/// -d(wrench)/d(motion) of a segment, by blocks.
template <class L>
struct Impedance {
  using S = typename L::Scalar;
  static constexpr std::size_t kT = L::kTranslations;
  static constexpr std::size_t kR = L::kRotations;
  Mat<S, kT, kT> tt;
  Mat<S, kT, kR> tr;
  Mat<S, kR, kT> rt;
  Mat<S, kR, kR> rr;

  Impedance& operator+=(const Impedance& b) {
    tt += b.tt;
    tr += b.tr;
    rt += b.rt;
    rr += b.rr;
    return *this;
  }
};

/// m spun_by(arm), without the zeros of `spun_by`.
template <class L, std::size_t R>
PLASTICA_ALWAYS_INLINE inline Mat<typename L::Scalar, R, L::kRotations> times_spun_by(
    const Mat<typename L::Scalar, R, L::kTranslations>& m, const typename L::Point& arm) {
  Mat<typename L::Scalar, R, L::kRotations> product;
  for_each_of<R>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
    const auto row = block<1, L::kTranslations>(m, i, 0);
    const typename L::Spin moment = L::moment(arm, {row.at});
    put(product, i, 0, Mat<typename L::Scalar, 1, L::kRotations>{moment.at});
  });
  return product;
}

/// spun_by(arm)^T m, likewise.
template <class L, std::size_t C>
PLASTICA_ALWAYS_INLINE inline Mat<typename L::Scalar, L::kRotations, C> spun_by_times(
    const typename L::Point& arm, const Mat<typename L::Scalar, L::kTranslations, C>& m) {
  Mat<typename L::Scalar, L::kRotations, C> product;
  for_each_of<C>([&](std::size_t j) PLASTICA_ALWAYS_INLINE {
    const auto column = block<L::kTranslations, 1>(m, 0, j);
    const typename L::Spin moment = L::moment(arm, {column.at});
    put(product, 0, j, Mat<typename L::Scalar, L::kRotations, 1>{moment.at});
  });
  return product;
}

/// The same impedance about a point before, by way of the arm between; where the arm of virtual
/// work is another, by that.
template <class L>
PLASTICA_ALWAYS_INLINE inline void carry(const typename L::Point& arm,
                                         const typename L::Point& work_arm, Impedance<L>& a) {
  const auto tr = a.tr + times_spun_by<L>(a.tt, arm);
  a.rr += times_spun_by<L>(a.rt, arm) + spun_by_times<L>(work_arm, tr);
  a.rt += spun_by_times<L>(work_arm, a.tt);
  a.tr = tr;
}

/// Number of freedoms of a joint: its rotations, then, with elastic translation, its shifts.
template <class L, bool kElastic>
inline constexpr std::size_t kFreedoms = L::kRotations + (kElastic ? L::kTranslations : 0);

/// Where a segment's inner joint is, and the segment's frame.
template <class L>
struct Pose {
  typename L::Point position;
  typename L::Frame frame;
};

/// What the unknowns of a chain are.
///
/// An open joint lets go of its segment, with which a fragment begins: its pose takes the place of
/// the joint's angle, which keeps the value that it had.
template <class L>
struct Coordinates {
  using Mask = mask_t<typename L::Scalar>;
  std::vector<typename L::Spin> angle;   ///< of each joint (N)
  std::vector<typename L::Point> shift;  ///< of each joint, in its axes; rigid joints: empty (N)
  typename L::Point root;                ///< free translation of the start
  std::vector<typename L::Scalar> multiplier;  ///< of each constraint
  std::vector<Mask> open;                      ///< whether a joint lets go (N)
  std::vector<Pose<L>> pose;                   ///< of the segments outside of open joints (N)
  std::vector<Mask> released_constraint;       ///< whether it was cut, like the next (constraints)
  std::vector<Mask> released_ground_joint;     ///< (ground joints)
};

/// Where the segments are; follows from the coordinates.
template <class L>
struct Placement {
  std::vector<typename L::Frame> frame;     ///< of each segment (N)
  std::vector<typename L::Point> position;  ///< of each inner joint [m] (N)
  std::vector<typename L::Frame> near;      ///< axes of each joint on its inner side (N)
  std::vector<typename L::Frame> far;       ///< and on its outer side (N)

  void resize(std::size_t n) {
    frame.resize(n);
    position.resize(n);
    near.resize(n);
    far.resize(n);
  }
  typename L::Point point(std::size_t segment, const typename L::Point& arm) const {
    return position[segment] + L::rotate(frame[segment], arm);
  }
};

/// Where the forces of a step act, if not where it ends: half way, by the means of the placements
/// at its begin and end. With them the step keeps momentum and angular momentum, and what
/// constraints and joints transmit does no work of its own (README.md).
template <class L>
struct Stage {
  static constexpr std::size_t kR = L::kRotations;
  using S = typename L::Scalar;
  bool midpoint = false;  ///< else forces act where the step ends
  /// How far their arms and axes follow a motion of the end: half of it half way; not at all where
  /// velocities or accelerations are sought.
  double follows = 1.0;
  Placement<L> placement;                   ///< means; frames are no rotations (N)
  std::vector<typename L::Point> shift;     ///< means, of elastic joints (N)
  std::vector<Mat<S, kR, kR>> to_joint;     ///< moments to the axes of each joint's step spin (N)
  std::vector<Mat<S, kR, kR>> from_joint;   ///< and back (N)
  std::vector<Mat<S, kR, kR>> ground_axes;  ///< and of ground joints back to the world

  S fraction() const { return constant<S>(follows); }
  const Placement<L>& of(const Placement<L>& end) const { return midpoint ? placement : end; }
};

/// What the laws say of each joint: its moments as they work on spins and shifts, and their slope.
template <class L, bool kElastic>
struct JointForces {
  static constexpr std::size_t kJ = kFreedoms<L, kElastic>;
  using S = typename L::Scalar;
  std::vector<Vec<S, kJ>> force;        ///< (joints)
  std::vector<Mat<S, kJ, kJ>> tangent;  ///< (joints)
  /// Given to laws that see it: axial force of each joint, of those that stretch not read [N];
  /// empty: none is given (joints).
  std::vector<S> axial;
  /// Then: d(moment as it works on spins)/d(axial force) [m] (joints).
  std::vector<typename L::Spin> by_axial;
};

/// A force at a node, and how it changes as the segment that it acts on moves by (shift, spin):
/// d force = -tt shift - tr spin.
template <class L>
struct NodeForce {
  using S = typename L::Scalar;
  typename L::Point force;
  Mat<S, L::kTranslations, L::kTranslations> tt;
  Mat<S, L::kTranslations, L::kRotations> tr;
};

/// How the axial forces of joints that do not stretch, N = along . force, follow from equilibrium:
/// axial.hpp.
template <class L>
struct AxialForces {
  /// t: the joint's axis, half way between its sides, of unit length (joints).
  std::vector<typename L::Point> along;
  /// f: what is beyond the joint puts on it [N] (joints).
  std::vector<typename L::Point> force;
  /// f across t, over the length of the mean of both sides' axes: f . dt is that times the change
  /// of the mean [N] (joints).
  std::vector<typename L::Point> across;
  NodeForce<L> at_start;                ///< what acts at the node of joint 0
  std::vector<NodeForce<L>> at_ground;  ///< at that of each joint to the ground (ground joints)
  /// Of joints to the ground: d(moment on the segment, in world axes)/d(axial force) [m]
  /// (ground joints).
  std::vector<typename L::Spin> ground_by_axial;

  /// Whether moments follow them in the tangent.
  bool acts() const { return !along.empty(); }
  void resize(std::size_t joints, std::size_t ground_joints) {
    along.resize(joints);
    force.resize(joints);
    across.resize(joints);
    at_ground.resize(ground_joints);
    ground_by_axial.resize(ground_joints);
  }
};

}  // namespace plastica::chain
