#pragma once

#include "plastica/run/chain_record.hpp"

/// What supports do to a chain, and the energies of its path or motion.
namespace plastica {

template <class L, bool kElastic>
double ChainRecord<L, kElastic>::load_work(const chain::SegmentLoad<L>& load, const Work& w) const {
  const History& history = build_->chain.histories[load.history];
  const S now = constant<S>(0.5 * history.at(w.time));
  const S then = constant<S>(0.5 * history.at(time_));
  const auto& frame = w.placement.frame[load.segment];
  const auto& old_frame = placement_.frame[load.segment];
  const typename L::Point displacement =
      w.placement.point(load.segment, load.arm) - placement_.point(load.segment, load.arm);
  const typename L::Spin increment = L::axes(old_frame) * L::angle_from(old_frame, frame);
  if (!load.follows) {
    return (now + then) * (dot(load.force, displacement) + dot(load.moment, increment));
  }
  const typename L::Point force =
      now * L::rotate(frame, load.force) + then * L::rotate(old_frame, load.force);
  const typename L::Spin moment =
      now * (L::axes(frame) * load.moment) + then * (L::axes(old_frame) * load.moment);
  return dot(force, displacement) + dot(moment, increment);
}

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::add_work(const Work& w, const Joints& joints) {
  if (!begun_) {
    const Energies begins = energies(w, joints);
    external_ = begins.elastic + begins.plastic;
  }
  const auto& supports = model_->scene.supports;
  for (std::size_t s = 0; s < supports.size(); ++s) {
    if (!supports[s].moves()) continue;
    const std::array<double, 6> force = support_force(w, s);
    if (begun_) {
      const double moved = supports[s].history.at(w.time) - supports[s].history.at(time_);
      for (std::size_t k = 0; k < 3; ++k) {
        external_ += 0.5 * (force[k] + support_force_[s][k]) * supports[s].translation[k] * moved;
        external_ +=
            0.5 * (force[3 + k] + support_force_[s][3 + k]) * supports[s].rotation[k] * moved;
      }
    }
    support_force_[s] = force;
  }
  if (begun_) {
    for (const auto& load : build_->chain.loads) external_ += load_work(load, w);
  }
  for (const auto& load : build_->chain.loads) {
    placement_.frame[load.segment] = w.placement.frame[load.segment];
    placement_.position[load.segment] = w.placement.position[load.segment];
  }
  time_ = w.time;
  begun_ = true;
}

template <class L, bool kElastic>
double ChainRecord<L, kElastic>::spring_energy(const Work& w) const {
  double energy = 0.0;
  for (const auto& spring : build_->chain.springs) {
    const S factor = constant<S>(build_->chain.histories[spring.history].at(w.time));
    const typename L::Point off =
        w.placement.point(spring.segment, spring.arm) - spring.rest - factor * spring.motion;
    for (std::size_t k = 0; k < L::kTranslations; ++k) {
      energy += constant<S>(0.5) * spring.stiffness[k] * off[k] * off[k];
    }
  }
  return energy;
}

/// What springs and the joints that still join have stored.
template <class L, bool kElastic>
double ChainRecord<L, kElastic>::stored_energy(const Work& w, const Joints& joints) const {
  double sum = spring_energy(w);
  const std::size_t n = build_->chain.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!w.q.open[i]) sum += joints.elastic_energy()[i];
  }
  for (std::size_t g = 0; g < build_->chain.ground_joints.size(); ++g) {
    const std::size_t joint = build_->chain.ground_joints[g].joint;
    if (!w.q.released_ground_joint[g]) sum += joints.elastic_energy()[joint];
  }
  return sum;
}

template <class L, bool kElastic>
Energies ChainRecord<L, kElastic>::energies(const Work& w, const Joints& joints) const {
  Energies sum;
  if (prescribed_) {
    sum.elastic = prescribed_->elastic;
    sum.plastic = prescribed_->plastic;
  } else {
    sum.elastic = stored_energy(w, joints);
    for (const S& work : joints.plastic_work()) sum.plastic += work;
  }
  if (motion_ == nullptr) {
    sum.external = external_;
  } else {
    sum.kinetic = kinetic_;
    sum.external = energy_at_start_ + flows_.external;
    sum.damping = flows_.damping;
    sum.numerical_dissipation = flows_.numerical_dissipation;
    sum.impact = flows_.impact;
    sum.fracture = flows_.fracture;
  }
  sum.residual = sum.external - sum.elastic - sum.plastic - sum.kinetic - sum.damping -
                 sum.numerical_dissipation - sum.impact - sum.fracture;
  return sum;
}

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::begin_motion(const Work& w, const Joints& joints,
                                            const std::vector<solve::SegmentMotion<L>>& motion,
                                            double kinetic) {
  set_motion(motion, kinetic, {});
  energy_at_start_ = kinetic + (prescribed_ ? prescribed_->elastic : stored_energy(w, joints));
}

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::set_motion(const std::vector<solve::SegmentMotion<L>>& motion,
                                          double kinetic, const solve::EnergyFlows& flows) {
  motion_ = &motion;
  kinetic_ = kinetic;
  flows_ = flows;
}

