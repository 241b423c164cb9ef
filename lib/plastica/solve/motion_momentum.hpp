#pragma once

#include "plastica/solve/motion_step.hpp"

/// Momentum of the fragments that nothing outside of the beam holds: README.md, "Momentum".
namespace plastica::solve {

/// Whether a support acts on a fragment.
template <class L, bool kElastic>
bool MotionStep<L, kElastic>::is_held(std::size_t first, std::size_t end) const {
  const auto within = [&](std::size_t segment) { return segment >= first && segment < end; };
  for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
    if (any(w_.closed[k]) && within(chain_.constraints[k].segment)) return true;
  }
  for (std::size_t g = 0; g < chain_.ground_joints.size(); ++g) {
    if (any(!w_.q.released_ground_joint[g]) && within(chain_.ground_joints[g].segment)) return true;
  }
  return std::any_of(chain_.springs.begin(), chain_.springs.end(),
                     [&](const auto& spring) { return within(spring.segment); });
}

/// Looks at the fragments of the step that was tried, before it is taken.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::balance_momentum() {
  std::size_t end = chain_.size();
  w_.recursion.for_each_fragment([&](std::size_t first, const chain::Wrench<L>& residual) {
    if (is_held(first, end)) {
      momentum_[first].knows_outside = false;
    } else {
      balance_fragment(first, end, residual);
    }
    end = first;
  });
}

/// @param residual  what Newton's method has left out of balance, about the start of the fragment
///                  where forces act
template <class L, bool kElastic>
void MotionStep<L, kElastic>::balance_fragment(std::size_t first, std::size_t end,
                                               const chain::Wrench<L>& residual) {
  const S h = constant<S>(h_);
  const auto& inertias = chain_.inertias;
  const Placement& active = rule_.midpoint ? w_.stage.placement : w_.placement;
  const typename L::Point& start = active.position[first];
  const FragmentMotion<L> before = fragment_motion(inertias, begin_, motion_, first, end);
  if (newton_.one_solve && rule_.midpoint) {
    add_momentum(inertias, w_.placement, start, {h * residual.force, h * residual.moment}, first,
                 end, motion_now_);
    // The residual has done no work then: the inertia of the step has less to take up.
    flows_.numerical_dissipation +=
        dot(residual.force, w_.placement.position[first] - begin_.position[first]) +
        dot(residual.moment, step_[first].spin);
  }
  const FragmentMotion<L> after = fragment_motion(inertias, w_.placement, motion_now_, first, end);

  chain::Wrench<L> outside = residual;
  for (std::size_t i = first; i < end; ++i) {
    const CenterForce<L>& resists = inertia_now_[i];
    const typename L::Point arm = active.point(i, inertias[i].center) - start;
    outside.force -= resists.force;
    outside.moment -= resists.moment + L::moment(arm, resists.force);
  }
  const typename L::Point center =
      rule_.midpoint ? constant<S>(0.5) * (before.center + after.center) : after.center;
  outside.moment -= L::moment(center - start, outside.force);

  MomentumError<L>& error = momentum_[first];
  const S fraction = constant<S>(error.knows_outside ? rule_.end_work : 1.0);
  const S rest = constant<S>(1) - fraction;
  error.lost += after.momentum - before.momentum -
                h * (fraction * outside.force + rest * error.outside.force);
  error.angular += after.angular - before.angular -
                   h * (fraction * outside.moment + rest * error.outside.moment);
  error.outside = outside;
  error.knows_outside = true;
  error.size = max(max(error.size, before.size), after.size);
  error.angular_size = max(max(error.angular_size, before.angular_size), after.angular_size);
  error.largest_lost = max(error.largest_lost, E(size_of(error.lost)));
  error.largest_angular = max(error.largest_angular, E(size_of(error.angular)));
}

template <class L, bool kElastic>
sum_t<typename L::Scalar> MotionStep<L, kElastic>::momentum_error() const {
  E error = constant<E>(0.0);
  for (const MomentumError<L>& fragment : momentum_) {
    error = max(error, fragment.fraction(chain_.length));
  }
  return error;
}

}  // namespace plastica::solve
