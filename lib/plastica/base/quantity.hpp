#pragma once

#include <string_view>

namespace plastica {

/// What a number measures. Every field and column has one; it decides which units are allowed.
enum class Dimension {
  None,                 ///< a pure number or a count
  Strain,               ///< %, 1, mm/mm, in/in
  Angle,                ///< rad, deg
  Stress,               ///< Pa; never a bare number
  Length,               ///< m
  Area,                 ///< m^2
  SectionModulus,       ///< m^3
  SecondMoment,         ///< m^4, of area
  Force,                ///< N
  Moment,               ///< N m
  Curvature,            ///< rad/m (bending), twist per length (torsion)
  Density,              ///< kg/m^3
  Temperature,          ///< K
  Time,                 ///< s
  StrainRate,           ///< 1/s
  Acceleration,         ///< m/s^2
  Stiffness,            ///< N/m
  RotationalStiffness,  ///< N m/rad
  ForcePerLength,       ///< N/m
  MomentPerLength,      ///< N m/m
  Velocity,             ///< m/s
  AngularVelocity,      ///< rad/s
  Mass,                 ///< kg
  MomentOfInertia,      ///< kg m^2
  Energy,               ///< J
  EnergyDensity,        ///< J/m^3
  Momentum,             ///< N s
  AngularMomentum,      ///< N m s
  Frequency,            ///< Hz, periods in a second; never rad/s
};

/// The last of the list.
inline constexpr Dimension kLastDimension = Dimension::Frequency;

/// Name of a dimension as messages use it: "stress", "a pure number".
std::string_view name_of(Dimension dimension);

/// The SI unit in which the library holds values of a dimension: "Pa", "m^2", "1".
std::string_view si_unit(Dimension dimension);

}  // namespace plastica
