#pragma once

#include <cstddef>
#include <vector>

#include "plastica/chain/loads.hpp"

/// Axial forces of joints that do not stretch, from equilibrium (README.md, "Axial force").
namespace plastica::chain {

/// The axis along the beam among a level's own.
template <class L>
inline typename L::Point along_beam() {
  typename L::Point axis;
  if constexpr (L::kTranslations > 0) {
    axis[L::kTranslations == 3 ? 2 : 0] = constant<typename L::Scalar>(1);
  }
  return axis;
}

/// Whether two points of a segment are one.
template <class L>
inline bool same_node(const Chain<L>& chain, const typename L::Point& a,
                      const typename L::Point& b) {
  using S = typename L::Scalar;
  constexpr double kSame = kIsDouble<S> ? 1e-9 : 1e-5;  // of the length
  const typename L::Point between = a - b;
  const S limit = constant<S>(kSame * kSame) * chain.length * chain.length;
  return !any(dot(between, between) > limit);
}

/// Whether a point of a segment is the end that a joint to the ground is at.
template <class L>
inline bool at_ground_joint(const Chain<L>& chain, const GroundJoint<L>& joint, std::size_t segment,
                            const typename L::Point& arm) {
  const typename L::Point end = joint.outer ? chain.segments[segment].arm : typename L::Point{};
  return joint.segment == segment && same_node(chain, arm, end);
}
/// How what acts on the segment at its node counts in the axial force of a joint to the ground,
/// which is that of the beam within: beyond an outer end it is added to what is beyond, at an inner
/// end it is of what is beyond, and does not count.
template <class S>
inline S node_sign(bool outer) {
  return constant<S>(outer ? 1 : -1);
}
template <class L>
inline bool at_start(const Chain<L>& chain, std::size_t segment, const typename L::Point& arm) {
  return segment == 0 && same_node(chain, arm, typename L::Point{});
}

namespace detail {

/// Adds a force to the node that it acts at, if that is one of a joint to the ground.
template <class L, class Add>
void at_nodes(const Chain<L>& chain, std::size_t segment, const typename L::Point& arm,
              AxialForces<L>& axial, const Add& add) {
  if (at_start(chain, segment, arm)) add(axial.at_start);
  for (std::size_t g = 0; g < chain.ground_joints.size(); ++g) {
    if (at_ground_joint(chain, chain.ground_joints[g], segment, arm)) add(axial.at_ground[g]);
  }
}

template <class L, class FactorAt>
void set_node_forces(const Chain<L>& chain, const Coordinates<L>& q, const Placement<L>& placement,
                     const std::vector<mask_t<typename L::Scalar>>& closed,
                     const FactorAt& factor_at, AxialForces<L>& axial) {
  using S = typename L::Scalar;
  axial.at_start = {};
  for (NodeForce<L>& node : axial.at_ground) node = {};
  for (const SegmentLoad<L>& load : chain.loads) {
    at_nodes(chain, load.segment, load.arm, axial, [&](NodeForce<L>& node) {
      const typename L::Point force =
          factor_as<S>(factor_at(load.history)) * unit_wrench(load, placement).force;
      node.force += force;
      if (load.follows) node.tr -= L::spun_by(force);
    });
  }
  for (const Spring<L>& spring : chain.springs) {
    at_nodes(chain, spring.segment, spring.arm, axial, [&](NodeForce<L>& node) {
      const typename L::Point arm = L::rotate(placement.frame[spring.segment], spring.arm);
      const typename L::Point off = placement.position[spring.segment] + arm - spring.rest -
                                    factor_as<S>(factor_at(spring.history)) * spring.motion;
      Mat<S, L::kTranslations, L::kTranslations> k;
      for (std::size_t i = 0; i < L::kTranslations; ++i) k(i, i) = spring.stiffness[i];
      node.force -= k * off;
      node.tt += k;
      node.tr += k * L::spun_by(arm);
    });
  }
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    const LoopConstraint<L>& constraint = chain.constraints[k];
    if (constraint.rotational) continue;
    at_nodes(chain, constraint.segment, constraint.arm, axial, [&](NodeForce<L>& node) {
      node.force += select(closed[k], q.multiplier[k], constant<S>(0)) * constraint.direction;
    });
  }
}

}  // namespace detail

