#pragma once

#include "plastica/base/scalar.hpp"
#include "plastica/law/rate_factor.hpp"
#include "plastica/model/material_field.hpp"
#include "plastica/model/rules.hpp"

namespace plastica::law {

/// Everything about the law of an extreme fibre that does not depend on the material's numbers.
struct UniaxialForm {
  bool shear = false;  ///< torsion: shear modulus and shear yield stress
  bool shear_modulus_given = false;
  bool shear_yield_given = false;
  Formulas formulas = Formulas::Mechanics;
  double stiffness_factor = 1.0;  ///< on E or G [1]
  double cap_factor = 1.0;        ///< on all stresses [1]: 1 at first yield
  RateLaw rate = RateLaw::None;
  double strain_rate = 0.0;  ///< of all [1/s]; 0: each point has its own
};

/// What a material says in terms of the strain and stress of an extreme fibre.
template <class S>
struct UniaxialMaterial {
  S stiffness;  ///< K [Pa]
  S yield;      ///< Y [Pa]
  /// By what its numbers of hardening are to be multiplied: stresses, d stress/d plastic strain,
  /// and what is per plastic strain [1].
  S stresses, moduli, rates;
  /// By what growth of the yield stress is to be multiplied besides, for the rate that all has [1].
  S raised;
  RateLaw rate = RateLaw::None;  ///< where each point has a rate of its own
};

/// Shear yield stress [Pa]: as given, or von Mises, sqrt(3) below; Wendelius' report takes them as
/// equal.
template <class S>
inline S shear_yield_stress(const UniaxialForm& form, const MaterialValues<S>& v) {
  if (form.shear_yield_given) return number_of(v, MaterialField::ShearYieldStress);
  const S isotropic = constant<S>(form.formulas == Formulas::Report ? 1.0 : 1.7320508075688772935);
  return number_of(v, MaterialField::YieldStress) / isotropic;
}

/// Translates material numbers; a template, so that derivatives by them go through.
///
/// In torsion, with r = yield stress / shear yield stress, equal plastic work gives tau = s/r and
/// gamma_p = r e_p: stresses scale with 1/r, moduli with 1/r^2, rates with 1/r. A cap factor scales
/// all hardening stresses, as the lumped joint knows one stress. A rate that all has is the
/// equivalent one, in torsion, too: it raises the yield stress and its growth, not back stresses.
template <class S>
inline UniaxialMaterial<S> uniaxial_material(const UniaxialForm& form, const MaterialValues<S>& v) {
  const S one = constant<S>(1);
  const S& young = number_of(v, MaterialField::YoungsModulus);
  const S& yield = number_of(v, MaterialField::YieldStress);
  const S shear =
      form.shear_modulus_given
          ? number_of(v, MaterialField::ShearModulus)
          : young / (constant<S>(2) * (one + number_of(v, MaterialField::PoissonRatio)));
  const S shear_yield = shear_yield_stress(form, v);
  const S r = form.shear ? yield / shear_yield : one;
  const S cap = constant<S>(form.cap_factor);
  const S raised = form.strain_rate > 0.0
                       ? RateFactor<S>::of(form.rate, v, one).at_rate(constant<S>(form.strain_rate))
                       : one;
  return {constant<S>(form.stiffness_factor) * (form.shear ? shear : young),
          raised * cap * (form.shear ? shear_yield : yield),
          cap / r,
          cap / (r * r),
          one / r,
          raised,
          form.strain_rate > 0.0 ? RateLaw::None : form.rate};
}

/// The same with all stresses over the yield stress, whatever the kind of stress.
/// @param form  of the section: its rate counts
template <class S>
inline UniaxialMaterial<S> over_yield_stress(const UniaxialForm& form, const MaterialValues<S>& v) {
  UniaxialMaterial<S> m =
      uniaxial_material(UniaxialForm{.rate = form.rate, .strain_rate = form.strain_rate}, v);
  const S inverse = constant<S>(1) / m.yield;
  m.stiffness = m.stiffness * inverse;
  m.yield = constant<S>(1);
  m.stresses = m.moduli = inverse;
  return m;
}

}  // namespace plastica::law
