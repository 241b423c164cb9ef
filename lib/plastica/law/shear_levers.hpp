#pragma once

#include <vector>

namespace plastica::law {

/// What a section's torsion comes to.
struct TorsionTargets {
  double constant = 0.0;         ///< J [m^4]
  double modulus = 0.0;          ///< W_t [m^3]
  double plastic_modulus = 0.0;  ///< T_p/tau_y [m^3]
};

/// Shear strain of each fibre per twist [m], for a section that is not round.
///
/// Saint-Venant's shear g grows with the twist alone while all is elastic. Beyond, the section
/// warps otherwise: with g itself the fully plastic torque would be tau_y sum A g, 4.9 % above
/// Nadai's sand heap for a rectangle of 3:2. So fibres have the lever min(c g^m, J/W_t), with c and
/// m such that
///   sum A lever^2 = J  and  sum A lever = T_p/tau_y,
/// and none is above the largest shear J/W_t: the torque is exact while elastic, where it first
/// yields and where all has yielded, and rises between them. m is 1 where g does it (thin walls).
/// Since W_t <= T_p/tau_y <= sqrt(J A), such a pair exists for fibres enough.
/// @param area   of each fibre [m^2] (n)
/// @param shear  g, shear stress over G times twist [m] (n), > 0
/// @return (n)
std::vector<double> shear_levers(const std::vector<double>& area, const std::vector<double>& shear,
                                 const TorsionTargets& targets);

}  // namespace plastica::law
