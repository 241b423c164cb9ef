#pragma once

#include <cstddef>
#include <limits>

#include "plastica/solve/newton_work.hpp"

/// When an equilibrium is found: how far a chain is out of balance.
namespace plastica::solve::detail {

/// Units of rounding in the place of a segment, a sum over those before it.
inline constexpr double kRoundings = 8.0;

/// The larger of a size so far and |x|; what is not a number stays.
template <class S>
inline S larger_size(const S& so_far, const S& x) {
  return so_far + max(abs(x) - so_far, constant<S>(0));
}

/// The same for a scale, from which what is not a number is dropped: it outlives a failed step.
template <class S>
inline S larger_scale(const S& so_far, const S& x) {
  return max(so_far, abs(x));
}

/// Whether every constraint that acts is closed, and none pulls that may not.
template <class L, bool kElastic>
mask_t<typename L::Scalar> constraints_hold(const chain::Chain<L>& chain,
                                            const NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  mask_t<S> hold = in_all_lanes<S>(!w.closed_anew);
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    const S size = chain.constraints[k].rotational ? constant<S>(1) : chain.length;
    const mask_t<S> open = abs(w.gap[k]) > constant<S>(kConstraintTolerance<S>) * size;
    hold = hold & !open;
  }
  return hold;
}

/// What no step can solve, in force and moment.
template <class S>
struct Rounding {
  S force{};
  S moment{};
};

/// What springs and joints to the ground make of the rounding of positions and angles: their
/// stiffness times it. (Angles within the beam are unknowns themselves, without such a rounding.)
/// Nothing with float, whose tolerance has it already (`reachable`).
template <class L, bool kElastic>
Rounding<typename L::Scalar> rounding_of(const chain::Chain<L>& chain,
                                         const NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  Rounding<S> sum;
  if constexpr (!kIsDouble<S>) return sum;
  const S unit = constant<S>(kRoundings * std::numeric_limits<real_t<S>>::epsilon());
  for (const auto& spring : chain.springs) {
    for (std::size_t k = 0; k < L::kTranslations; ++k) {
      sum.force += unit * spring.stiffness[k] * (chain.length + abs(spring.rest[k]));
    }
  }
  sum.moment = sum.force * chain.length;
  for (const auto& joint : chain.ground_joints) {
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      sum.moment += unit * abs(w.joints.tangent[joint.joint](k, k));
    }
  }
  return sum;
}

/// What of an imbalance is above rounding; what is not a number stays.
template <class S>
inline S above_rounding(const S& imbalance, const S& rounding) {
  return select(imbalance > rounding, imbalance - rounding, constant<S>(0) * imbalance);
}

/// The largest imbalance of a joint and the largest gap, relative to their scales. After a step of
/// Newton's method, what rounding may leave is not counted.
template <class L, bool kElastic>
typename L::Scalar relative_imbalance(const chain::Chain<L>& chain, NewtonWork<L, kElastic>& w) {
  using S = typename L::Scalar;
  S moment = constant<S>(0), force = constant<S>(0);
  if (w.forgets) {
    w.moment_scale = w.settled_moment;
    w.force_scale = w.settled_force;
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto& balance = w.recursion.balance()[i];
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      moment = larger_size(moment, balance[k]);
      w.moment_scale = larger_scale(w.moment_scale, w.transmitted.outer[i].moment[k]);
      w.moment_scale = larger_scale(w.moment_scale, w.joints.force[i][k]);
    }
    for (std::size_t k = L::kRotations; k < balance.at.size(); ++k) {
      force = larger_size(force, balance[k]);
    }
    for (std::size_t k = 0; k < L::kTranslations; ++k) {
      w.force_scale = larger_scale(w.force_scale, w.transmitted.outer[i].force[k]);
    }
  }
  if (!w.forgets) w.force_scale = larger_scale(w.force_scale, w.outer_forces.largest_spring);
  for (std::size_t k = 0; k < L::kTranslations; ++k) {
    force = larger_size(force, w.recursion.root_balance()[k]);
  }
  w.recursion.for_each_fragment([&](std::size_t /*joint*/, const chain::Wrench<L>& balance) {
    for (std::size_t k = 0; k < L::kTranslations; ++k) force = larger_size(force, balance.force[k]);
    for (std::size_t k = 0; k < L::kRotations; ++k) moment = larger_size(moment, balance.moment[k]);
  });
  S gap = constant<S>(0);
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    const S size = chain.constraints[k].rotational ? chain.length : constant<S>(1);
    gap = larger_size(gap, size * w.gap[k]);
  }
  // Moments are forces on levers: a bar under axial force alone is no beam out of balance.
  const S lever = constant<S>(1e-2) * chain.length;
  const S tiny = constant<S>(std::numeric_limits<real_t<S>>::min());
  // Nor is what no step can solve. Before the first one nobody knows: a twist that translations'
  // rounding would hide is solved like any other.
  const S unit_of_floor = constant<S>(std::numeric_limits<real_t<S>>::epsilon());
  const S floor_force = max(w.stepped, unit_of_floor) * w.force_floor;
  const S floor_moment = floor_force * chain.length;
  const S moment_scale = max(max(w.moment_scale, lever * w.force_scale), floor_moment);
  const S force_scale = max(max(w.force_scale, w.moment_scale / chain.length), floor_force);
  Rounding<S> rounding = rounding_of(chain, w);
  if constexpr (kIsDouble<S>) {
    // Where loads go straight into supports and nothing strains the beam, there is but their
    // rounding.
    const S forces = w.outer_forces.sum_of_forces;
    const S moments = w.outer_forces.sum_of_moments + forces * chain.length;
    const S unstrained = constant<S>(1e-9);
    const S unit = constant<S>(kRoundings * std::numeric_limits<real_t<S>>::epsilon());
    const S none = constant<S>(0);
    rounding.force += select(force_scale < unstrained * forces, unit * forces, none);
    rounding.moment += select(moment_scale < unstrained * moments, unit * moments, none);
  }
  moment = above_rounding(moment, w.stepped * rounding.moment);
  force = above_rounding(force, w.stepped * rounding.force);
  const S worst = larger_size(moment / max(moment_scale, tiny), force / max(force_scale, tiny));
  return larger_size(worst, gap / chain.length);
}

}  // namespace plastica::solve::detail
