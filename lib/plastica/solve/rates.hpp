#pragma once

#include <cstddef>
#include <vector>

#include "plastica/solve/newton_step.hpp"
#include "plastica/solve/segment_motion.hpp"

/// Velocities and accelerations that the joints and supports of a placed chain allow: the recursion
/// with nothing but inertia in it.
namespace plastica::solve {

/// What a velocity of each closure must be, once they act.
template <class L>
struct ClosureRates {
  std::vector<mask_t<typename L::Scalar>> acts;  ///< (closures)
  std::vector<typename L::Scalar> rate;          ///< along the closure's direction (closures)
};

/// What joints that do not accelerate would give each segment; memory of `set_accelerations`.
template <class L>
struct CarriedMotion {
  std::vector<typename L::Point> shift;  ///< of its inner joint (N)
  std::vector<typename L::Spin> spin;    ///< (N)
};

/// A closure moves nothing that is free if a unit impulse along it does less than this fraction of
/// what it would do to the beam's mass, free.
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

/// Solves for a right-hand side (w.right) under the closures' conditions; leaves the motion in
/// w.columns[0] and the closures' impulses in w.small.
/// @return whether every acting closure has something to hold
template <class L, bool kElastic>
bool solve_rates(const chain::Chain<L>& chain, const ClosureRates<L>& closures, bool with_balance,
                 NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  w.recursion.solve(w.right, with_balance, w.columns[0]);
  S mass = zero;
  S turning = zero;
  for (const chain::Inertia<L>& inertia : chain.inertias) {
    mass = mass + inertia.mass;
    for (std::size_t k = 0; k < L::kRotations; ++k) turning = max(turning, inertia.turning(k, k));
  }
  turning = turning + mass * chain.length * chain.length;
  bool all_hold = true;
  const std::size_t count = chain.closures.size();
  for (std::size_t k = 0; k < count; ++k) {
    const auto& closure = chain.closures[k];
    w.right.reset(chain.size());
    w.right.wrench[closure.segment] = chain::unit_wrench(closure, w.placement);
    w.recursion.solve(w.right, false, w.columns[1 + k]);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const auto& closure = chain.closures[k];
    const auto wrench = chain::unit_wrench(closure, w.placement);
    for (std::size_t j = 0; j < count; ++j) {
      const S moved = power(wrench, w.columns[1 + j].motion[closure.segment]);
      w.small.a(k, j) =
          select(closures.acts[k], select(closures.acts[j], moved, zero), k == j ? one : zero);
    }
    const S own = power(wrench, w.columns[1 + k].motion[closure.segment]);
    const S free = one / (closure.turning ? turning : mass);
    if (any(closures.acts[k] & !(own > constant<S>(kHoldsNothing<S>) * free))) all_hold = false;
    w.small.a(k, count) = zero;
    w.small.a(count, k) = zero;
    const S lacks = closures.rate[k] - power(wrench, w.columns[0].motion[closure.segment]);
    w.small.b(k) = select(closures.acts[k], lacks, zero);
  }
  w.small.a(count, count) = one;
  w.small.b(count) = zero;
  w.small.solve();
  auto& sum = w.columns[0];
  for (std::size_t k = 0; k < count; ++k) {
    const S weight = select(closures.acts[k], w.small.b(k), zero);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      sum.motion[i].shift += weight * w.columns[1 + k].motion[i].shift;
      sum.motion[i].spin += weight * w.columns[1 + k].motion[i].spin;
    }
  }
  return all_hold;
}

}  // namespace detail

/// Makes velocities such as joints and closures allow, by impulses: of all such velocities those
/// whose kinetic distance to the given ones is least. What the joints pass on is impulsive; their
/// laws are not asked.
/// @param ground  how the ground moves at the root
/// @return whether every closure has something to hold
template <class L, bool kElastic>
bool make_velocities_fit(const chain::Chain<L>& chain, const ClosureRates<L>& closures,
                         const chain::Motion<L>& ground,
                         const chain::JointForces<L, kElastic>& no_laws,
                         const chain::Stage<L>& no_motion, std::vector<SegmentMotion<L>>& motion,
                         NewtonWork<L, kElastic>& w) {
  w.outer_forces.reset(chain.size());
  detail::factor_inertia(chain, no_motion, no_laws, w);
  w.right.reset(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const chain::Inertia<L>& inertia = chain.inertias[i];
    const auto& frame = w.placement.frame[i];
    const typename L::Point momentum = inertia.mass * motion[i].velocity;
    w.right.wrench[i] = {momentum, turning_momentum(inertia, frame, motion[i].spin) +
                                       L::moment(L::turn(frame, inertia.center), momentum)};
  }
  w.right.ground = ground;
  const bool all_hold = detail::solve_rates(chain, closures, false, w);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const chain::Motion<L>& moves = w.columns[0].motion[i];
    const auto& frame = w.placement.frame[i];
    motion[i].velocity =
        moves.shift + L::spun(moves.spin, L::turn(frame, chain.inertias[i].center));
    motion[i].spin = transposed_times(L::axes(frame), moves.spin);
  }
  return all_hold;
}