/// Of a joint to the ground, the mean of the axes of the segment's side and the ground's.
template <class L>
inline typename L::Point ground_joint_mean(const Chain<L>& chain, const GroundJoint<L>& joint,
                                           const Placement<L>& placement, double time) {
  using S = typename L::Scalar;
  const S factor = factor_as<S>(chain.histories[joint.history].at(time));
  const typename L::Frame ground = L::compose(L::rotation(factor * joint.motion), joint.ground);
  const typename L::Point e = along_beam<L>();
  return constant<S>(0.5) *
         (L::rotate(ground_joint_axes(joint, placement), e) + L::rotate(ground, e));
}

/// Finds the axial force of each joint: of what is beyond it; of joint 0 and of joints to the
/// ground that of the beam beside the node, so that start and end are alike. (Loads and springs at
/// an inner node act half on either segment: `Builder`.)
/// @param wrench  on the segments: their forces count (N)
/// @param forces  N of each joint [N] (joints)
template <class L, class FactorAt>
void find_axial_forces(const Chain<L>& chain, const Coordinates<L>& q,
                       const Placement<L>& placement,
                       const std::vector<mask_t<typename L::Scalar>>& closed, double time,
                       const FactorAt& factor_at, const std::vector<Wrench<L>>& wrench,
                       AxialForces<L>& axial, std::vector<typename L::Scalar>& forces) {
  using S = typename L::Scalar;
  axial.resize(chain.joints(), chain.ground_joints.size());
  forces.resize(chain.joints());
  detail::set_node_forces(chain, q, placement, closed, factor_at, axial);
  const typename L::Point e = along_beam<L>();
  typename L::Point beyond{};
  for (std::size_t i = chain.size(); i-- > 0;) {
    beyond += wrench[i].force;
    if (any(q.open[i])) beyond = select(q.open[i], {}, beyond);
    axial.force[i] = beyond;
    axial.along[i] =
        constant<S>(0.5) * (L::rotate(placement.near[i], e) + L::rotate(placement.far[i], e));
  }
  for (std::size_t g = 0; g < chain.ground_joints.size(); ++g) {
    const GroundJoint<L>& joint = chain.ground_joints[g];
    const std::size_t next = joint.segment + (joint.outer ? 1 : 0);
    axial.force[joint.joint] = node_sign<S>(joint.outer) * axial.at_ground[g].force;
    if (next < chain.size()) axial.force[joint.joint] += axial.force[next];
    axial.along[joint.joint] = ground_joint_mean(chain, joint, placement, time);
  }
  axial.force[0] -= axial.at_start.force;
  // Turned by pi a joint has no axis half way.
  const S least = constant<S>(1e-3);
  for (std::size_t j = 0; j < chain.joints(); ++j) {
    typename L::Point& along = axial.along[j];
    const S inverse = constant<S>(1) / max(size_of(along), least);
    along = inverse * along;
    forces[j] = dot(along, axial.force[j]);
    axial.across[j] = inverse * (axial.force[j] - forces[j] * along);
  }
}

/// Adds what joints to the ground do, and to the tangent how their moments follow their axial
/// forces; but for the forces beyond them, which the recursion knows.
template <bool kElastic, class L>
void add_ground_joints_with_axial(const Chain<L>& chain, const Coordinates<L>& q,
                                  const Stage<L>& stage, const Placement<L>& placement,
                                  const JointForces<L, kElastic>& joints,
                                  OuterForces<L>& outer_forces) {
  using S = typename L::Scalar;
  detail::add_ground_joints(chain, q, stage, placement, joints, outer_forces);
  AxialForces<L>& axial = outer_forces.axial;
  const typename L::Point e = along_beam<L>();
  for (std::size_t g = 0; g < chain.ground_joints.size(); ++g) {
    const GroundJoint<L>& joint = chain.ground_joints[g];
    const typename L::Frame axes = ground_joint_axes(joint, placement);
    const typename L::Spin by =
        select(q.released_ground_joint[g], {}, L::axes(axes) * joints.by_axial[joint.joint]);
    axial.ground_by_axial[g] = by;
    const NodeForce<L>& node = axial.at_ground[g];
    const S sign = node_sign<S>(joint.outer);
    const typename L::Point& along = axial.along[joint.joint];
    const typename L::Spin rotated =
        L::moment(constant<S>(0.5) * L::rotate(axes, e), axial.across[joint.joint]);
    Impedance<L>& impedance = outer_forces.impedance[joint.segment];
    impedance.rt += outer(by, sign * transposed_times(node.tt, along));
    impedance.rr += outer(by, sign * transposed_times(node.tr, along) - rotated);
  }
}

}  // namespace plastica::chain
