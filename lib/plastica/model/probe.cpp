#include "plastica/model/probe.hpp"

#include <array>

namespace plastica {

std::span<const std::string_view> probe_kinds() {
  static constexpr std::array<std::string_view, 23> kWords{"strain",
                                                           "stress",
                                                           "plastic_strain",
                                                           "accumulated_strain",
                                                           "load",
                                                           "dissipation",
                                                           "displacement",
                                                           "rotation",
                                                           "reaction",
                                                           "reaction_moment",
                                                           "moment",
                                                           "angle",
                                                           "plastic_angle",
                                                           "force",
                                                           "load_factor",
                                                           "energy",
                                                           "velocity",
                                                           "spin",
                                                           "momentum",
                                                           "angular_momentum",
                                                           "local_plastic_strain",
                                                           "local_accumulated_strain",
                                                           "largest_plastic_strain"};
  return kWords;
}

Dimension dimension_of(ProbeQuantity quantity, Deformation deformation) {
  switch (quantity) {
    case ProbeQuantity::Strain:
    case ProbeQuantity::PlasticStrain:
    case ProbeQuantity::AccumulatedStrain:
    case ProbeQuantity::LocalPlasticStrain:
    case ProbeQuantity::LocalAccumulatedStrain:
    case ProbeQuantity::LargestPlasticStrain: return Dimension::Strain;
    case ProbeQuantity::Stress: return Dimension::Stress;
    case ProbeQuantity::Load:
      return deformation == Deformation::Tension ? Dimension::Force : Dimension::Moment;
    case ProbeQuantity::Displacement: return Dimension::Length;
    case ProbeQuantity::Rotation:
    case ProbeQuantity::Angle:
    case ProbeQuantity::PlasticAngle: return Dimension::Angle;
    case ProbeQuantity::Reaction:
    case ProbeQuantity::Force: return Dimension::Force;
    case ProbeQuantity::ReactionMoment:
    case ProbeQuantity::Moment: return Dimension::Moment;
    case ProbeQuantity::LoadFactor: return Dimension::None;
    case ProbeQuantity::Dissipation: return Dimension::EnergyDensity;
    case ProbeQuantity::Energy: return Dimension::Energy;
    case ProbeQuantity::Momentum: return Dimension::Momentum;
    case ProbeQuantity::AngularMomentum: return Dimension::AngularMomentum;
    case ProbeQuantity::Velocity: return Dimension::Velocity;
    case ProbeQuantity::Spin: return Dimension::AngularVelocity;
  }
  return Dimension::None;
}

}  // namespace plastica
