#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "plastica/base/scalar.hpp"
#include "plastica/law/uniaxial.hpp"
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
};

/// What a material says in terms of the strain and stress of an extreme fibre.
template <class S>
struct UniaxialMaterial {
  S stiffness;         ///< K [Pa]
  S yield;             ///< Y [Pa]
  S plastic_modulus;   ///< of linear hardening, d stress / d plastic strain [Pa]
  S kinematic_share;   ///< [0, 1]
  S saturation, rate;  ///< Voce's Q [Pa] and b [1]
  std::array<S, kBackStresses> back_modulus, back_rate;  ///< Chaboche's C [Pa], gamma [1]
};

/// Shear yield stress [Pa]: as given, or von Mises, sqrt(3) below; the report takes them as equal.
template <class S>
inline S shear_yield_stress(const UniaxialForm& form, const MaterialValues<S>& v) {
  if (form.shear_yield_given) return v[static_cast<std::size_t>(MaterialField::ShearYieldStress)];
  const S isotropic = constant<S>(form.formulas == Formulas::Report ? 1.0 : 1.7320508075688772935);
  return v[static_cast<std::size_t>(MaterialField::YieldStress)] / isotropic;
}

/// Translates material numbers; a template, so that derivatives by them go through.
///
/// Linear hardening with the tangent modulus E_t of the stress-strain curve has the plastic
/// modulus E E_t/(E - E_t). In torsion, with r = yield stress / shear yield stress, equal plastic
/// work gives tau = s/r and gamma_p = r e_p: stresses scale with 1/r, moduli with 1/r^2, rates
/// with 1/r. A cap factor scales all hardening stresses, as the lumped joint knows one stress.
template <class S>
inline UniaxialMaterial<S> uniaxial_material(const UniaxialForm& form, const MaterialValues<S>& v) {
  const auto value = [&](MaterialField field) -> const S& {
    return v[static_cast<std::size_t>(field)];
  };
  const S one = constant<S>(1);
  const S young = value(MaterialField::YoungsModulus);
  const S shear = form.shear_modulus_given
                      ? value(MaterialField::ShearModulus)
                      : young / (constant<S>(2) * (one + value(MaterialField::PoissonRatio)));
  const S yield = value(MaterialField::YieldStress);
  const S shear_yield = shear_yield_stress(form, v);
  const S r = form.shear ? yield / shear_yield : one;
  const S cap = constant<S>(form.cap_factor);

  UniaxialMaterial<S> m;
  m.stiffness = constant<S>(form.stiffness_factor) * (form.shear ? shear : young);
  m.yield = cap * (form.shear ? shear_yield : yield);
  const S modulus_scale = cap / (r * r);
  const S& tangent = value(MaterialField::TangentModulus);
  m.plastic_modulus = modulus_scale * young * tangent / (young - tangent);
  m.kinematic_share = value(MaterialField::KinematicShare);
  m.saturation = cap * value(MaterialField::SaturationStress) / r;
  m.rate = value(MaterialField::SaturationRate) / r;
  constexpr auto kModulus = static_cast<std::size_t>(MaterialField::BackModulus1);
  constexpr auto kRate = static_cast<std::size_t>(MaterialField::BackRate1);
  for (std::size_t k = 0; k < kBackStresses; ++k) {
    m.back_modulus[k] = modulus_scale * v[kModulus + k];
    m.back_rate[k] = v[kRate + k] / r;
  }
  return m;
}

/// The law of a given type with these numbers.
/// @tparam Law  IdealPlastic<S>, LinearHardening<S> or VoceChaboche<S>
template <class Law, class S>
inline Law uniaxial_law(const UniaxialMaterial<S>& m) {
  if constexpr (std::is_same_v<Law, IdealPlastic<S>>) {
    return {m.stiffness, constant<S>(1) / m.stiffness, m.yield};
  } else if constexpr (std::is_same_v<Law, LinearHardening<S>>) {
    return {m.stiffness, m.yield, (constant<S>(1) - m.kinematic_share) * m.plastic_modulus,
            m.kinematic_share * m.plastic_modulus};
  } else {
    static_assert(std::is_same_v<Law, VoceChaboche<S>>);
    return {m.stiffness, m.yield, m.saturation, m.rate, m.back_modulus, m.back_rate};
  }
}

/// Calls `use(tag)` with `std::type_identity` of the law's type, so that each is compiled by
/// itself and ideal plasticity pays for nothing else.
template <class S, class Use>
inline void with_law_type(HardeningLaw hardening, Use&& use) {
  switch (hardening) {
    case HardeningLaw::Ideal: use(std::type_identity<IdealPlastic<S>>{}); return;
    case HardeningLaw::Linear: use(std::type_identity<LinearHardening<S>>{}); return;
    case HardeningLaw::VoceChaboche: use(std::type_identity<VoceChaboche<S>>{}); return;
  }
}

}  // namespace plastica::law
