#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plastica/model/beam_axis.hpp"
#include "plastica/run/chain_record.hpp"

/// What the probes of a chain record.
namespace plastica {

namespace detail {

/// The component of a vector that a probe asks for.
inline double component_of(const Vec<double, 3>& v, Component component) {
  switch (component) {
    case Component::X: return v[0];
    case Component::Y: return v[1];
    case Component::Z: return v[2];
    case Component::Size: return std::sqrt(dot(v, v));
  }
  return 0.0;
}

}  // namespace detail

template <class L, bool kElastic>
double ChainRecord<L, kElastic>::hinge_strain(const Probe& probe,
                                              const std::vector<JointFlow>& angles) const {
  const auto strain = watch_->strains_at(angles, turning_node_at(probe));
  return strain[static_cast<std::size_t>(probe.component)];
}

template <class L, bool kElastic>
double ChainRecord<L, kElastic>::joint_value(const Probe& probe, const NodeStrains& strains) const {
  const ChainHistory& history = shape_;
  const bool of_moment = probe.quantity == ProbeQuantity::Moment ||
                         probe.quantity == ProbeQuantity::Force ||
                         probe.quantity == ProbeQuantity::Stress;
  const std::size_t node = of_moment ? node_at(probe.at) : turning_node_at(probe);
  const std::size_t at = 3 * node;
  const auto vector = [&](const std::vector<double>& values) {
    return Space{{values[at], values[at + 1], values[at + 2]}};
  };
  const chain::JointModel& joint = (*joints_)[node];
  // Of the extreme fibre by one component, or of bending about both axes.
  const auto of_section = [&](const Space& of_axis) {
    if (probe.component != Component::Size) return detail::component_of(of_axis, probe.component);
    return joint.bending_together(of_axis[0], of_axis[1]);
  };
  const auto strain = [&](Space angle) {
    for (std::size_t k = 0; k < 3; ++k) angle[k] *= joint.strain_per_angle(k);
    return of_section(angle);
  };
  switch (probe.quantity) {
    case ProbeQuantity::Moment:
      return detail::component_of(vector(history.moment), probe.component);
    case ProbeQuantity::Angle: return detail::component_of(vector(history.angle), probe.component);
    case ProbeQuantity::PlasticAngle:
      return detail::component_of(vector(history.plastic_angle), probe.component);
    case ProbeQuantity::Force: return detail::component_of(vector(history.force), probe.component);
    case ProbeQuantity::Strain: return strain(vector(history.angle));
    case ProbeQuantity::PlasticStrain: return hinge_strain(probe, strains.permanent);
    case ProbeQuantity::AccumulatedStrain: return hinge_strain(probe, strains.accumulated);
    case ProbeQuantity::LocalPlasticStrain: return strain(vector(history.plastic_angle));
    case ProbeQuantity::LocalAccumulatedStrain: {
      const JointFlow& sum = strains.accumulated[node];
      return strain({{sum[0], sum[1], sum[2]}});
    }
    default: break;
  }
  Space stress = vector(history.moment);
  for (std::size_t k = 0; k < 3; ++k) stress[k] = joint.stress(k, stress[k]);
  return of_section(stress);
}

/// A node lies between two halves of its joint that give way by a and b per force. A force F there
/// is carried by a as V + F and by b as V, and acts as F a/(a + b) on the segment beyond
/// (`Builder::add_single_load`), so that the joint has f = V + F a/(a + b) and the gap
/// d = (a + b) f. The node is a (V + F) off the segment before: a/(a + b) d + a b/(a + b) F. In a
/// motion the last term, which has no mass, would jump with the force: it is left out there. Axes
/// are the joint's; at a corner, what couples those of its halves is left out, of first order.
template <class L, bool kElastic>
typename L::Point ChainRecord<L, kElastic>::sheared_node(std::size_t node, const Work& w) const {
  const auto& chain = build_->chain;
  const auto& segment_end = chain.segments[node - 1].arm;
  typename L::Point force{};
  for (const auto& load : chain.loads) {
    const bool at_end = load.segment == node - 1 && chain::same_node(chain, load.arm, segment_end);
    const bool at_start =
        load.segment == node && chain::same_node(chain, load.arm, typename L::Point{});
    if (!at_end && !at_start) continue;
    const S factor = constant<S>(chain.histories[load.history].at(w.time));
    force += factor * chain::unit_wrench(load, w.placement).force;
  }
  const auto& frame = w.placement.near[node];
  const typename L::Point before = w.placement.point(node - 1, segment_end);
  const Space gap = in_space(L::rotate_back(frame, w.placement.position[node] - before));
  const S at_rest = constant<S>(motion_ == nullptr ? 1 : 0);
  const Space acts = in_space(L::rotate_back(frame, at_rest * force));
  const chain::JointModel& joint = (*joints_)[node];
  Space off;
  for (std::size_t k = 0; k < 3; ++k) {
    const double fraction_before = joint.fraction_of_force[k];
    off[k] =
        fraction_before * (gap[k] + (1.0 - fraction_before) * joint.shift_compliance[k] * acts[k]);
  }
  return before + L::rotate(frame, view_.point(off));
}

template <class L, bool kElastic>
typename ChainRecord<L, kElastic>::Space ChainRecord<L, kElastic>::rotation(
    const Work& w, std::size_t segment) const {
  const auto& undeformed = build_->undeformed.frame[segment];
  return joint_spin(L::axes(undeformed) * L::angle_from(undeformed, w.placement.frame[segment]));
}

/// Of the loads at an inner node, in world axes.
template <class L, bool kElastic>
typename L::Spin ChainRecord<L, kElastic>::moment_at_node(std::size_t node, const Work& w) const {
  const chain::Layout& layout = model_->layout;
  typename L::Spin sum{};
  for (const Load& load : model_->scene.loads) {
    const Space moment{load.moment};
    if (load.to || dot(moment, moment) == 0.0) continue;
    if (segment_end_at(load.at, layout.ends) != static_cast<int>(node)) continue;
    const S factor = constant<S>(load.history.at(w.time));
    const auto& frame = layout.segment_frame[node - 1];
    sum += factor * (load.follows ? L::axes(w.placement.frame[node - 1]) *
                                        view_.spin(transpose(frame) * moment)
                                  : view_.spin(moment));
  }
  return sum;
}

/// None where the joint is cut, or where a support holds or springs the node between its halves.
template <class L, bool kElastic>
SpreadJoint ChainRecord<L, kElastic>::spread_joint_at(const Probe& probe, const Work& w) const {
  const chain::Layout& layout = model_->layout;
  const SpreadJoint found =
      spread_joint(layout, *joints_, fraction_of(probe.at, layout.ends), model_->scene.beam.length);
  const auto is_here = [&](const auto& ground) { return ground.node == found.node; };
  const bool held = std::ranges::any_of(build_->chain.ground_joints, is_here);
  return found.node == 0 || w.q.open[found.node] || held ? SpreadJoint{} : found;
}

/// Of the beam at a point, from the undeformed beam, as a rotation vector in world axes.
template <class L, bool kElastic>
typename ChainRecord<L, kElastic>::Space ChainRecord<L, kElastic>::rotation_value(
    const Probe& probe, const Work& w) const {
  const SpreadJoint spread = spread_joint_at(probe, w);
  if (spread.node == 0) {
    const double fraction = fraction_of(probe.at, model_->layout.ends);
    return rotation(w, chain::segment_point(model_->layout, fraction).segment);
  }
  const auto& near = w.placement.near[spread.node];
  const S at_rest = constant<S>(motion_ == nullptr ? 1 : 0);  // as of a sheared node
  const auto moment = transposed_times(L::axes(near), at_rest * moment_at_node(spread.node, w));
  typename L::Spin angle = w.q.angle[spread.node];
  for (std::size_t k = 0; k < L::kRotations; ++k) {
    const std::size_t axis = view_.section_axes().rotation(k);
    angle[k] =
        constant<S>(spread.part[axis]) * angle[k] + constant<S>(spread.added[axis]) * moment[k];
  }
  const auto& undeformed = build_->undeformed.near[spread.node];
  return joint_spin(L::axes(undeformed) *
                    L::angle_from(undeformed, L::compose(near, L::rotation(angle))));
}

/// Displacement or rotation of a point.
template <class L, bool kElastic>
typename ChainRecord<L, kElastic>::Space ChainRecord<L, kElastic>::point_value(
    const Probe& probe, const Work& w) const {
  const chain::SegmentPoint point =
      chain::segment_point(model_->layout, fraction_of(probe.at, model_->layout.ends));
  if (probe.quantity == ProbeQuantity::Rotation) return rotation_value(probe, w);
  const auto undeformed =
      model_->layout.segment_frame[point.segment] * point.arm + model_->layout.node[point.segment];
  typename L::Point now = w.placement.point(point.segment, view_.point(point.arm));
  if constexpr (kElastic) {
    const std::size_t beyond = point.segment + 1;
    const bool joins = beyond < build_->chain.size() && !w.q.open[beyond] &&
                       segment_end_at(probe.at, model_->layout.ends) == static_cast<int>(beyond);
    if (joins) now = sheared_node(beyond, w);
  }
  return in_space(now - view_.point(undeformed));
}

template <class L, bool kElastic>
typename L::Spin ChainRecord<L, kElastic>::spin_of(std::size_t segment, const Work& w) const {
  return L::axes(w.placement.frame[segment]) * (*motion_)[segment].spin;
}

template <class L, bool kElastic>
typename L::Point ChainRecord<L, kElastic>::velocity_of(std::size_t segment,
                                                        const typename L::Point& place,
                                                        const Work& w) const {
  const auto& center = build_->chain.inertias[segment].center;
  const auto arm = L::rotate(w.placement.frame[segment], place - center);
  return (*motion_)[segment].velocity + L::spun(spin_of(segment, w), arm);
}

/// Velocity or spin of a point, or the momentum of all.
template <class L, bool kElastic>
typename ChainRecord<L, kElastic>::Space ChainRecord<L, kElastic>::motion_value(
    const Probe& probe, const Work& w) const {
  if (motion_ == nullptr) return {};
  const auto& chain = build_->chain;
  if (probe.quantity == ProbeQuantity::Velocity || probe.quantity == ProbeQuantity::Spin) {
    const chain::SegmentPoint point =
        chain::segment_point(model_->layout, fraction_of(probe.at, model_->layout.ends));
    if (probe.quantity == ProbeQuantity::Spin) {
      const SpreadJoint spread = spread_joint_at(probe, w);
      if (spread.node == 0) return joint_spin(spin_of(point.segment, w));
      // As the joint's angle is spread, so is its rate.
      const auto before = spin_of(spread.node - 1, w);
      const auto axes = L::axes(w.placement.near[spread.node]);
      auto rate = transposed_times(axes, spin_of(spread.node, w) - before);
      for (std::size_t k = 0; k < L::kRotations; ++k) {
        rate[k] = constant<S>(spread.part[view_.section_axes().rotation(k)]) * rate[k];
      }
      return joint_spin(before + axes * rate);
    }
    const std::size_t beyond = point.segment + 1;
    typename L::Point velocity = velocity_of(point.segment, view_.point(point.arm), w);
    if constexpr (kElastic) {
      const bool joins = beyond < chain.size() && !w.q.open[beyond] &&
                         segment_end_at(probe.at, model_->layout.ends) == static_cast<int>(beyond);
      if (joins) {  // as `sheared_node` moves
        const auto& frame = w.placement.near[beyond];
        Space jump =
            in_space(L::rotate_back(frame, velocity_of(beyond, typename L::Point{}, w) - velocity));
        for (std::size_t k = 0; k < 3; ++k) jump[k] *= (*joints_)[beyond].fraction_of_force[k];
        velocity += L::rotate(frame, view_.point(jump));
      }
    }
    return in_space(velocity);
  }
  typename L::Point momentum{};
  typename L::Spin angular{};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto& inertia = chain.inertias[i];
    const typename L::Point own = inertia.mass * (*motion_)[i].velocity;
    momentum += own;
    angular += L::moment(w.placement.point(i, inertia.center), own) +
               L::axes(w.placement.frame[i]) * (inertia.rotational * (*motion_)[i].spin);
  }
  return probe.quantity == ProbeQuantity::Momentum ? in_space(momentum) : joint_spin(angular);
}