template <class L, bool kElastic>
typename L::Point ChainRecord<L, kElastic>::spring_force(const chain::Spring<L>& spring,
                                                         const Work& w) const {
  const S factor = constant<S>(build_->chain.histories[spring.history].at(w.time));
  const typename L::Point off =
      w.placement.point(spring.segment, spring.arm) - spring.rest - factor * spring.motion;
  typename L::Point push;
  for (std::size_t k = 0; k < L::kTranslations; ++k) push[k] = -(spring.stiffness[k] * off[k]);
  return push;
}

template <class L, bool kElastic>
typename ChainRecord<L, kElastic>::Space ChainRecord<L, kElastic>::force_at(
    const Work& w, std::size_t node) const {
  const auto& chain = build_->chain;
  const auto& supports = model_->scene.supports;
  const auto is_at = [&](std::size_t support, double fraction) {
    return std::fabs(fraction_of(supports[support].at, model_->layout.ends) - fraction) < 1e-9;
  };
  if (node < chain.size()) {
    typename L::Point force = w.transmitted.outer[node].force;
    // What springs at the start pass to the ground is no force of the beam beyond.
    for (const auto& spring : chain.springs) {
      if (node == 0 && !supports[spring.support].to && is_at(spring.support, 0.0)) {
        force -= spring_force(spring, w);
      }
    }
    return in_space(L::rotate_back(w.placement.near[node], force));
  }
  // To the ground at the end: all that is beyond is what the supports there push.
  Space sum{};
  for (std::size_t s = 0; s < supports.size(); ++s) {
    if (supports[s].to || !is_at(s, 1.0)) continue;
    const auto force = support_force(w, s);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += force[k];
  }
  const std::size_t last = chain.size() - 1;
  const auto frame = L::compose(w.placement.frame[last], chain.segments[last].outer);
  return in_space(L::rotate_back(frame, view_.point(sum)));
}

template <class L, bool kElastic>
std::array<double, 6> ChainRecord<L, kElastic>::reaction(const Work& w, std::size_t support) const {
  std::array<double, 6> all = support_force(w, support);
  for (const auto& held : build_->held_moments) {
    if (held.support != support) continue;
    const S factor = constant<S>(build_->chain.histories[held.history].at(w.time));
    const Space moment = joint_spin(factor * held.moment);
    for (std::size_t k = 0; k < 3; ++k) all[3 + k] -= moment[k];
  }
  const Space moment = moment_of_bed(w, support);
  for (std::size_t k = 0; k < 3; ++k) all[3 + k] += moment[k];
  return all;
}

template <class L, bool kElastic>
typename ChainRecord<L, kElastic>::Space ChainRecord<L, kElastic>::moment_of_bed(
    const Work& w, std::size_t support) const {
  Space sum{};
  const Support& bed = model_->scene.supports[support];
  if (!bed.to) return sum;
  const double begin = fraction_of(bed.at, model_->layout.ends);
  const chain::SegmentPoint start = chain::segment_point(model_->layout, begin);
  const Space from = in_space(w.placement.point(start.segment, view_.point(start.arm)));
  for (const auto& spring : build_->chain.springs) {
    if (spring.support != support) continue;
    const Space arm = in_space(w.placement.point(spring.segment, spring.arm)) - from;
    sum += cross(arm, in_space(spring_force(spring, w)));
  }
  return sum;
}

template <class L, bool kElastic>
std::array<double, 6> ChainRecord<L, kElastic>::support_force(const Work& w,
                                                              std::size_t support) const {
  const auto& chain = build_->chain;
  Space force{};
  Space moment{};
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    const auto& constraint = chain.constraints[k];
    if (constraint.support != support || !w.closed[k]) continue;
    force += in_space(w.q.multiplier[k] * constraint.direction);
    moment += joint_spin(w.q.multiplier[k] * constraint.axis);
  }
  for (const auto& spring : chain.springs) {
    if (spring.support == support) force += in_space(spring_force(spring, w));
  }
  const auto spin_force = [&](std::size_t joint) {
    typename L::Spin m;
    for (std::size_t k = 0; k < L::kRotations; ++k) m[k] = w.joints.force[joint][k];
    return m;
  };
  for (const auto& joint : chain.ground_joints) {
    const auto g = static_cast<std::size_t>(&joint - chain.ground_joints.data());
    if (joint.support != support || w.q.released_ground_joint[g]) continue;
    const auto axes = L::axes(chain::ground_joint_axes(joint, w.placement));
    moment += joint_spin(axes * spin_force(joint.joint));
  }
  if (chain.root.support == support) {
    typename L::Point held;
    for (std::size_t k = 0; k < L::kTranslations; ++k) {
      held[k] = chain.root.held[k] ? -w.transmitted.outer[0].force[k] : constant<S>(0);
    }
    force += in_space(held);
    typename L::Spin moment_in_joint = w.q.open[0] ? typename L::Spin{} : -spin_force(0);
    const auto near = L::axes(w.placement.near[0]);
    typename L::Spin in_joint = transposed_times(near, w.transmitted.outer[0].moment);
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      if (chain.root.clamped[k]) moment_in_joint[k] = -in_joint[k];
    }
    moment += joint_spin(near * moment_in_joint);
  }
  return world_axes(force, moment);
}

}  // namespace plastica
