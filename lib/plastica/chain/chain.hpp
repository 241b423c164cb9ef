#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include "plastica/chain/level.hpp"
#include "plastica/model/history.hpp"

/// A chain as the kernels see it: rigid segments 0 … N-1, joint i at the inner end of segment i;
/// joint 0 joins the chain to the ground. Numbers are scalars S, so that lanes may differ in all of
/// them; the shape (how many of what, and where) is one for all lanes.
namespace plastica::chain {

/// A rigid segment, in its own axes.
template <class L>
struct Segment {
  typename L::Point arm;    ///< from its inner to its outer joint [m]
  typename L::Frame inner;  ///< of its inner joint's axes, as seen from the segment
  typename L::Frame outer;  ///< of its outer joint's axes
};

/// How a segment resists acceleration, in its own axes.
template <class L>
struct Inertia {
  using S = typename L::Scalar;
  S mass{};                                         ///< [kg]
  typename L::Point center;                         ///< of mass, from the inner joint [m]
  Mat<S, L::kRotations, L::kRotations> rotational;  ///< about the center of mass [kg m^2]
};

/// A load at a point of a segment, times a history. What acts on a whole segment (gravity, spread
/// loads) acts at its resultant's point.
template <class L>
struct SegmentLoad {
  std::size_t segment = 0;
  std::size_t history = 0;
  typename L::Point arm;    ///< from the inner joint, in the segment's axes [m]
  typename L::Point force;  ///< [N], world axes; a follower's: the segment's
  typename L::Spin moment;  ///< [N m], likewise
  bool follows = false;
};

/// The node of what is inside of a segment.
inline constexpr std::size_t kInside = static_cast<std::size_t>(-1);

/// A rigid constraint of one freedom of a point, which makes a loop of chain and ground:
/// direction . x = target, kept by a multiplier, which is the force along the direction. Rotational
/// constraints hold the spin about an axis, for rigid clamps.
template <class L>
struct LoopConstraint {
  std::size_t support = 0;  ///< of the scene
  std::size_t segment = 0;
  std::size_t node = kInside;  ///< the segment end that it holds, if it holds one
  std::size_t history = 0;
  typename L::Point arm;
  typename L::Point direction;  ///< unit vector; zero for a rotational constraint
  typename L::Spin axis;        ///< unit vector of a rotational constraint, else zero
  typename L::Frame frame;      ///< rotational: the segment's frame where it is held
  typename L::Scalar target;    ///< direction . x of the undeformed beam (less a pillar's gap) [m]
  typename L::Scalar motion;    ///< how far it moves, times the history [m] (rotational: [rad])
  bool rotational = false;
  bool one_sided = false;  ///< the multiplier is not negative: a pillar
  /// Of a twin: the joint whose segment it holds as the constraint before it in the list holds the
  /// segment before, from when the joint lets go. Others act from the beginning.
  std::size_t waits_for = kInside;
};

/// Springs between a point and the ground along the world axes.
template <class L>
struct Spring {
  std::size_t support = 0;
  std::size_t segment = 0;
  std::size_t history = 0;
  typename L::Point arm;
  typename L::Point stiffness;  ///< [N/m]
  typename L::Point rest;       ///< where it carries nothing [m]
  typename L::Point motion;     ///< of the ground, times the history [m]
};

/// A joint between a segment and the ground that acts on rotation alone: the half joint of a clamp
/// off the root, or a rotational spring.
template <class L>
struct GroundJoint {
  std::size_t support = 0;
  std::size_t segment = 0;
  std::size_t node = 0;  ///< the end of the segment at which it is
  std::size_t history = 0;
  std::size_t joint = 0;     ///< number of its law: N, N + 1, …
  bool outer = true;         ///< at the segment's outer end, or at its inner one
  typename L::Frame local;   ///< of its axes, as seen from the segment
  typename L::Frame ground;  ///< of its axes, undeformed
  typename L::Spin motion;   ///< rotation of the ground, times the history [rad]
};

/// How the chain is joined to the ground at its start.
template <class L>
struct Root {
  typename L::Point position;  ///< of joint 0 [m]
  typename L::Frame ground;    ///< of its axes
  typename L::Point motion;    ///< prescribed, times the history [m]
  typename L::Spin rotation;   ///< prescribed, times the history [rad]
  std::size_t history = 0;
  std::array<bool, 3> held{};     ///< translations that the ground holds (kTranslations used)
  std::array<bool, 3> clamped{};  ///< rotations that joint 0 does not let go (kRotations used)
  /// Whether joint 0 stretches and shears where joints do: only if it is the one joint of all and
  /// all translations are held. Else the joints next to both ends have the ends' halves, so that
  /// start and end are alike; and beside a free translation a shift would be the same motion twice.
  bool shifts = false;
  std::optional<std::size_t> support{};  ///< of the scene, if one is at the start
};

/// What a chain knows of a load's or motion's factor over time. Lanes whose times are their own are
/// told it (solve/lane_newton_make.hpp).
template <class L>
struct HistoryOf {
  using Type = History;
};

/// A factor as a scalar: a number, or already one.
template <class S, class Factor>
S factor_as(const Factor& factor) {
  if constexpr (std::is_same_v<S, Factor>) {
    return factor;
  } else {
    return constant<S>(factor);
  }
}

template <class L>
struct Chain {
  using Level = L;
  using S = typename L::Scalar;

  std::vector<Segment<L>> segments;   ///< (N)
  std::vector<Inertia<L>> inertias;   ///< (N)
  std::vector<SegmentLoad<L>> loads;  ///< by rising segment
  std::vector<LoopConstraint<L>> constraints;
  std::vector<Spring<L>> springs;
  std::vector<GroundJoint<L>> ground_joints;
  Root<L> root;
  std::vector<typename HistoryOf<L>::Type> histories;  ///< that the others name
  S length = constant<S>(1);                           ///< of the beam [m]: the scale of gaps
  /// What stiffens the point of a constraint in the factorization without changing the solution
  /// (README.md), along directions [N/m] and about axes [N m/rad].
  S constraint_stiffness = constant<S>(1);
  S constraint_rotational_stiffness = constant<S>(1);

  std::size_t size() const { return segments.size(); }
  /// Joints with a law: those of the segments, then those to the ground.
  std::size_t joints() const { return segments.size() + ground_joints.size(); }
};

}  // namespace plastica::chain
