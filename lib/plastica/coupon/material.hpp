#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "plastica/base/scalar.hpp"
#include "plastica/coupon/shape.hpp"
#include "plastica/law/break_criterion.hpp"
#include "plastica/law/uniaxial.hpp"
#include "plastica/model/material_field.hpp"

namespace plastica::coupon {

/// What a material says in terms of the coupon's strain and stress.
template <class S>
struct CouponMaterial {
  S stiffness;         ///< K [Pa]
  S yield;             ///< Y [Pa]
  S limit;             ///< permanent strain at which it breaks [1]; infinite without a limit
  S plastic_modulus;   ///< of linear hardening, d stress / d plastic strain [Pa]
  S kinematic_share;   ///< [0, 1]
  S saturation, rate;  ///< Voce's Q [Pa] and b [1]
  std::array<S, law::kBackStresses> back_modulus, back_rate;  ///< Chaboche's C [Pa], gamma [1]
};

/// Translates material numbers; a template, so that derivatives by them go through.
///
/// Linear hardening with the tangent modulus E_t of the stress-strain curve has the plastic
/// modulus E E_t/(E - E_t). In torsion, with r = yield stress / shear yield stress, equal plastic
/// work gives tau = s/r and gamma_p = r e_p: stresses scale with 1/r, moduli with 1/r^2, rates
/// with 1/r. A cap factor scales all hardening stresses, as the lumped joint knows one stress.
/// Defaults of unset shear values: von Mises, sqrt(3); the report takes them as equal.
template <class S>
inline CouponMaterial<S> coupon_material(const CouponShape& shape, const MaterialValues<S>& v) {
  const auto value = [&](MaterialField field) -> const S& {
    return v[static_cast<std::size_t>(field)];
  };
  const bool torsion = shape.deformation == Deformation::Torsion;
  const bool report = shape.formulas == Formulas::Report;
  const S one = constant<S>(1);
  const S young = value(MaterialField::YoungsModulus);
  const S shear = shape.shear_modulus_given
                      ? value(MaterialField::ShearModulus)
                      : young / (constant<S>(2) * (one + value(MaterialField::PoissonRatio)));
  const S isotropic = constant<S>(report ? 1.0 : 1.7320508075688772935);
  const S yield = value(MaterialField::YieldStress);
  const S shear_yield =
      shape.shear_yield_given ? value(MaterialField::ShearYieldStress) : yield / isotropic;
  const S r = torsion ? yield / shear_yield : one;
  const S cap = constant<S>(shape.cap_factor);

  CouponMaterial<S> m;
  m.stiffness = constant<S>(shape.stiffness_factor) * (torsion ? shear : young);
  m.yield = cap * (torsion ? shear_yield : yield);
  m.limit = S(std::numeric_limits<real_t<S>>::infinity());
  if (torsion && shape.break_shear_given) {
    m.limit = value(MaterialField::BreakShearStrain);
  } else if (shape.break_given) {
    const S& limit = value(MaterialField::BreakStrain);
    m.limit = torsion ? limit * isotropic : limit;
  }
  const S modulus_scale = cap / (r * r);
  const S& tangent = value(MaterialField::TangentModulus);
  m.plastic_modulus = modulus_scale * young * tangent / (young - tangent);
  m.kinematic_share = value(MaterialField::KinematicShare);
  m.saturation = cap * value(MaterialField::SaturationStress) / r;
  m.rate = value(MaterialField::SaturationRate) / r;
  constexpr auto kModulus = static_cast<std::size_t>(MaterialField::BackModulus1);
  constexpr auto kRate = static_cast<std::size_t>(MaterialField::BackRate1);
  for (std::size_t k = 0; k < law::kBackStresses; ++k) {
    m.back_modulus[k] = modulus_scale * v[kModulus + k];
    m.back_rate[k] = v[kRate + k] / r;
  }
  return m;
}

/// Calls `use(law)` with the coupon's law as a type of its own, so that each is compiled by
/// itself and ideal plasticity pays for nothing else.
template <class S, class Use>
inline void with_law(HardeningLaw hardening, const CouponMaterial<S>& m, Use&& use) {
  switch (hardening) {
    case HardeningLaw::Ideal:
      use(law::IdealPlastic<S>{m.stiffness, constant<S>(1) / m.stiffness, m.yield});
      return;
    case HardeningLaw::Linear:
      use(law::LinearHardening<S>{m.stiffness, m.yield,
                                  (constant<S>(1) - m.kinematic_share) * m.plastic_modulus,
                                  m.kinematic_share * m.plastic_modulus});
      return;
    case HardeningLaw::VoceChaboche:
      use(law::VoceChaboche<S>{m.stiffness, m.yield, m.saturation, m.rate, m.back_modulus,
                               m.back_rate});
      return;
  }
}

/// The permanent strain that is held against the limit [1], >= 0.
///
/// The accumulated measure is a sum of strains; the report's sine is never taken of a sum.
template <class State>
inline auto break_measure(const CouponShape& shape, const State& state) {
  using S = std::remove_cvref_t<decltype(state.plastic)>;
  const bool net = shape.break_measure == BreakMeasure::Net;
  const S strain = net ? abs(state.plastic) : state.accumulated;
  if (shape.formulas == Formulas::Mechanics || shape.deformation == Deformation::Tension) {
    return strain;
  }
  const S length = constant<S>(shape.length);
  const S angle = strain * length / constant<S>(shape.lever);
  const S lever = constant<S>(shape.report_lever);
  if (shape.deformation == Deformation::Torsion) {
    return law::report_torsion_strain(angle, constant<S>(2) * lever, length);
  }
  return net ? law::report_bending_strain(angle, lever, length)
             : law::permanent_bending_strain(angle, lever, length);
}

/// The law's own permanent strain (net or accumulated) at which `break_measure` reaches `limit`
/// [1]; infinite where the report's sine never gets there.
inline double plastic_limit(const CouponShape& shape, double limit) {
  if (shape.formulas == Formulas::Mechanics || shape.deformation == Deformation::Tension) {
    return limit;
  }
  if (shape.deformation == Deformation::Torsion) return limit * shape.lever / shape.report_lever;
  if (shape.break_measure == BreakMeasure::Accumulated) {
    return limit * 2.0 * shape.lever / shape.report_lever;
  }
  const double sine = limit * shape.length / shape.report_lever;
  if (sine >= 1.0) return std::numeric_limits<double>::infinity();
  // The arc sine by halving: the C library's has different bits on different machines.
  double low = 0.0;
  double high = 1.5707963267948966192;
  for (int i = 0; i < 56; ++i) {
    const double middle = 0.5 * (low + high);
    (sin(middle) < sine ? low : high) = middle;
  }
  return 2.0 * high * shape.lever / shape.length;
}

}  // namespace plastica::coupon
