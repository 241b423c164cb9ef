#pragma once

#include <limits>

#include "plastica/solve/motion_step.hpp"

/// Jumps of velocity: impacts on pillars, supports that start or stop, the beginning.
namespace plastica::solve {

/// How far a pillar is from the beam; of one that was cut off, infinitely.
template <class L, bool kElastic>
double MotionStep<L, kElastic>::gap_of(std::size_t k, const Placement& placement,
                                       double time) const {
  if (w_.q.released_constraint[k]) return std::numeric_limits<double>::infinity();
  return chain::constraint_gap(chain_, chain_.constraints[k], placement, time) - w_.held_off[k];
}

template <class L, bool kElastic>
void MotionStep<L, kElastic>::wake_twins(std::size_t joint) {
  for (std::size_t k = 1; k < chain_.constraints.size(); ++k) {
    if (chain_.constraints[k].waits_for != joint) continue;
    const std::size_t original = k - 1;
    const auto gap = [&](std::size_t of) {
      return chain::constraint_gap(chain_, chain_.constraints[of], w_.placement, w_.time);
    };
    w_.held_off[k] = gap(k) - gap(original);
    w_.q.released_constraint[k] = false;
    w_.closed[k] = w_.closed[original];
    contacts_.rests_on[k] = contacts_.rests_on[original];
    contacts_.bounces[k] = contacts_.bounces[original];
  }
}

/// The fraction of the step that was solved at whose end a contact has just closed; 1: none does.
template <class L, bool kElastic>
double MotionStep<L, kElastic>::free_fraction() const {
  const double tolerance = kContactTolerance<S> * chain_.length;
  double fraction = 1.0;
  for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
    if (!chain_.constraints[k].one_sided || contacts_.rests_on[k]) continue;
    const double end = gap_of(k, w_.placement, w_.time);
    if (end >= -tolerance) continue;
    const double begin = gap_of(k, begin_, time_);
    // The middle of what is tolerated, on the secant.
    const double part = (begin + 0.5 * tolerance) / (begin - end);
    fraction = std::min(fraction, begin > 0.0 ? part : 0.0);
  }
  return fraction;
}

/// What struck contacts have lost by the impulses that fit the velocities now: of each its impulse
/// times the mean of the speeds at which the beam came and goes, as its support sees them. Where
/// supports stand, that is all that the beam has lost; else their impulses do work besides.
template <class L, bool kElastic>
typename MotionStep<L, kElastic>::E MotionStep<L, kElastic>::lost_by_struck() const {
  E lost{};
  if constexpr (!kHasLanes<S>) {
    for (const Struck& one : struck_) {
      if (!rates_.acts[one.constraint]) continue;  // it would have to pull
      const E impulse = E(w_.small.b(one.constraint));
      lost += impulse * E(0.5 * (one.came - one.goes));
    }
  }
  return lost;
}

/// Books what an impact has taken from the kinetic energy.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::book_impact(const E& lost) {
  const E own = supports_move() ? lost_by_struck() : lost;
  flows_.impact += own;
  if (supports_move()) flows_.external += own - lost;
}

template <class L, bool kElastic>
bool MotionStep<L, kElastic>::supports_move() const {
  const auto is_something = [](const S& square) { return any(square > constant<S>(0)); };
  const auto& root = chain_.root;
  // A spring at the start moves, too, but has no impulse.
  const auto any_of = [](const auto& holds) {
    return std::any_of(holds.begin(), holds.end(), [](bool one) { return one; });
  };
  return (any_of(root.held) && is_something(dot(root.motion, root.motion))) ||
         (any_of(root.clamped) && is_something(dot(root.rotation, root.rotation))) ||
         std::any_of(chain_.constraints.begin(), chain_.constraints.end(),
                     [&](const auto& k) { return is_something(abs(k.motion)); });
}

/// Contacts that touch at the step's begin and would be crossed in it: they are met there.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::meet_at_begin() {
  struck_.clear();
  for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
    if (!chain_.constraints[k].one_sided || contacts_.rests_on[k]) continue;
    const bool crosses = gap_of(k, w_.placement, w_.time) < -kContactTolerance<S> * chain_.length;
    if (crosses && gap_of(k, begin_, time_) <= 0.0) struck_.push_back({k});
  }
  w_.q = q_begin_;
  w_.time = time_;
  w_.placement = begin_;
  double before = kinetic();
  if (supports_move()) {
    // As in `settle`: what velocities lack to fit the joints is no work of supports.
    fit_velocities(motion_);
    flows_.numerical_dissipation += before - kinetic();
    before = kinetic();
  }
  for (Struck& one : struck_) {
    one.came = approach_of(one.constraint);
    contacts_.rests_on[one.constraint] = true;
  }
  fit_velocities(motion_);
  book_impact(before - kinetic());
  h_before_ = 0.0;
  restart();
}

