#pragma once

#include "plastica/solve/motion_step.hpp"

/// All that acts in a step, for Newton's method.
namespace plastica::solve {

template <class L, bool kElastic>
void MotionStep<L, kElastic>::evaluate_laws() {
  for (std::size_t i = 0; i < chain_.size(); ++i) w_.angles[i] = w_.q.angle[i];
  for (std::size_t g = 0; g < chain_.ground_joints.size(); ++g) {
    const auto& joint = chain_.ground_joints[g];
    // A joint that was cut keeps its angle.
    if (any(w_.q.released_ground_joint[g])) continue;
    w_.angles[joint.joint] = chain::ground_joint_angle(chain_, joint, w_.placement, w_.time);
  }
  joints_.evaluate(w_.angles, w_.q.shift, w_.joints);
}

/// What all iterations of a step have in common: the rule for its length, and the factors of the
/// histories where the forces act: half way, the mean of both ends.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::set_factors() {
  factors_ = StepFactors(rule_, h_);
  const double end = time_ + h_;
  for (std::size_t k = 0; k < history_factor_.size(); ++k) {
    const auto factor_at = [&](double time) {
      return chain::factor_as<E>(chain_.histories[k].at(time));
    };
    history_factor_[k] =
        rule_.midpoint ? constant<E>(0.5) * (factor_at(time_) + factor_at(end)) : factor_at(end);
  }
}

/// Means of the step's begin and end, and how moments go between them and the joints.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::set_stage() {
  chain::Stage<L>& stage = w_.stage;
  const std::size_t n = chain_.size();
  Placement& mean = stage.placement;
  const Placement& end = w_.placement;
  const S half = constant<S>(0.5);
  typename L::Spin inner = L::step_spin(begin_.near[0], end.near[0]);
  for (std::size_t i = 0; i < n; ++i) {
    mean.frame[i] = L::mean(begin_.frame[i], end.frame[i]);
    mean.near[i] = L::mean(begin_.near[i], end.near[i]);
    mean.position[i] = half * (begin_.position[i] + end.position[i]);
    if constexpr (kElastic) {
      mean.far[i] = L::mean(begin_.far[i], end.far[i]);
      stage.shift[i] = half * (q_begin_.shift[i] + w_.q.shift[i]);
    }
    const auto axes = L::axes(begin_.near[i]);
    stage.to_joint[i] = transpose(axes) * L::work_to_joint(inner, step_[i].spin);
    stage.from_joint[i] = L::work_from_joint(inner, step_[i].spin) * axes;
    inner = step_[i].spin;
  }
  for (std::size_t g = 0; g < chain_.ground_joints.size(); ++g) {
    const auto& joint = chain_.ground_joints[g];
    const auto rotation_at = [&](double time) {
      return L::rotation(chain::factor_as<S>(chain_.histories[joint.history].at(time)) *
                         joint.motion);
    };
    stage.ground_axes[g] =
        L::work_from_joint(step_[joint.segment].spin,
                           L::step_spin(rotation_at(time_), rotation_at(w_.time))) *
        L::axes(chain::ground_joint_axes(joint, begin_));
  }
}

/// How fast the joints turn at the step's end.
template <class L, bool kElastic>
void MotionStep<L, kElastic>::set_joint_spins(const Motions& motion, double time) {
  if (rule_.conserves) return;
  spins_.resize(chain_.joints());
  const auto slope_at = [&](std::size_t history) {
    return chain::factor_as<S>(chain_.histories[history].slope_at(time));
  };
  typename L::Spin inner = slope_at(chain_.root.history) * chain_.root.rotation;
  const auto spin_of = [&](std::size_t i) {
    return L::axes(w_.placement.frame[i]) * motion[i].spin;
  };
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const typename L::Spin spin = spin_of(i);
    spins_[i] = transposed_times(L::axes(w_.placement.near[i]), spin - inner);
    inner = spin;
  }
  for (const auto& joint : chain_.ground_joints) {
    const typename L::Spin ground = slope_at(joint.history) * joint.motion;
    spins_[joint.joint] = transposed_times(L::axes(chain::ground_joint_axes(joint, w_.placement)),
                                           ground - spin_of(joint.segment));
  }
}

