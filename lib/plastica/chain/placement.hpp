#pragma once

#include "plastica/chain/state.hpp"

namespace plastica::chain {

/// The ground's frame at joint 0 at a time, with its prescribed rotation.
template <class L>
inline typename L::Frame root_frame(const Chain<L>& chain, double time) {
  const auto factor = factor_as<typename L::Scalar>(chain.histories[chain.root.history].at(time));
  return L::compose(L::rotation(factor * chain.root.rotation), chain.root.ground);
}

/// Places a segment with which a fragment begins, in the lanes where it does.
template <class L>
void place_fragment(const Segment<L>& segment, const Pose<L>& pose,
                    const mask_t<typename L::Scalar>& open, std::size_t i,
                    Placement<L>& placement) {
  const typename L::Frame joint = L::compose(pose.frame, segment.inner);
  placement.near[i] = L::select(open, joint, placement.near[i]);
  placement.far[i] = L::select(open, joint, placement.far[i]);
  placement.frame[i] = L::select(open, pose.frame, placement.frame[i]);
  placement.position[i] = select(open, pose.position, placement.position[i]);
}

/// Places the segments from the root outwards; so a joint's gap is nothing but its own shift.
/// @param note  is handed the rotation of each joint: (number, frame)
template <bool kElastic, class L, class Note>
void place(const Chain<L>& chain, const Coordinates<L>& q, double time, Placement<L>& placement,
           const Note& note) {
  using S = typename L::Scalar;
  const S factor = factor_as<S>(chain.histories[chain.root.history].at(time));
  typename L::Frame near = root_frame(chain, time);
  typename L::Point at = chain.root.position + factor * chain.root.motion + q.root;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Segment<L>& segment = chain.segments[i];
    const typename L::Frame rotation = L::rotation(q.angle[i]);
    note(i, rotation);
    const typename L::Frame far = L::compose(near, rotation);
    if constexpr (kElastic) {
      at += constant<S>(0.5) * (L::rotate(near, q.shift[i]) + L::rotate(far, q.shift[i]));
    }
    placement.near[i] = near;
    placement.far[i] = far;
    placement.frame[i] = L::compose_inverse(far, segment.inner);
    placement.position[i] = at;
    if (any(q.open[i])) place_fragment(segment, q.pose[i], q.open[i], i, placement);
    at = placement.position[i] + L::rotate(placement.frame[i], segment.arm);
    near = L::compose(placement.frame[i], segment.outer);
  }
}

template <bool kElastic, class L>
void place(const Chain<L>& chain, const Coordinates<L>& q, double time, Placement<L>& placement) {
  place<kElastic>(chain, q, time, placement, [](std::size_t, const typename L::Frame&) {});
}

/// The rotation vector of a joint to the ground, from the segment's side, and its axes there.
template <class L>
inline typename L::Frame ground_joint_axes(const GroundJoint<L>& joint,
                                           const Placement<L>& placement) {
  return L::compose(placement.frame[joint.segment], joint.local);
}

template <class L>
inline typename L::Spin ground_joint_angle(const Chain<L>& chain, const GroundJoint<L>& joint,
                                           const Placement<L>& placement, double time) {
  const auto factor = factor_as<typename L::Scalar>(chain.histories[joint.history].at(time));
  const typename L::Frame ground = L::compose(L::rotation(factor * joint.motion), joint.ground);
  return L::angle_from(ground_joint_axes(joint, placement), ground);
}

}  // namespace plastica::chain
