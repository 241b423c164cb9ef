#pragma once

#include <cstddef>
#include <vector>

#include "plastica/solve/newton_step.hpp"
#include "plastica/solve/segment_motion.hpp"

/// Velocities and accelerations that the joints and supports of a placed chain allow: the recursion
/// with nothing but inertia in it.
namespace plastica::solve {

/// What a velocity of each constraint must be, once they act.
template <class L>
struct ConstraintRates {
  std::vector<mask_t<typename L::Scalar>> acts;  ///< (constraints)
  std::vector<typename L::Scalar> rate;          ///< along the constraint's direction (constraints)
};

/// What joints that do not accelerate would give each segment; memory of `set_accelerations`.
template <class L>
struct CarriedMotion {
  std::vector<typename L::Point> shift;  ///< of its inner joint (N)
  std::vector<typename L::Spin> spin;    ///< (N)
};

/// How the factor of a support's history changes.
template <class S>
struct SupportRates {
  S slope{};      ///< [1/s]
  S curvature{};  ///< [1/s^2]
};

/// A constraint moves nothing that is free if a unit impulse along it does less than this fraction
/// of what it would do to the beam's mass, free; or nothing but rounding, once those before it
/// hold.
template <class S>
inline constexpr double kHoldsNothing = kIsDouble<S> ? 1e-10 : 1e-6;

namespace detail {

/// Factors the chain with its inertia alone.
template <class L, bool kElastic>
void factor_inertia(const chain::Chain<L>& chain, const chain::Stage<L>& stage,
                    const chain::JointForces<L, kElastic>& laws, NewtonWork<L, kElastic>& w) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    w.outer_forces.impedance[i] = inertia_impedance(chain.inertias[i], w.placement.frame[i]);
  }
  w.recursion.factor(chain, w.q, w.placement, stage, laws, w.outer_forces, w.impulses);
}

/// Solves for a right-hand side (w.right) under the constraints' conditions; leaves the motion in
/// w.columns[0] and the constraints' impulses in w.small.
/// @return whether every active constraint has something to hold
template <class L, bool kElastic>
mask_t<typename L::Scalar> solve_rates(const chain::Chain<L>& chain,
                                       const ConstraintRates<L>& constraints, bool with_balance,
                                       NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  w.recursion.solve(w.right, with_balance, w.columns[0]);
  S mass = zero;
  S rotational = zero;
  for (const chain::Inertia<L>& inertia : chain.inertias) {
    mass = mass + inertia.mass;
    for (std::size_t k = 0; k < L::kRotations; ++k)
      rotational = max(rotational, inertia.rotational(k, k));
  }
  rotational = rotational + mass * chain.length * chain.length;
  mask_t<S> all_hold = in_all_lanes<S>(true);
  const std::size_t count = chain.constraints.size();
  for (std::size_t k = 0; k < count; ++k) {
    const auto& constraint = chain.constraints[k];
    w.right.reset(chain.size());
    w.right.wrench[constraint.segment] = chain::unit_wrench(constraint, w.placement);
    w.recursion.solve(w.right, false, w.columns[1 + k]);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const auto& constraint = chain.constraints[k];
    const auto wrench = chain::unit_wrench(constraint, w.placement);
    for (std::size_t j = 0; j < count; ++j) {
      const S moved = power(wrench, w.columns[1 + j].motion[constraint.segment]);
      w.small.a(k, j) = select(constraints.acts[k], select(constraints.acts[j], moved, zero),
                               k == j ? one : zero);
    }
    w.small.a(k, count) = zero;
    w.small.a(count, k) = zero;
    const S residual = constraints.rate[k] - power(wrench, w.columns[0].motion[constraint.segment]);
    w.small.b(k) = select(constraints.acts[k], residual, zero);
  }
  w.small.a(count, count) = one;
  w.small.b(count) = zero;
  w.pivots = w.small;
  w.pivots.for_each_pivot(count, [&](std::size_t k, const S& left) {
    const S free = one / (chain.constraints[k].rotational ? rotational : mass);
    const S alone = w.small.a(k, k);
    const mask_t<S> holds = (alone > constant<S>(kHoldsNothing<S>) * free) &
                            (abs(left) > constant<S>(kRoundedPivot<S>) * alone);
    all_hold = all_hold & ((!constraints.acts[k]) | holds);
  });
  w.small.solve();
  auto& sum = w.columns[0];
  for (std::size_t k = 0; k < count; ++k) {
    const S weight = select(constraints.acts[k], w.small.b(k), zero);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      sum.motion[i].shift += weight * w.columns[1 + k].motion[i].shift;
      sum.motion[i].spin += weight * w.columns[1 + k].motion[i].spin;
    }
  }
  return all_hold;
}

}  // namespace detail

