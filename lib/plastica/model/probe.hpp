#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "plastica/base/quantity.hpp"
#include "plastica/model/drive.hpp"
#include "plastica/model/place.hpp"

namespace plastica {

/// What a probe records at each sample of the drive, or at each step of a path.
enum class ProbeQuantity {
  Strain,              ///< of the extreme fibre [1]; of a coupon, as driven
  Stress,              ///< of the extreme fibre [Pa]
  PlasticStrain,       ///< permanent strain, with sign; of a chain with the hinge length, as it
                       ///< breaks (see BreakWatch) [1]
  AccumulatedStrain,   ///< the same of the sum of |d permanent rotation| [1]
  Load,                ///< force [N], bending moment or torque [N m]; coupon only
  Dissipation,         ///< plastic work per volume at the extreme fibre [J/m^3 = Pa]; coupon only
  Displacement,        ///< of a point, in world axes [m]
  Rotation,            ///< of a point's segment, as a rotation vector in world axes [rad]
  Reaction,            ///< force of the support at a place on the beam [N]
  ReactionMoment,      ///< moment of the support at a place on the beam [N m]
  Moment,              ///< of a joint, in the joint's axes: bending, z: torque [N m]
  Angle,               ///< of a joint, from its undeformed state [rad]
  PlasticAngle,        ///< permanent part of a joint's angle [rad]
  Force,               ///< section force at a joint, in its axes: shear, z: axial [N]
  LoadFactor,          ///< the factor of the first load's history, or of the first motion's [1]
  Energy,              ///< of the whole beam, see `EnergyKind` [J]
  Velocity,            ///< of a point, in world axes; dynamics only [m/s]
  Spin,                ///< of a point's segment, about world axes; dynamics only [rad/s]
  Momentum,            ///< of the whole beam, in world axes; dynamics only [N s]
  AngularMomentum,     ///< of the whole beam about the world's origin; dynamics only [N m s]
  LocalPlasticStrain,  ///< permanent strain over a joint's own length, with sign; chain only [1]
  LocalAccumulatedStrain,  ///< sum of its |changes|; chain only [1]
  LargestPlasticStrain,    ///< of all joints, of each that nearest to its limit; chain only [1]
};

/// The words of files for what a probe records, in the order of ProbeQuantity.
std::span<const std::string_view> probe_kinds();

/// Whether a chain's probe is of a joint.
constexpr bool is_of_joint(ProbeQuantity quantity) {
  switch (quantity) {
    case ProbeQuantity::Strain:
    case ProbeQuantity::Stress:
    case ProbeQuantity::PlasticStrain:
    case ProbeQuantity::AccumulatedStrain:
    case ProbeQuantity::LocalPlasticStrain:
    case ProbeQuantity::LocalAccumulatedStrain:
    case ProbeQuantity::Moment:
    case ProbeQuantity::Angle:
    case ProbeQuantity::PlasticAngle:
    case ProbeQuantity::Force: return true;
    default: return false;
  }
}

/// Whether it is the angle of one joint, which follows the joint's length but where a hinge is.
constexpr bool is_angle_of_joint(ProbeQuantity quantity) {
  return quantity == ProbeQuantity::Angle || quantity == ProbeQuantity::PlasticAngle;
}

/// Whether it is where a point is.
constexpr bool is_of_point(ProbeQuantity quantity) {
  return quantity == ProbeQuantity::Displacement;
}

/// Whether it is a number of the whole scene, without place and direction.
constexpr bool is_of_all(ProbeQuantity quantity) {
  return quantity == ProbeQuantity::Energy || quantity == ProbeQuantity::LoadFactor ||
         quantity == ProbeQuantity::LargestPlasticStrain;
}

/// Which part of a vector a probe records. Joint quantities: bending about x, about y, torsion.
enum class Component { X, Y, Z, Size };

/// The words of files for the components, in their order.
inline constexpr std::array<std::string_view, 4> kComponents{"x", "y", "z", "size"};

/// Entries of the energy balance, see `Energies`.
enum class EnergyKind {
  Elastic,
  Plastic,
  External,
  Residual,
  Kinetic,
  Damping,
  NumericalDissipation,
  Impact,
  Fracture,
};

/// The words of files for the energies, in their order.
inline constexpr std::array<std::string_view, 9> kEnergyKinds{
    "elastic", "plastic", "external", "residual", "kinetic", "damping", "numerical_dissipation",
    "impact",  "fracture"};

struct Probe {
  std::string name;  ///< unique within a scene
  ProbeQuantity quantity = ProbeQuantity::Stress;
  Place at{1.0, {}};  ///< joint quantities: the nearest joint
  Component component = Component::Y;
  EnergyKind energy = EnergyKind::Elastic;
};

/// What a quantity measures.
/// @param deformation  of a coupon: decides what its load is
Dimension dimension_of(ProbeQuantity quantity, Deformation deformation);

}  // namespace plastica
