#pragma once

#include <vector>

#include "plastica/chain/placement.hpp"

/// What acts on each segment from outside, and how it changes as the segment moves.
namespace plastica::chain {

/// Wrenches on the segments and their impedances, about the inner joints.
template <class L>
struct OuterForces {
  std::vector<Wrench<L>> wrench;        ///< (N)
  std::vector<Impedance<L>> impedance;  ///< (N)
  AxialForces<L> axial;                 ///< where laws see them, in statics
  /// Largest component of the force of a spring to the ground [N]: of a bed that carries each load
  /// where it acts, so that no joint has a force, it is what an imbalance is small against.
  typename L::Scalar largest_spring{};
  /// Sums of the sizes of what loads act with [N], [N m]: where all of it goes straight into a
  /// support, the beam has no force, and their rounding is all that is left of an imbalance.
  typename L::Scalar sum_of_forces{};
  typename L::Scalar sum_of_moments{};

  void reset(std::size_t n, bool slopes = true) {
    wrench.assign(n, {});
    if (slopes) impedance.assign(n, {});
    largest_spring = sum_of_forces = sum_of_moments = constant<typename L::Scalar>(0);
  }
};

/// Force and moment of a load at a unit factor, in world axes, with the arm that it has now.
template <class L>
inline Wrench<L> unit_wrench(const SegmentLoad<L>& load, const Placement<L>& placement) {
  const typename L::Frame& frame = placement.frame[load.segment];
  const typename L::Point arm = L::rotate(frame, load.arm);
  if (!load.follows) return {load.force, L::moment(arm, load.force) + load.moment};
  const typename L::Point force = L::rotate(frame, load.force);
  return {force, L::moment(arm, force) + L::axes(frame) * load.moment};
}

/// The wrench of a constraint at a unit multiplier: also its motion's derivative by that of its
/// segment.
template <class L>
inline Wrench<L> unit_wrench(const LoopConstraint<L>& constraint, const Placement<L>& placement) {
  const typename L::Point arm = L::rotate(placement.frame[constraint.segment], constraint.arm);
  return {constraint.direction, L::moment(arm, constraint.direction) + constraint.axis};
}

/// How far a constraint's point is beyond its target, along its direction.
template <class L>
inline typename L::Scalar constraint_gap(const Chain<L>& chain, const LoopConstraint<L>& constraint,
                                         const Placement<L>& placement, double time) {
  using S = typename L::Scalar;
  const S factor = factor_as<S>(chain.histories[constraint.history].at(time));
  if (constraint.rotational) {
    const typename L::Spin rotated =
        L::axes(constraint.frame) *
        L::angle_from(constraint.frame, placement.frame[constraint.segment]);
    return dot(constraint.axis, rotated) - factor * constraint.motion;
  }
  const typename L::Point at = placement.point(constraint.segment, constraint.arm);
  return dot(constraint.direction, at) - constraint.target - factor * constraint.motion;
}

namespace detail {

/// Stiffness K along world axes at the end of an arm: P^T K P with P = [1, spun_by(arm)].
template <class L>
inline void add_point_stiffness(
    const Mat<typename L::Scalar, L::kTranslations, L::kTranslations>& k,
    const typename L::Point& arm, Impedance<L>& impedance) {
  const auto by = L::spun_by(arm);
  const auto k_by = k * by;
  impedance.tt += k;
  impedance.tr += k_by;
  impedance.rt += transpose(by) * k;
  impedance.rr += transpose(by) * k_by;
}

template <class L, class FactorAt>
void add_loads(const Chain<L>& chain, const Placement<L>& placement, const FactorAt& factor_at,
               const typename L::Scalar& fraction, OuterForces<L>& outer_forces,
               bool slopes = true) {
  using S = typename L::Scalar;
  for (const SegmentLoad<L>& load : chain.loads) {
    const S factor = factor_as<S>(factor_at(load.history));
    const S slope = fraction * factor;
    const Wrench<L> unit = unit_wrench(load, placement);
    Wrench<L>& wrench = outer_forces.wrench[load.segment];
    Impedance<L>& impedance = outer_forces.impedance[load.segment];
    wrench.force += factor * unit.force;
    wrench.moment += factor * unit.moment;
    for (std::size_t k = 0; k < L::kTranslations; ++k) {
      outer_forces.sum_of_forces = outer_forces.sum_of_forces + abs(factor * unit.force[k]);
    }
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      outer_forces.sum_of_moments = outer_forces.sum_of_moments + abs(factor * unit.moment[k]);
    }
    if (!slopes) continue;
    if (load.follows) {
      impedance.tr -= slope * L::spun_by(unit.force);
      impedance.rr -= slope * L::spin_derivative(unit.moment);
    } else {
      const typename L::Point arm = L::rotate(placement.frame[load.segment], load.arm);
      impedance.rr -= slope * L::moment_by(arm, load.force);
    }
  }
}

template <class L, class FactorAt>
void add_springs(const Chain<L>& chain, const Placement<L>& placement, const FactorAt& factor_at,
                 const typename L::Scalar& fraction, OuterForces<L>& outer_forces) {
  using S = typename L::Scalar;
  for (const Spring<L>& spring : chain.springs) {
    const S factor = factor_as<S>(factor_at(spring.history));
    const typename L::Point arm = L::rotate(placement.frame[spring.segment], spring.arm);
    const typename L::Point off =
        placement.position[spring.segment] + arm - spring.rest - factor * spring.motion;
    Mat<S, L::kTranslations, L::kTranslations> k;
    typename L::Point force;
    for (std::size_t i = 0; i < L::kTranslations; ++i) {
      k(i, i) = spring.stiffness[i];
      force[i] = -(spring.stiffness[i] * off[i]);
      outer_forces.largest_spring = max(outer_forces.largest_spring, abs(force[i]));
    }
    Impedance<L>& impedance = outer_forces.impedance[spring.segment];
    add_point_stiffness(fraction * k, arm, impedance);
    impedance.rr -= fraction * L::moment_by(arm, force);
    outer_forces.wrench[spring.segment].force += force;
    outer_forces.wrench[spring.segment].moment += L::moment(arm, force);
  }
}

template <bool kElastic, class L>
void add_ground_joints(const Chain<L>& chain, const Coordinates<L>& q, const Stage<L>& stage,
                       const Placement<L>& placement, const JointForces<L, kElastic>& joints,
                       OuterForces<L>& outer_forces) {
  using S = typename L::Scalar;
  for (std::size_t g = 0; g < chain.ground_joints.size(); ++g) {
    const GroundJoint<L>& joint = chain.ground_joints[g];
    const auto whole =
        stage.midpoint ? stage.ground_axes[g] : L::axes(ground_joint_axes(joint, placement));
    const auto axes = select(q.released_ground_joint[g], {}, whole);
    typename L::Spin force;
    Mat<S, L::kRotations, L::kRotations> tangent;
    for (std::size_t i = 0; i < L::kRotations; ++i) {
      force[i] = joints.force[joint.joint][i];
      for (std::size_t j = 0; j < L::kRotations; ++j) {
        tangent(i, j) = joints.tangent[joint.joint](i, j);
      }
    }
    const typename L::Spin moment = axes * force;
    outer_forces.wrench[joint.segment].moment += moment;
    outer_forces.impedance[joint.segment].rr +=
        axes * tangent * transpose(axes) - stage.fraction() * L::spin_derivative(moment);
  }
}

}  // namespace detail

