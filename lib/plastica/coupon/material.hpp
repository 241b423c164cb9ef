#pragma once

#include <cstddef>
#include <limits>
#include <type_traits>

#include "plastica/base/scalar.hpp"
#include "plastica/coupon/shape.hpp"
#include "plastica/law/break_criterion.hpp"
#include "plastica/law/uniaxial.hpp"

namespace plastica::coupon {

/// What a material says in terms of the coupon's strain and stress.
template <class S>
struct CouponMaterial : law::UniaxialMaterial<S> {
  S limit;  ///< permanent strain at which it breaks [1]; infinite without a limit
};

/// Translates material numbers; a template, so that derivatives by them go through.
///
/// Defaults of unset shear values: von Mises, sqrt(3); Wendelius' report takes them as equal.
template <class S>
inline CouponMaterial<S> coupon_material(const CouponShape& shape, const MaterialValues<S>& v) {
  const bool torsion = shape.deformation == Deformation::Torsion;
  CouponMaterial<S> m;
  static_cast<law::UniaxialMaterial<S>&>(m) =
      law::uniaxial_material(law::UniaxialForm{.shear = torsion,
                                               .shear_modulus_given = shape.shear_modulus_given,
                                               .shear_yield_given = shape.shear_yield_given,
                                               .formulas = shape.formulas,
                                               .stiffness_factor = shape.stiffness_factor,
                                               .cap_factor = shape.cap_factor,
                                               .rate = shape.rate,
                                               .strain_rate = shape.strain_rate},
                             v);
  m.limit = S(std::numeric_limits<real_t<S>>::infinity());
  if (torsion && shape.break_shear_given) {
    m.limit = number_of(v, MaterialField::BreakShearStrain);
  } else if (shape.break_given) {
    const S& limit = number_of(v, MaterialField::BreakStrain);
    const bool report = shape.formulas == Formulas::Report;
    m.limit = torsion ? limit * constant<S>(report ? 1.0 : 1.7320508075688772935) : limit;
  }
  return m;
}

/// Calls `use(law)` with the coupon's law as a type of its own, so that each is compiled by
/// itself and ideal plasticity pays for nothing else.
template <class S, class Use>
inline void with_law(HardeningLaw hardening, const CouponMaterial<S>& m,
                     const MaterialValues<S>& values, Use&& use) {
  law::with_law_type<S>(hardening,
                        [&]<class Law>(std::type_identity<Law>) { use(Law::of(m, values)); });
}

/// The permanent strain that is held against the limit [1], >= 0.
///
/// The accumulated measure is a sum of strains; Wendelius' sine is never taken of a sum.
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
/// [1]; infinite where Wendelius' sine never gets there.
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
