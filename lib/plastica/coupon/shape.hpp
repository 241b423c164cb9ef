#pragma once

#include "plastica/model/scene.hpp"

namespace plastica::coupon {

/// Everything about a coupon that does not depend on the material's numbers.
///
/// In tension, pure bending and pure torsion a joint is a uniaxial law between the strain and the
/// stress of the extreme fibre (see `Deformation`), with
///   stiffness  K = stiffness_factor * (E, or G in torsion),
///   yield      Y = cap_factor * (yield stress, or shear yield stress in torsion).
/// Both factors are those of the section's component: see `law::section_form`.
struct CouponShape {
  Deformation deformation = Deformation::Tension;
  HardeningLaw hardening = HardeningLaw::Ideal;
  Formulas formulas = Formulas::Mechanics;
  BreakMeasure break_measure = BreakMeasure::Net;
  double stiffness_factor = 1.0;
  double cap_factor = 1.0;
  double load_per_stress = 1.0;  ///< A [m^2], W_x or W_t [m^3]
  double lever = 1.0;            ///< strain per permanent angle per length: h/2, J/W_t [m]
  double report_lever = 1.0;     ///< of Wendelius' break strain: h in (24), c/2 in (8) [m]
  double length = 1.0;           ///< tributary length of an inner joint [m]
  RateLaw rate = RateLaw::None;
  double strain_rate = 0.0;  ///< of all [1/s]
  bool shear_modulus_given = false;
  bool shear_yield_given = false;
  bool break_given = false;
  bool break_shear_given = false;

  /// Whether the coupon has a break limit at all.
  bool breaks() const {
    return break_given || (break_shear_given && deformation == Deformation::Torsion);
  }
};

/// Derives the shape of a scene's coupon; the scene has passed `check_scene`.
CouponShape coupon_shape(const Scene& scene);

}  // namespace plastica::coupon
