#pragma once

#include "plastica/solve/motion_step.hpp"

/// The energy balance of a step. Work is that of the forces as the scheme takes them (half way, at
/// the end, or the mean of both ends) over the step's motion.
namespace plastica::solve {

template <class L, bool kElastic>
sum_t<typename L::Scalar> MotionStep<L, kElastic>::load_work() const {
  const double end = rule_.end_work;
  E work = constant<E>(0.0);
  for (const auto& load : chain_.loads) {
    const std::size_t i = load.segment;
    const auto over = [&](const Placement& placement, const E& factor) {
      const auto unit = chain::unit_wrench(load, placement);
      const auto arm = L::rotate(placement.frame[i], chain_.inertias[i].center);
      // Moved to the center of mass, whose displacement the step knows.
      const typename L::Spin moment = unit.moment - L::moment(arm, unit.force);
      return factor * E(dot(unit.force, step_[i].displacement) + dot(moment, step_[i].spin));
    };
    const auto factor_at = [&](double time) {
      return chain::factor_as<E>(chain_.histories[load.history].at(time));
    };
    if (rule_.midpoint) {
      work += over(w_.stage.placement, history_factor_[load.history]);
    } else {
      work += constant<E>(end) * over(w_.placement, factor_at(w_.time));
      if (end < 1.0) work += constant<E>(1.0 - end) * over(begin_, factor_at(time_));
    }
  }
  return work;
}

/// Moment of a joint to the ground on its segment, where forces act.
template <class L, bool kElastic>
typename L::Spin MotionStep<L, kElastic>::ground_moment(std::size_t g) const {
  const auto& joint = chain_.ground_joints[g];
  typename L::Spin force;
  for (std::size_t k = 0; k < L::kRotations; ++k) force[k] = w_.joints.force[joint.joint][k];
  if (rule_.midpoint) return w_.stage.ground_axes[g] * force;
  return L::axes(chain::ground_joint_axes(joint, w_.placement)) * force;
}

/// Work of what moves: the ground at the root, supports that hold, springs' feet. Contacts do none;
/// what they do in a scheme, as they close or open within a step, is the scheme's.
template <class L, bool kElastic>
sum_t<typename L::Scalar> MotionStep<L, kElastic>::ground_work() {
  const S end = constant<S>(rule_.end_work);
  const S begin = constant<S>(1.0 - rule_.end_work);
  E work = constant<E>(0.0);
  const auto moved = [&](std::size_t history) {
    const auto& factor = chain_.histories[history];
    return chain::factor_as<S>(factor.at(w_.time) - factor.at(time_));
  };
  const auto is_something = [](const S& moves) {
    return any((moves < constant<S>(0)) | (moves > constant<S>(0)));
  };
  const S root = moved(chain_.root.history);
  const chain::Wrench<L> passed = w_.transmitted.outer[0];
  if (is_something(root)) {
    const chain::Wrench<L> mean{end * passed.force + begin * root_wrench_.force,
                                end * passed.moment + begin * root_wrench_.moment};
    const typename L::Spin increment = L::step_spin(begin_.near[0], w_.placement.near[0]);
    work -= dot(mean.force, root * chain_.root.motion) + dot(mean.moment, increment);
  }
  root_wrench_ = passed;

  for (std::size_t k = 0; k < chain_.constraints.size(); ++k) {
    const auto& constraint = chain_.constraints[k];
    const S now = select(w_.closed[k], w_.q.multiplier[k], constant<S>(0));
    const S mean = end * now + begin * multiplier_[k];
    work += mean * moved(constraint.history) * constraint.motion;
    if (constraint.one_sided && any(!w_.q.released_constraint[k])) {
      const S closed = chain::constraint_gap(chain_, constraint, w_.placement, w_.time) -
                       chain::constraint_gap(chain_, constraint, begin_, time_);
      flows_.numerical_dissipation -= mean * closed;
    }
    multiplier_[k] = now;
  }
  for (const auto& spring : chain_.springs) {
    const S foot = moved(spring.history);
    if (!is_something(foot)) continue;
    for (std::size_t k = 0; k < L::kTranslations; ++k) {
      const auto force = [&](const Placement& placement, double time) {
        const S at =
            chain::factor_as<S>(chain_.histories[spring.history].at(time)) * spring.motion[k];
        return -spring.stiffness[k] *
               (placement.point(spring.segment, spring.arm)[k] - spring.rest[k] - at);
      };
      work += constant<S>(0.5) * (force(begin_, time_) + force(w_.placement, w_.time)) * foot *
              spring.motion[k];
    }
  }
  for (std::size_t g = 0; g < chain_.ground_joints.size(); ++g) {
    const auto& joint = chain_.ground_joints[g];
    const typename L::Spin now = ground_moment(g);
    const typename L::Spin mean = end * now + begin * ground_moment_[g];
    ground_moment_[g] = now;
    if (any(w_.q.released_ground_joint[g])) continue;
    work += dot(mean, moved(joint.history) * joint.motion);
  }
  return work;
}

/// What the step's inertia forces took up.
template <class L, bool kElastic>
sum_t<typename L::Scalar> MotionStep<L, kElastic>::inertia_work() const {
  const S end = constant<S>(rule_.end_work);
  const S begin = constant<S>(1.0 - rule_.end_work);
  E work = constant<E>(0.0);
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const typename L::Point force = end * inertia_now_[i].force + begin * inertia_[i].force;
    const typename L::Spin moment = end * inertia_now_[i].moment + begin * inertia_[i].moment;
    work -= dot(force, step_[i].displacement) + dot(moment, step_[i].spin);
  }
  return work;
}

template <class L, bool kElastic>
void MotionStep<L, kElastic>::add_flows() {
  flows_.external += load_work() + ground_work();
  E gained = constant<E>(0.0);
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    gained += kinetic_energy(chain_.inertias[i], motion_now_[i]) -
              kinetic_energy(chain_.inertias[i], motion_[i]);
  }
  flows_.numerical_dissipation += inertia_work() - gained;
  joint_motion_.add_flows(
      rule_, [this](std::size_t joint) { return joins(joint); }, flows_);
}

}  // namespace plastica::solve
