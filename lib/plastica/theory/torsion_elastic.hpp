#pragma once

#include "plastica/model/section.hpp"

namespace plastica::theory {

// Saint-Venant torsion: even section free to warp, elastic. J and W_t are those of
// section_properties: a rectangle's by Saint-Venant's series, a circle's exact.

/// Angle between the two ends of a bar [rad]: T L/(G J).
/// @param torque         T at the ends [N m]
/// @param length         L [m]
/// @param shear_modulus  G [Pa], > 0
double end_twist(const Section& section, double shear_modulus, double length, double torque);

/// Angle between the fixed and the free end under an even torque along the bar [rad]:
/// t L^2/(2 G J).
/// @param distributed  t [N m/m]
double end_twist_distributed(const Section& section, double shear_modulus, double length,
                             double distributed);

/// Largest shear stress of the section [Pa]: T/W_t; of a rectangle in the middle of a long side.
double largest_shear_stress(const Section& section, double torque);

}  // namespace plastica::theory