/// Makes velocities such as joints and constraints allow, by impulses: of all such velocities those
/// whose kinetic distance to the given ones is least. What the joints pass on is impulsive; their
/// laws are not asked.
/// @param ground  how the ground moves at the root
/// @return whether every constraint has something to hold
template <class L, bool kElastic>
mask_t<typename L::Scalar> make_velocities_fit(const chain::Chain<L>& chain,
                                               const ConstraintRates<L>& constraints,
                                               const chain::Motion<L>& ground,
                                               const chain::JointForces<L, kElastic>& no_laws,
                                               const chain::Stage<L>& no_motion,
                                               std::vector<SegmentMotion<L>>& motion,
                                               NewtonWork<L, kElastic>& w) {
  w.outer_forces.reset(chain.size());
  detail::factor_inertia(chain, no_motion, no_laws, w);
  w.right.reset(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const chain::Inertia<L>& inertia = chain.inertias[i];
    const auto& frame = w.placement.frame[i];
    const typename L::Point momentum = inertia.mass * motion[i].velocity;
    w.right.wrench[i] = {momentum, angular_momentum(inertia, frame, motion[i].spin) +
                                       L::moment(L::rotate(frame, inertia.center), momentum)};
  }
  w.right.ground = ground;
  const auto all_hold = detail::solve_rates(chain, constraints, false, w);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const chain::Motion<L>& moves = w.columns[0].motion[i];
    const auto& frame = w.placement.frame[i];
    motion[i].velocity =
        moves.shift + L::spun(moves.spin, L::rotate(frame, chain.inertias[i].center));
    motion[i].spin = transposed_times(L::axes(frame), moves.spin);
  }
  return all_hold;
}

/// The accelerations of a chain under the forces in `w` (assembled, without inertia), for the
/// beginning of a scheme that carries them. Shifts of elastic joints are taken as at rest.
/// @param rates  which constraints act; their rates are set
/// @param support_at  SupportRates of a history, by its number
template <class L, bool kElastic, class SupportAt>
void set_accelerations(const chain::Chain<L>& chain, const chain::JointForces<L, kElastic>& laws,
                       const chain::Stage<L>& no_motion, CarriedMotion<L>& carried_motion,
                       ConstraintRates<L>& rates, const SupportAt& support_at,
                       std::vector<SegmentMotion<L>>& motion, NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  detail::factor_inertia(chain, no_motion, laws, w);
  w.right.reset(chain.size());
  const SupportRates<S> root = support_at(chain.root.history);
  w.right.ground = {root.curvature * chain.root.motion, root.curvature * chain.root.rotation};
  // Arms and joint axes are carried along.
  std::vector<typename L::Point>& carried = carried_motion.shift;
  std::vector<typename L::Spin>& spin_acceleration = carried_motion.spin;
  typename L::Point at{};
  typename L::Spin spin_rate{};
  typename L::Spin inner_spin = root.slope * chain.root.rotation;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto& frame = w.placement.frame[i];
    const typename L::Spin spin = L::axes(frame) * motion[i].spin;
    if (any(w.q.open[i])) {
      at = select(w.q.open[i], {}, at);
      spin_rate = select(w.q.open[i], {}, spin_rate);
      inner_spin = select(w.q.open[i], spin, inner_spin);
    }
    // d/dt of (axes x rate) at a constant rate: the inner side's spin x the relative one.
    spin_rate += L::spin_derivative(spin - inner_spin) * inner_spin;
    const auto centripetal = [&](const typename L::Point& arm) {
      return L::spun(spin_rate, arm) + L::spun(spin, L::spun(spin, arm));
    };
    carried[i] = at;
    spin_acceleration[i] = spin_rate;
    const chain::Inertia<L>& inertia = chain.inertias[i];
    const typename L::Point arm = L::rotate(frame, inertia.center);
    const typename L::Point force = inertia.mass * (at + centripetal(arm));
    const typename L::Spin momentum = inertia.rotational * motion[i].spin;
    const auto axes = L::axes(frame);
    const typename L::Spin moment = axes * (inertia.rotational * transposed_times(axes, spin_rate) +
                                            L::spin_derivative(momentum) * motion[i].spin);
    w.right.wrench[i] = {-force, -(moment + L::moment(arm, force))};
    at += centripetal(L::rotate(frame, chain.segments[i].arm));
    inner_spin = spin;
  }
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    const auto& constraint = chain.constraints[k];
    const std::size_t i = constraint.segment;
    const auto& frame = w.placement.frame[i];
    const typename L::Spin spin = L::axes(frame) * motion[i].spin;
    const typename L::Point arm = L::rotate(frame, constraint.arm);
    const typename L::Point bias =
        carried[i] + L::spun(spin_acceleration[i], arm) + L::spun(spin, L::spun(spin, arm));
    const S moved = support_at(constraint.history).curvature * constraint.motion;
    rates.rate[k] =
        moved - (dot(constraint.direction, bias) + dot(constraint.axis, spin_acceleration[i]));
  }
  detail::solve_rates(chain, rates, true, w);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto& frame = w.placement.frame[i];
    const chain::Motion<L>& moves = w.columns[0].motion[i];
    const typename L::Spin spin = L::axes(frame) * motion[i].spin;
    const typename L::Spin spins = moves.spin + spin_acceleration[i];
    const typename L::Point arm = L::rotate(frame, chain.inertias[i].center);
    motion[i].acceleration =
        moves.shift + carried[i] + L::spun(spins, arm) + L::spun(spin, L::spun(spin, arm));
    motion[i].spin_rate = transposed_times(L::axes(frame), spins);
    motion[i].resisting = motion[i].acceleration;
    motion[i].resisting_spin_rate = motion[i].spin_rate;
  }
}

}  // namespace plastica::solve
