#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plastica/model/section_kind.hpp"
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

/// The largest over the section of a strain or stress with these parts of bending about x and y.
inline double bending_together(const Section& section, double by_x, double by_y) {
  return section_kind(section).round() ? std::hypot(by_x, by_y) : std::fabs(by_x) + std::fabs(by_y);
}

}  // namespace detail

template <class L, bool kElastic>
double ChainRecord<L, kElastic>::largest_stress(std::size_t joint, const Space& moment) const {
  const chain::PartForm& part = part_of(joint);
  return detail::bending_together(*part.section, moment[0] / part.properties.section_modulus_x,
                                  moment[1] / part.properties.section_modulus_y);
}

template <class L, bool kElastic>
double ChainRecord<L, kElastic>::hinge_strain(const Probe& probe,
                                              const std::vector<JointAngles>& angles) const {
  const auto strain = watch_->strains_at(angles, node_at(probe.at));
  return strain[static_cast<std::size_t>(probe.component)];
}

template <class L, bool kElastic>
double ChainRecord<L, kElastic>::joint_value(const Probe& probe, const NodeStrains& strains) const {
  const ChainHistory& history = shape_;
  const std::size_t node = node_at(probe.at);
  const std::size_t at = 3 * node;
  const auto vector = [&](const std::vector<double>& values) {
    return Space{{values[at], values[at + 1], values[at + 2]}};
  };
  const std::size_t joint = joint_of_node_[node];
  const chain::PartForm& part = part_of(joint);
  const SectionProperties& p = part.properties;
  const auto& length = (*numbers_)[joint].length;
  // Strain of the extreme fibre per angle of the joint.
  const Space lever{{p.second_moment_x / p.section_modulus_x / length[law::kBendingX],
                     p.second_moment_y / p.section_modulus_y / length[law::kBendingY],
                     p.torsion_constant / p.torsion_modulus / length[law::kTorsion]}};
  const auto strain = [&](const Space& angle) {
    const Space of_axis{{lever[0] * angle[0], lever[1] * angle[1], lever[2] * angle[2]}};
    if (probe.component != Component::Size) return detail::component_of(of_axis, probe.component);
    return detail::bending_together(*part.section, of_axis[0], of_axis[1]);
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
      const JointAngles& sum = strains.accumulated[node];
      return strain({{sum[0], sum[1], sum[2]}});
    }
    default: break;
  }
  // Stress.
  const Space moment = vector(history.moment);
  if (probe.component == Component::Size) return largest_stress(joint, moment);
  return detail::component_of({{moment[0] / p.section_modulus_x, moment[1] / p.section_modulus_y,
                                moment[2] / p.torsion_modulus}},
                              probe.component);
}

/// Displacement or rotation of a point.
template <class L, bool kElastic>
typename ChainRecord<L, kElastic>::Space ChainRecord<L, kElastic>::point_value(
    const Probe& probe, const Work& w) const {
  const chain::SegmentPoint point =
      chain::segment_point(model_->layout, share_of(probe.at, model_->layout.ends));
  if (probe.quantity == ProbeQuantity::Rotation) return rotation(w, point.segment);
  const auto undeformed =
      model_->layout.segment_frame[point.segment] * point.arm + model_->layout.node[point.segment];
  typename L::Point now = w.placement.point(point.segment, view_.point(point.arm));
  if constexpr (kElastic) {
    // At a joint that has stretched and sheared, the middle of the gap.
    const std::size_t beyond = point.segment + 1;
    const bool joins = beyond < build_->chain.size() && !w.q.open[beyond] &&
                       segment_end_at(probe.at, model_->layout.ends) == static_cast<int>(beyond);
    if (joins) now = constant<S>(0.5) * (now + w.placement.position[beyond]);
  }
  return in_space(now - view_.point(undeformed));
}

/// Velocity or spin of a point, or the momentum of all.
template <class L, bool kElastic>
typename ChainRecord<L, kElastic>::Space ChainRecord<L, kElastic>::motion_value(
    const Probe& probe, const Work& w) const {
  if (motion_ == nullptr) return {};
  const auto& chain = build_->chain;
  const auto spin_of = [&](std::size_t i) {
    return L::axes(w.placement.frame[i]) * (*motion_)[i].spin;
  };
  if (probe.quantity == ProbeQuantity::Velocity || probe.quantity == ProbeQuantity::Spin) {
    const chain::SegmentPoint point =
        chain::segment_point(model_->layout, share_of(probe.at, model_->layout.ends));
    const std::size_t i = point.segment;
    if (probe.quantity == ProbeQuantity::Spin) return joint_spin(spin_of(i));
    const auto arm =
        L::turn(w.placement.frame[i], view_.point(point.arm) - chain.inertias[i].center);
    return in_space((*motion_)[i].velocity + L::spun(spin_of(i), arm));
  }
  typename L::Point momentum{};
  typename L::Spin turning{};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto& inertia = chain.inertias[i];
    const typename L::Point own = inertia.mass * (*motion_)[i].velocity;
    momentum += own;
    turning += L::moment(w.placement.point(i, inertia.center), own) +
               L::axes(w.placement.frame[i]) * (inertia.turning * (*motion_)[i].spin);
  }
  return probe.quantity == ProbeQuantity::Momentum ? in_space(momentum) : joint_spin(turning);
}

template <class L, bool kElastic>
double ChainRecord<L, kElastic>::probe_value(const Probe& probe, const Work& w,
                                             const NodeStrains& strains, const Response& response,
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
      const double share = share_of(probe.at, model_->layout.ends);
      Space sum{};
      for (std::size_t s = 0; s < model_->scene.supports.size(); ++s) {
        const double at = share_of(model_->scene.supports[s].at, model_->layout.ends);
        if (std::fabs(at - share) > 1e-9) continue;
        const auto force = reaction(w, s);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += force[first + k];
      }
      return detail::component_of(sum, probe.component);
    }
    case ProbeQuantity::LoadFactor: return response.chain.factor[sample];
    case ProbeQuantity::Energy: {
      const Energies& energy = response.chain.energy[sample];
      switch (probe.energy) {
        case EnergyKind::Elastic: return energy.elastic;
        case EnergyKind::Plastic: return energy.plastic;
        case EnergyKind::External: return energy.external;
        case EnergyKind::Residual: return energy.residual;
        case EnergyKind::Kinetic: return energy.kinetic;
        case EnergyKind::Damping: return energy.damping;
        case EnergyKind::Numerical: return energy.numerical;
        case EnergyKind::Impact: return energy.impact;
        case EnergyKind::Fracture: return energy.fracture;
      }
      return 0.0;
    }
    default: return joint_value(probe, strains);
  }
}

}  // namespace plastica