/// Contacts that open in the step that was tried, though they pushed at its begin:
/// generalized-alpha would let that push act on in a step in which nothing is touched, and make
/// energy. They are let go at the begin. @return whether there are any, and the step is to be tried
/// again
template <class L, bool kElastic>
bool MotionStep<L, kElastic>::leaves_loaded() {
  if (rule_.end_work == 1.0 || rule_.midpoint) return false;
  bool leaves = false;
  for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
    if (!chain_.constraints[k].one_sided || !contacts_.rests_on[k] || w_.closed[k]) continue;
    if (multiplier_[k] <= 0.0) continue;
    contacts_.rests_on[k] = false;
    leaves = true;
  }
  if (!leaves) return false;
  w_.q = q_begin_;
  w_.time = time_;
  w_.placement = begin_;
  restart();
  return true;
}

/// Speed of a constraint's point against its direction, beyond that of its support.
template <class L, bool kElastic>
double MotionStep<L, kElastic>::approach_of(std::size_t k) const {
  const Motions& motion = motion_;
  const Placement& placement = w_.placement;
  const auto& constraint = chain_.constraints[k];
  const std::size_t i = constraint.segment;
  const typename L::Spin spin = L::axes(placement.frame[i]) * motion[i].spin;
  const typename L::Point arm =
      L::rotate(placement.frame[i], constraint.arm - chain_.inertias[i].center);
  const double speed = dot(constraint.direction, motion[i].velocity + L::spun(spin, arm)) +
                       dot(constraint.axis, spin);
  const History& history = chain_.histories[constraint.history];
  const double secant =
      h_ > 0.0 ? (history.at(w_.time) - history.at(w_.time - h_)) / h_ : history.slope_at(w_.time);
  return secant * constraint.motion - speed;
}

/// Makes velocities fit joints and supports, with the impulses that this takes, and contacts that
/// close are at rest.
template <class L, bool kElastic>
mask_t<typename L::Scalar> MotionStep<L, kElastic>::fit_velocities(Motions& motion) {
  set_support_rates();
  if constexpr (!kHasLanes<S>) {
    for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
      if (chain_.constraints[k].one_sided && !contacts_.rests_on[k]) rates_.acts[k] = false;
    }
  }
  return fit_to_rates(motion);
}

/// All constraints act, at the speeds of their supports.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::set_support_rates() {
  for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
    const auto& constraint = chain_.constraints[k];
    rates_.acts[k] = !w_.q.released_constraint[k];
    rates_.rate[k] = slope_of(constraint.history) * constraint.motion;
  }
}

/// The same by `rates_`; a contact that would have to pull is left out.
template <class L, bool kElastic>
mask_t<typename L::Scalar> MotionStep<L, kElastic>::fit_to_rates(Motions& motion) {
  const S slope = slope_of(chain_.root.history);
  const chain::Motion<L> ground{slope * chain_.root.motion, slope * chain_.root.rotation};
  given_ = motion;
  for (;;) {
    motion = given_;
    const mask_t<S> holds =
        make_velocities_fit(chain_, rates_, ground, no_laws_, no_motion_, motion, w_);
    bool pulls = false;
    if constexpr (!kHasLanes<S>) {
      for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
        if (!chain_.constraints[k].one_sided || !rates_.acts[k] || w_.small.b(k) >= 0.0) continue;
        rates_.acts[k] = false;
        pulls = true;
      }
    }
    if (!pulls) return holds;
  }
}

/// What the speeds of supports do at the end of the step: the most abrupt of all.
template <class L, bool kElastic>
SupportSpeed MotionStep<L, kElastic>::speed_of_supports() const {
  SupportSpeed most = SupportSpeed::Kept;
  const auto count = [&](std::size_t history) {
    const StepEnd end{w_.time, h_, reach()};
    const auto& factor = chain_.histories[history];
    if constexpr (kHasLanes<S>) {
      most = std::max(most, speed_of_support(*factor.history, end, rule_.midpoint));
    } else {
      most = std::max(most, speed_of_support(factor, end, rule_.midpoint));
    }
  };
  const auto is_something = [](const S& square) { return any(square > constant<S>(0)); };
  const auto& root = chain_.root;
  const bool root_moves = is_something(dot(root.motion, root.motion)) ||
                          is_something(dot(root.rotation, root.rotation));
  if (any(!w_.q.open[0]) && root_moves) count(root.history);
  for (const auto& constraint : chain_.constraints) {
    if (is_something(abs(constraint.motion))) count(constraint.history);
  }
  return most;
}

/// Contacts that open and that are left, after a step. @return whether one is struck
template <class L, bool kElastic>
bool MotionStep<L, kElastic>::note_contacts() {
  bool touches = false;
  for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
    if (!chain_.constraints[k].one_sided) continue;
    if (contacts_.rests_on[k]) {
      contacts_.rests_on[k] = w_.closed[k];
    } else if (gap_of(k, w_.placement, w_.time) <= 0.0) {
      touches = touches || approach_of(k) > 0.0;
    } else {
      contacts_.bounces[k] = 0;
    }
  }
  return touches;
}

