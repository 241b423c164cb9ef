#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "plastica/base/check.hpp"

namespace plastica {

/// How the stress goes on after first yield.
enum class HardeningLaw {
  Ideal,         ///< ideal plasticity: the stress stays at the yield stress
  Linear,        ///< a straight line, part isotropic, part kinematic
  VoceChaboche,  ///< Voce isotropic hardening and three Armstrong-Frederick back-stresses
  Multilinear,   ///< straight lines through a table, part isotropic, part kinematic
};

/// Parameters of the hardening laws; those of another law than `law` are ignored.
///
/// Multilinear: under stress that goes one way, straight lines from (0, sigma_y) through the points
/// (plastic_strain_k, flow_stress_k); beyond the last one the stress stays. With H the slope at the
/// accumulated plastic strain p, the fraction (1 - kinematic_fraction) H grows the yield stress,
/// and dX = kinematic_fraction H de_p moves the yield surface, as in linear hardening.
///
/// VoceChaboche: |sigma - sum X_i| = sigma_y + Q (1 - exp(-b p)), dX_i = C_i de_p - gamma_i X_i dp,
/// with p the accumulated plastic strain (Lemaitre & Chaboche, Mechanics of Solid Materials, 1990,
/// ch. 5). A back-stress with C_i = 0 is absent; with gamma_i = 0 it is linear.
struct Hardening {
  HardeningLaw law = HardeningLaw::Ideal;
  static constexpr std::size_t kTablePoints = 10;

  /// E_t [Pa], 0 <= E_t < E, Linear: slope d(stress)/d(strain) of the monotonic curve after yield
  double tangent_modulus = 0.0;
  /// fraction [1], 0..1, Linear and Multilinear: the part of the hardening that moves the yield
  /// surface
  double kinematic_fraction = 0.0;
  double saturation_stress = 0.0;  ///< Q [Pa], VoceChaboche; negative softens, above -sigma_y
  double saturation_rate = 0.0;    ///< b [1], >= 0, VoceChaboche
  std::array<double, 3> backstress_modulus{};  ///< C_i [Pa], >= 0, VoceChaboche (3)
  std::array<double, 3> backstress_rate{};     ///< gamma_i [1], >= 0, VoceChaboche (3)
  /// plastic strain of the table's points [1], rising, > 0; 0 beyond the last, Multilinear (10)
  std::array<double, kTablePoints> plastic_strain{};
  /// stress of the points [Pa], > 0, Multilinear (10); its slope is at least -E/10
  std::array<double, kTablePoints> flow_stress{};
};

/// How the flow stress depends on the rate of the plastic strain. What a law multiplies is the
/// radius of the yield surface, hardening included; back stresses are as they are.
enum class RateLaw {
  None,           ///< it does not
  CowperSymonds,  ///< times 1 + (rate/C)^(1/P)
  JohnsonCook,    ///< times 1 + c ln(rate/reference rate) above the reference rate
};

/// Parameters of the rate laws; those of another law than `law` are ignored.
///
/// The rate is that of the accumulated plastic strain: in a motion each joint (or fibre) has its
/// own. Where `strain_rate` is set, all has that one, as a test at this rate has while it flows; at
/// rest and in coupons, which know no time, it must be.
/// Sources: Cowper & Symonds, Strain hardening and strain-rate effects in the impact loading of
/// cantilever beams, Brown University, TR 28 (1957); Johnson & Cook, Proc. 7th Int. Symp. on
/// Ballistics (1983), 541, of which this is the second factor alone.
struct RateDependence {
  RateLaw law = RateLaw::None;
  std::optional<double> reference_rate{};  ///< C, or the reference rate [1/s], > 0; must be set
  std::optional<double> exponent{};        ///< P [1], >= 1; must be set, CowperSymonds
  std::optional<double> coefficient{};     ///< c [1], >= 0; must be set, JohnsonCook
  std::optional<double> strain_rate{};     ///< [1/s], > 0; empty: each point has its own
};

/// A material. The defaults are those of structural steel S355.
///
/// An empty optional is derived: see resolved_shear_modulus() and its kin.
struct Material {
  std::string name = "S355";
  double youngs_modulus = 210e9;               ///< E [Pa], > 0
  double poisson_ratio = 0.3;                  ///< nu [1], -1 < nu <= 0.5
  std::optional<double> shear_modulus{};       ///< G [Pa], > 0; empty: E/(2(1+nu)), isotropic
  double density = 7850.0;                     ///< rho [kg/m^3], > 0
  double yield_stress = 355e6;                 ///< sigma_y [Pa], > 0
  std::optional<double> shear_yield_stress{};  ///< tau_y [Pa], > 0; empty: sigma_y/sqrt(3), Mises
  std::optional<double> break_strain{};        ///< permanent strain [1], > 0; empty: never breaks
  std::optional<double> break_shear_strain{};  ///< permanent [1], > 0; empty: sqrt(3) break_strain
  Hardening hardening{};
  RateDependence rate{};
};

/// Whether each point of it has a rate of its own: a rate law, and no rate that all has.
bool has_own_rates(const Material& material);

/// G [Pa]: as given, or E/(2(1+nu)) of an isotropic material.
double resolved_shear_modulus(const Material& material);

/// What a material is called: empty if it has no name, or that of the default (which stays with a
/// scene that gives numbers alone) with another modulus or yield stress.
std::string shown_name(const Material& material);

/// tau_y [Pa]: as given, or sigma_y/sqrt(3) (von Mises).
double resolved_shear_yield_stress(const Material& material);

/// gamma_break [1]: as given, or sqrt(3) break_strain (equal von Mises strain); empty if neither is
/// given, and then nothing breaks in torsion.
std::optional<double> resolved_break_shear_strain(const Material& material);

/// H = d(stress)/d(plastic strain) [Pa] of linear hardening: E E_t/(E - E_t); 0 for E_t = 0.
/// @param youngs_modulus   E [Pa]
/// @param tangent_modulus  E_t [Pa], 0 <= E_t < E
double plastic_modulus(double youngs_modulus, double tangent_modulus);

/// Checks every field against the range in its doc, hardening included.
/// @throws InputError that names the field: "material.yield_stress = -1: must be positive …"
void check_material(const Material& material, const SourceLocation& where = {});

}  // namespace plastica