template <class L, bool kElastic>
void ChainRecord<L, kElastic>::set_velocities(const Work& w) {
  if (motion_ == nullptr) return;
  for (std::size_t i = 0; i < build_->chain.size(); ++i) {
    const Space velocity = in_space(velocity_of(i, typename L::Point{}, w));
    const Space spin = joint_spin(spin_of(i, w));
    for (std::size_t k = 0; k < 3; ++k) {
      shape_.velocity[3 * i + k] = velocity[k];
      shape_.spin[3 * i + k] = spin[k];
    }
  }
}

template <class L, bool kElastic>
double ChainRecord<L, kElastic>::probe_value(const Probe& probe, const Work& w,
                                             NodeStrains& strains, const Response& response,
                                             std::size_t sample) const {
  switch (probe.quantity) {
    case ProbeQuantity::Displacement:
    case ProbeQuantity::Rotation:
      return detail::component_of(point_value(probe, w), probe.component);
    case ProbeQuantity::Velocity:
    case ProbeQuantity::Spin:
    case ProbeQuantity::Momentum:
    case ProbeQuantity::AngularMomentum:
      return detail::component_of(motion_value(probe, w), probe.component);
    case ProbeQuantity::Reaction:
    case ProbeQuantity::ReactionMoment: {
      const std::size_t first = probe.quantity == ProbeQuantity::Reaction ? 0 : 3;
      const double fraction = fraction_of(probe.at, model_->layout.ends);
      Space sum{};
      for (std::size_t s = 0; s < model_->scene.supports.size(); ++s) {
        const double at = fraction_of(model_->scene.supports[s].at, model_->layout.ends);
        if (std::fabs(at - fraction) > 1e-9) continue;
        const auto force = reaction(w, s);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += force[first + k];
      }
      return detail::component_of(sum, probe.component);
    }
    case ProbeQuantity::LoadFactor: return response.chain.factor[sample];
    case ProbeQuantity::LargestPlasticStrain: return watch_->largest_strain(strains);
    case ProbeQuantity::Energy: {
      const Energies& energy = response.chain.energy[sample];
      switch (probe.energy) {
        case EnergyKind::Elastic: return energy.elastic;
        case EnergyKind::Plastic: return energy.plastic;
        case EnergyKind::External: return energy.external;
        case EnergyKind::Residual: return energy.residual;
        case EnergyKind::Kinetic: return energy.kinetic;
        case EnergyKind::Damping: return energy.damping;
        case EnergyKind::NumericalDissipation: return energy.numerical_dissipation;
        case EnergyKind::Impact: return energy.impact;
        case EnergyKind::Fracture: return energy.fracture;
      }
      return 0.0;
    }
    default: return joint_value(probe, strains);
  }
}

}  // namespace plastica