/// The force of each constraint now, and the stiffness that the factorization gives its point: both
/// zero where a one-sided constraint is open.
/// @param placement  where the segments are, and move from
template <class L>
void add_constraints(const Chain<L>& chain, const Placement<L>& placement, const Stage<L>& stage,
                     const Coordinates<L>& q, const std::vector<mask_t<typename L::Scalar>>& closed,
                     OuterForces<L>& outer_forces) {
  using S = typename L::Scalar;
  const S zero = constant<S>(0);
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    const LoopConstraint<L>& constraint = chain.constraints[k];
    const S force = select(closed[k], q.multiplier[k], zero);
    const Wrench<L> unit = unit_wrench(constraint, stage.of(placement));
    const Wrench<L> along = unit_wrench(constraint, placement);
    Wrench<L>& wrench = outer_forces.wrench[constraint.segment];
    Impedance<L>& impedance = outer_forces.impedance[constraint.segment];
    wrench.force += force * unit.force;
    wrench.moment += force * unit.moment;
    const S whole =
        constraint.rotational ? chain.constraint_rotational_stiffness : chain.constraint_stiffness;
    const S stiffness = select(closed[k], whole, zero);
    impedance.tt += outer(stiffness * unit.force, along.force);
    impedance.tr += outer(stiffness * unit.force, along.moment);
    impedance.rt += outer(stiffness * unit.moment, along.force);
    impedance.rr += outer(stiffness * unit.moment, along.moment);
    if (constraint.rotational) continue;
    const typename L::Point arm = L::rotate(placement.frame[constraint.segment], constraint.arm);
    impedance.rr -= (stage.fraction() * force) * L::moment_by(arm, constraint.direction);
  }
}

/// What loads and springs do.
/// @param factor_at  the factor of a history, by its number
/// @param slopes     without, impedances are left as they are, or added to
template <class L, class FactorAt>
void gather_loads(const Chain<L>& chain, const Placement<L>& placement, const Stage<L>& stage,
                  const FactorAt& factor_at, OuterForces<L>& outer_forces, bool slopes = true) {
  outer_forces.reset(chain.size(), slopes);
  detail::add_loads(chain, stage.of(placement), factor_at, stage.fraction(), outer_forces, slopes);
  detail::add_springs(chain, stage.of(placement), factor_at, stage.fraction(), outer_forces);
}

/// All that acts on the segments but constraints.
template <bool kElastic, class L, class FactorAt>
void gather_forces(const Chain<L>& chain, const Coordinates<L>& q, const Placement<L>& placement,
                   const Stage<L>& stage, const JointForces<L, kElastic>& joints,
                   const FactorAt& factor_at, OuterForces<L>& outer_forces, bool slopes = true) {
  gather_loads(chain, placement, stage, factor_at, outer_forces, slopes);
  detail::add_ground_joints(chain, q, stage, placement, joints, outer_forces);
}

}  // namespace plastica::chain
