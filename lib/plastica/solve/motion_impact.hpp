#pragma once

#include "plastica/solve/motion_step.hpp"

/// Jumps of velocity: impacts on pillars, supports that start or stop, the beginning.
namespace plastica::solve {

/// Whether a one-sided closure touches.
template <class L, bool kElastic>
bool MotionStep<L, kElastic>::touches(std::size_t k) const {
  const double gap = chain::closure_gap(chain_, chain_.closures[k], w_.placement, w_.time);
  return !w_.q.released_closure[k] && gap <= 1e-9 * chain_.length;
}

/// Speed with which a closure's point moves along its direction, beyond its support's own.
template <class L, bool kElastic>
double MotionStep<L, kElastic>::approach_of(std::size_t k, const Motions& motion,
                                            const Placement& placement) const {
  const auto& closure = chain_.closures[k];
  const std::size_t i = closure.segment;
  const typename L::Spin spin = L::axes(placement.frame[i]) * motion[i].spin;
  const typename L::Point arm =
      L::turn(placement.frame[i], closure.arm - chain_.inertias[i].center);
  const double speed =
      dot(closure.direction, motion[i].velocity + L::spun(spin, arm)) + dot(closure.axis, spin);
  const double secant = h_ > 0.0 ? (chain_.histories[closure.history].at(w_.time) -
                                    chain_.histories[closure.history].at(w_.time - h_)) /
                                       h_
                                 : slope_of(closure.history);
  return speed - secant * closure.motion;
}

/// Makes velocities fit joints, supports and contacts, with the impulses that this takes. A contact
/// that would have to pull is left out.
/// @param bounce  speed of each closure's point away from its support; none: all at rest
template <class L, bool kElastic>
bool MotionStep<L, kElastic>::fit_velocities(Motions& motion, const std::vector<double>* bounce) {
  ClosureRates<L> rates;
  for (std::size_t k = 0; k < chain_.closures.size(); ++k) {
    const auto& closure = chain_.closures[k];
    const bool acts = closure.one_sided ? static_cast<bool>(was_closed_[k]) : true;
    rates.acts.push_back(acts && !w_.q.released_closure[k]);
    rates.rate.push_back(slope_of(closure.history) * closure.motion +
                         (bounce != nullptr ? (*bounce)[k] : 0.0));
  }
  const double slope = slope_of(chain_.root.history);
  const chain::Motion<L> ground{slope * chain_.root.motion, slope * chain_.root.turn};
  const chain::Stage<L> at_end;
  const Motions given = motion;
  for (;;) {
    motion = given;
    const bool holds = make_velocities_fit(chain_, rates, ground, no_laws_, at_end, motion, w_);
    bool pulls = false;
    for (std::size_t k = 0; k < chain_.closures.size(); ++k) {
      if (!chain_.closures[k].one_sided || !rates.acts[k] || w_.small.b(k) >= 0.0) continue;
      rates.acts[k] = false;
      pulls = true;
    }
    if (!pulls) return holds;
  }
}

/// Whether a support's speed jumps at the end of the step.
template <class L, bool kElastic>
bool MotionStep<L, kElastic>::turns_a_corner() const {
  const auto jumps = [&](std::size_t history) {
    const History& factor = chain_.histories[history];
    const double before = (factor.at(w_.time) - factor.at(w_.time - h_)) / h_;
    const double after = factor.slope_at(w_.time);
    return std::fabs(after - before) > 1e-9 * std::max(std::fabs(after), std::fabs(before));
  };
  const auto moves = [](const auto& v) { return dot(v, v) > 0.0; };
  const auto& root = chain_.root;
  if (!w_.q.open[0] && (moves(root.motion) || moves(root.turn)) && jumps(root.history)) return true;
  return std::any_of(chain_.closures.begin(), chain_.closures.end(), [&](const auto& closure) {
    return closure.motion != 0.0 && jumps(closure.history);
  });
}

/// Finds contacts that have closed and lets them bounce or rest; follows supports whose speed
/// jumps.
/// @param begin  velocities before the step
/// @return whether velocities have jumped
template <class L, bool kElastic>
bool MotionStep<L, kElastic>::settle(const Motions& begin) {
  bool struck = false;
  std::vector<double> bounce(chain_.closures.size(), 0.0);
  for (std::size_t k = 0; k < chain_.closures.size(); ++k) {
    if (!chain_.closures[k].one_sided) continue;
    const bool closed = w_.closed[k];
    if (closed && !was_closed_[k]) {
      struck = true;
      const double speed = -approach_of(k, begin, begin_);
      const double push = w_.q.multiplier[k] / mass_ * h_;
      if (speed > kRestingSpeed * push) bounce[k] = options_.restitution[k] * speed;
    }
    was_closed_[k] = closed;
  }
  const bool corner = turns_a_corner();
  if (!struck && !corner) return false;
  const double before = kinetic();
  fit_velocities(motion_, &bounce);
  const double lost = before - kinetic();
  // The work of an impulse that makes a support start or stop comes from outside.
  (struck ? flows_.impact : flows_.external) += struck ? lost : -lost;
  for (std::size_t k = 0; k < bounce.size(); ++k) {
    if (bounce[k] <= 0.0) continue;
    w_.q.multiplier[k] = 0.0;
    was_closed_[k] = false;
  }
  return true;
}

/// After a jump: generalized-alpha begins anew from the accelerations that the forces give now.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::restart() {
  if (rule_.conserves) return;
  chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement);
  evaluate_laws();
  chain::gather_forces(
      chain_, w_.q, w_.placement, chain::Stage<L>{}, w_.joints,
      [this](std::size_t history) { return chain_.histories[history].at(w_.time); },
      w_.outer_forces);
  ClosureRates<L> rates;
  for (std::size_t k = 0; k < chain_.closures.size(); ++k) {
    const bool acts = chain_.closures[k].one_sided ? static_cast<bool>(was_closed_[k]) : true;
    rates.acts.push_back(acts && !w_.q.released_closure[k]);
    rates.rate.push_back(0.0);
  }
  const chain::Stage<L> at_end;
  set_accelerations(chain_, rates, w_.joints, at_end, motion_, w_);
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    inertia_[i] = inertia_force(rule_, 1.0, chain_.inertias[i], w_.placement.frame[i],
                                w_.placement.frame[i], motion_[i], motion_[i]);
  }
}

}  // namespace plastica::solve