/// The accelerations of a chain under the forces in `w` (assembled, without inertia), for the
/// beginning of a scheme that carries them. Shifts of elastic joints are taken as at rest.
/// @param rates  which closures act; their rates are set
template <class L, bool kElastic>
void set_accelerations(const chain::Chain<L>& chain, const chain::JointForces<L, kElastic>& laws,
                       const chain::Stage<L>& no_motion, CarriedMotion<L>& carried_motion,
                       ClosureRates<L>& rates, std::vector<SegmentMotion<L>>& motion,
                       NewtonWork<L, kElastic>& w) {
  detail::factor_inertia(chain, no_motion, laws, w);
  w.right.reset(chain.size());
  // Arms and joint axes are carried along.
  std::vector<typename L::Point>& carried = carried_motion.shift;
  std::vector<typename L::Spin>& turned = carried_motion.spin;
  typename L::Point at{};
  typename L::Spin spin_rate{};
  typename L::Spin inner_spin{};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto& frame = w.placement.frame[i];
    const typename L::Spin spin = L::axes(frame) * motion[i].spin;
    if (any(w.q.open[i])) {
      at = select(w.q.open[i], {}, at);
      spin_rate = select(w.q.open[i], {}, spin_rate);
      inner_spin = select(w.q.open[i], spin, inner_spin);
    }
    // d/dt of (axes x rate) at a constant rate: the inner side's spin x the relative one.
    spin_rate += L::turned_by(spin - inner_spin) * inner_spin;
    const auto centripetal = [&](const typename L::Point& arm) {
      return L::spun(spin_rate, arm) + L::spun(spin, L::spun(spin, arm));
    };
    carried[i] = at;
    turned[i] = spin_rate;
    const chain::Inertia<L>& inertia = chain.inertias[i];
    const typename L::Point arm = L::turn(frame, inertia.center);
    const typename L::Point force = inertia.mass * (at + centripetal(arm));
    const typename L::Spin momentum = inertia.turning * motion[i].spin;
    const auto axes = L::axes(frame);
    const typename L::Spin moment = axes * (inertia.turning * transposed_times(axes, spin_rate) +
                                            L::turned_by(momentum) * motion[i].spin);
    w.right.wrench[i] = {-force, -(moment + L::moment(arm, force))};
    at += centripetal(L::turn(frame, chain.segments[i].arm));
    inner_spin = spin;
  }
  for (std::size_t k = 0; k < chain.closures.size(); ++k) {
    const auto& closure = chain.closures[k];
    const std::size_t i = closure.segment;
    const auto& frame = w.placement.frame[i];
    const typename L::Spin spin = L::axes(frame) * motion[i].spin;
    const typename L::Point arm = L::turn(frame, closure.arm);
    const typename L::Point bias =
        carried[i] + L::spun(turned[i], arm) + L::spun(spin, L::spun(spin, arm));
    rates.rate[k] = -(dot(closure.direction, bias) + dot(closure.axis, turned[i]));
  }
  detail::solve_rates(chain, rates, true, w);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto& frame = w.placement.frame[i];
    const chain::Motion<L>& moves = w.columns[0].motion[i];
    const typename L::Spin spin = L::axes(frame) * motion[i].spin;
    const typename L::Spin turns = moves.spin + turned[i];
    const typename L::Point arm = L::turn(frame, chain.inertias[i].center);
    motion[i].acceleration =
        moves.shift + carried[i] + L::spun(turns, arm) + L::spun(spin, L::spun(spin, arm));
    motion[i].spin_rate = transposed_times(L::axes(frame), turns);
    motion[i].resisting = motion[i].acceleration;
    motion[i].resisting_spin_rate = motion[i].spin_rate;
  }
}

}  // namespace plastica::solve