/// @param slopes  whether the forces' changes are asked for, too
template <class L, bool kElastic>
void MotionStep<L, kElastic>::assemble(bool slopes) {
  const StepFactors of = factors_;  // which no store in a loop changes
  chain::place<kElastic>(chain_, w_.q, w_.time, w_.placement,
                         [this](std::size_t joint, const typename L::Frame& rotation) {
                           joint_motion_.note_rotation(joint, rotation);
                         });
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    step_[i] = segment_step<L>(chain_.inertias[i], i, begin_, w_.placement);
    const auto spin = transposed_times(L::axes(w_.placement.frame[i]), step_[i].spin);
    motion_now_[i] = motion_after(of, motion_[i], step_[i].displacement, spin);
  }
  if (of.midpoint) set_stage();
  evaluate_laws();
  if (options_.damping == Damping::Stiffness) {
    set_joint_spins(motion_now_, w_.time - kRounding * h_);  // before a corner
  }
  joint_motion_.take(options_, rule_, h_, w_.angles, w_.q.shift, spins_, slopes, w_.joints);
  chain::gather_forces(
      chain_, w_.q, w_.placement, w_.stage, w_.joints,
      [this](std::size_t history) { return history_factor_[history]; }, w_.outer_forces, slopes);
  const Placement& active = w_.stage.of(w_.placement);
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const chain::Inertia<L>& inertia = chain_.inertias[i];
    const auto& end = w_.placement.frame[i];
    inertia_now_[i] = inertia_force(of, inertia, begin_.frame[i], end, motion_[i], motion_now_[i]);
    add_inertia_force(inertia, i, active, inertia_now_[i], w_.outer_forces);
    if (!slopes) continue;
    const auto rotational = rotational_impedance<L>(of, inertia, end, motion_now_[i],
                                                    transposed_times(L::axes(end), step_[i].spin),
                                                    inertia_now_[i].moment);
    add_inertia_slope(of, inertia, i, w_.placement, active, inertia_now_[i], rotational,
                      w_.outer_forces);
  }
  detail::set_constraints(chain_, w_);
}

template <class L, bool kElastic>
void MotionStep<L, kElastic>::set_length(double h) {
  h_ = h;
  solves_ = constant<S>(0);
  set_factors();
  joints_.set_time(h);
  set_force_floor();
}

/// Velocities foretell a smooth motion; joints that ring faster than the step are better sought
/// from where they are. What worked is tried first.
template <class L, bool kElastic>
mask_t<typename L::Scalar> MotionStep<L, kElastic>::solve(double h, const mask_t<S>& rides) {
  set_length(h);
  const S none = constant<S>(0);
  const mask_t<S> at_rest = rests_ > none;
  rests_ = max(rests_ - constant<S>(1), none);
  const mask_t<S> left = !rides;
  w_.settled = left;
  mask_t<S> solved = solve_from(!at_rest, in_all_lanes<S>(false));
  if (!any(!(solved | left))) return solved;
  w_.settled = solved | left;
  const mask_t<S> again = (!w_.settled) & solve_from(at_rest, solved);
  rests_ = select(again & !at_rest, constant<S>(kRests), rests_);
  return solved | again;
}

template <class L, bool kElastic>
void MotionStep<L, kElastic>::note_fastest() {
  if constexpr (!kHasLanes<S>) {
    for (const SegmentMotion<L>& motion : motion_) {
      fastest_ = std::max<double>(fastest_, size_of(motion.velocity));
    }
  }
}

/// @param predicted  whether to start where the velocities point to, or from where the step begins
/// @param found      lanes whose unknowns stay what they are
template <class L, bool kElastic>
mask_t<typename L::Scalar> MotionStep<L, kElastic>::solve_from(const mask_t<S>& predicted,
                                                               const mask_t<S>& found) {
  const bool keeps = any(found);
  if (keeps) copy_unknowns(w_.q, q_found_);
  copy_unknowns(q_begin_, w_.q);
  w_.time = time_ + h_;
  if (any(predicted)) {
    predict(h_);
    if constexpr (kHasLanes<S>) select_unknowns(!predicted, q_begin_, w_.q);
  }
  if constexpr (kHasLanes<S>) {
    if (keeps) select_unknowns(found, q_found_, w_.q);
  }
  // Nothing outside holds the momentum of a fragment: it is kept to rounding. With float the
  // rounding of positions is so coarse a floor that what the velocities foretell may be below it.
  // One solve leaves more than rounding, which `balance_fragment` gives back.
  newton_.polishes = !kIsDouble<S> || (claims_.momentum && !newton_.one_solve && in_fragments_);
  w_.stage.midpoint = rule_.midpoint;
  w_.stage.follows = rule_.midpoint ? 0.5 : 1.0;
  const auto outcome = equilibrate(
      chain_, [this](Work& /*w*/, bool slopes) { assemble(slopes); }, newton_, w_,
      [](const Work&) { return PathCondition<L>{}; });
  w_.stage.midpoint = false;
  w_.stage.follows = 1.0;
  iterations_ += outcome.iterations;
  solves_ = solves_ + outcome.solves;
  return outcome.converged & rotates_little() & is_finite();
}

template <class L, bool kElastic>
mask_t<typename L::Scalar> MotionStep<L, kElastic>::rotates_little() const {
  const S most = constant<S>(options_.largest_rotation);
  const S most_of_segment = constant<S>(kLargestStepSpin);
  mask_t<S> little = in_all_lanes<S>(true);
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    little = little & (size_of(step_[i].spin) <= most_of_segment);
    const typename L::Spin increment = w_.q.angle[i] - q_begin_.angle[i];
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      little = little & (w_.q.open[i] | (abs(increment[k]) <= most));
    }
  }
  return little;
}

template <class L, bool kElastic>
mask_t<typename L::Scalar> MotionStep<L, kElastic>::is_finite() const {
  E sum = constant<E>(0.0);
  for (const SegmentMotion<L>& motion : motion_now_) {
    sum += E(dot(motion.velocity, motion.velocity) + dot(motion.spin, motion.spin));
  }
  return sum <= constant<E>(std::numeric_limits<double>::max());
}

}  // namespace plastica::solve
