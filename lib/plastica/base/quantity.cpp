#include "plastica/base/quantity.hpp"

namespace plastica {

std::string_view name_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::None: return "pure number";
    case Dimension::Strain: return "strain";
    case Dimension::Angle: return "angle";
    case Dimension::Stress: return "stress";
    case Dimension::Length: return "length";
    case Dimension::Area: return "area";
    case Dimension::SectionModulus: return "section modulus";
    case Dimension::SecondMoment: return "second moment of area";
    case Dimension::Force: return "force";
    case Dimension::Moment: return "moment";
    case Dimension::Curvature: return "curvature";
    case Dimension::Density: return "density";
    case Dimension::Temperature: return "temperature";
    case Dimension::Time: return "time";
    case Dimension::StrainRate: return "strain rate";
    case Dimension::Acceleration: return "acceleration";
    case Dimension::Stiffness: return "stiffness";
    case Dimension::RotationalStiffness: return "rotational stiffness";
    case Dimension::ForcePerLength: return "force per length";
    case Dimension::MomentPerLength: return "moment per length";
    case Dimension::Velocity: return "velocity";
    case Dimension::AngularVelocity: return "angular velocity";
    case Dimension::Mass: return "mass";
    case Dimension::MomentOfInertia: return "moment of inertia";
    case Dimension::Energy: return "energy";
    case Dimension::EnergyDensity: return "energy density";
    case Dimension::Momentum: return "momentum";
    case Dimension::AngularMomentum: return "angular momentum";
    case Dimension::Frequency: return "frequency";
  }
  return "unknown";
}

std::string_view si_unit(Dimension dimension) {
  switch (dimension) {
    case Dimension::None: return "1";
    case Dimension::Strain: return "1";
    case Dimension::Angle: return "rad";
    case Dimension::Stress: return "Pa";
    case Dimension::Length: return "m";
    case Dimension::Area: return "m^2";
    case Dimension::SectionModulus: return "m^3";
    case Dimension::SecondMoment: return "m^4";
    case Dimension::Force: return "N";
    case Dimension::Moment: return "N m";
    case Dimension::Curvature: return "rad/m";
    case Dimension::Density: return "kg/m^3";
    case Dimension::Temperature: return "K";
    case Dimension::Time: return "s";
    case Dimension::StrainRate: return "1/s";
    case Dimension::Acceleration: return "m/s^2";
    case Dimension::Stiffness: return "N/m";
    case Dimension::RotationalStiffness: return "N m/rad";
    case Dimension::ForcePerLength: return "N/m";
    case Dimension::MomentPerLength: return "N m/m";
    case Dimension::Velocity: return "m/s";
    case Dimension::AngularVelocity: return "rad/s";
    case Dimension::Mass: return "kg";
    case Dimension::MomentOfInertia: return "kg m^2";
    case Dimension::Energy: return "J";
    case Dimension::EnergyDensity: return "J/m^3";
    case Dimension::Momentum: return "N s";
    case Dimension::AngularMomentum: return "N m s";
    case Dimension::Frequency: return "Hz";
  }
  return "1";
}

}  // namespace plastica