/// Lets contacts that have closed bounce, or rest where they are slow or come back again and again;
/// follows supports whose speed changes.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::settle() {
  bool touches = false;
  if constexpr (!kHasLanes<S>) touches = note_contacts();
  const SupportSpeed speed = speed_of_supports();
  const bool corner = speed != SupportSpeed::Kept;
  has_restarted_ = touches || corner;
  if (!has_restarted_) return;
  // What a scheme's velocities lack to fit the joints is its own affair, not the impact's.
  E before = kinetic();
  if (touches) {
    fit_velocities(motion_);
    flows_.numerical_dissipation += before - kinetic();
    before = kinetic();
  }
  if constexpr (kHasLanes<S>) {
    fit_velocities(motion_);
  } else {
    strike(corner);
  }
  const E lost = before - kinetic();
  // The work of an impulse that makes a support start or stop comes from outside.
  if (touches) {
    book_impact(lost);
  } else {
    flows_.external -= lost;
  }
  if (touches || speed == SupportSpeed::Jumps) jumped();
  restart();
}

/// Velocities have jumped: what is known of steps before is of no use any more.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::jumped() {
  h_before_ = 0.0;
  note_begin();
}

template <class L, bool kElastic>
void MotionStep<L, kElastic>::strike(bool corner) {
  struck_.clear();
  const std::size_t count = chain_.constraints.size();
  bool strikes = corner;
  set_support_rates();
  for (std::size_t k = 0; k < count; ++k) {
    if (!chain_.constraints[k].one_sided || contacts_.rests_on[k]) continue;
    rates_.acts[k] = false;
    if (gap_of(k, w_.placement, w_.time) > 0.0) continue;
    const double speed = approach_of(k);
    if (speed <= 0.0) continue;
    const bool bounces = speed > kRestingSpeed * fastest_ && ++contacts_.bounces[k] <= kMaxBounces;
    const double away = bounces ? options_.restitution[k] * speed : 0.0;
    contacts_.rests_on[k] = away == 0.0;
    rates_.acts[k] = !w_.q.released_constraint[k];
    rates_.rate[k] += constant<S>(away);
    struck_.push_back({k, speed, away});
    strikes = true;
  }
  if (strikes) fit_to_rates(motion_);
}

/// After a jump: generalized-alpha begins anew from the accelerations that the forces give now.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::restart() {
  if (rule_.conserves) return;
  chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement);
  joints_.set_time(0.0);
  evaluate_laws();
  if (options_.damping != Damping::None) set_joint_spins(motion_, w_.time + reach());
  joint_motion_.begin_damping(options_, w_.angles, spins_, w_.joints);
  for (std::size_t g = 0; g < ground_moment_.size(); ++g) ground_moment_[g] = ground_moment(g);
  for (MomentumError<L>& error : momentum_) error.knows_outside = false;
  chain::gather_forces(
      chain_, w_.q, w_.placement, chain::Stage<L>{}, w_.joints,
      [this](std::size_t history) { return chain_.histories[history].at(w_.time); },
      w_.outer_forces);
  for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
    rates_.acts[k] = !w_.q.released_constraint[k];
    if constexpr (!kHasLanes<S>) {
      if (chain_.constraints[k].one_sided && !contacts_.rests_on[k]) rates_.acts[k] = false;
    }
  }
  // The laws' forces as they are: nothing moves in no time.
  laws_alone_.force = w_.joints.force;
  const auto support_at = [this](std::size_t history) {
    const auto& factor = chain_.histories[history];
    const double time = w_.time + reach();
    return SupportRates<S>{chain::factor_as<S>(factor.slope_at(time)),
                           chain::factor_as<S>(factor.curvature_at(time))};
  };
  set_accelerations(chain_, laws_alone_, no_motion_, carried_, rates_, support_at, motion_, w_);
  for (std::size_t k = 0; k < multiplier_.size(); ++k) {
    multiplier_[k] = select(rates_.acts[k], w_.small.b(k), constant<S>(0));
  }
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    inertia_[i] = inertia_force(StepFactors(rule_, 1.0), chain_.inertias[i], w_.placement.frame[i],
                                w_.placement.frame[i], motion_[i], motion_[i]);
  }
  note_root_wrench();
}

/// What the root passes on at the accelerations that have just been found.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::note_root_wrench() {
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    add_inertia_force(chain_.inertias[i], i, w_.placement, inertia_[i], w_.outer_forces);
  }
  for (std::size_t k = 0; k < multiplier_.size(); ++k) {
    const chain::Wrench<L> unit = chain::unit_wrench(chain_.constraints[k], w_.placement);
    chain::Wrench<L>& wrench = w_.outer_forces.wrench[chain_.constraints[k].segment];
    wrench.force += multiplier_[k] * unit.force;
    wrench.moment += multiplier_[k] * unit.moment;
  }
  w_.recursion.sum(chain_, w_.q, w_.placement, no_motion_, w_.joints, w_.outer_forces, w_.impulses);
  root_wrench_ = w_.impulses.outer[0];
}

}  // namespace plastica::solve
