#pragma once

#include <array>
#include <cstddef>

#include "plastica/law/newton_return.hpp"
#include "plastica/law/uniaxial_material.hpp"

namespace plastica::law {

/// Voce isotropic hardening with Chaboche back stresses.
///
/// Radius: yield + Q (1 - exp(-b p)), p the accumulated plastic strain (Voce 1948).
/// Back stress: the sum of dX_k = C_k d e_p - gamma_k X_k dp (Armstrong and Frederick 1966;
/// Chaboche 1986). gamma_k = 0 makes a part linear (Prager). For Q >= 0 the return's f is convex
/// and falls with p, so Newton's method from p = 0 never overshoots.
template <class S>
struct VoceChaboche {
  using Scalar = S;
  static constexpr HardeningLaw kLaw = HardeningLaw::VoceChaboche;
  static constexpr bool kByNewton = true;
  static constexpr bool kHasKinks = false;
  static constexpr bool kRecovers = true;
  static constexpr std::size_t kBacks = 3;
  using State = LawState<S, kBacks>;

  S stiffness;   ///< [Pa], > 0
  S yield;       ///< [Pa], > 0
  S saturation;  ///< Q [Pa]; may be negative (cyclic softening), yield + Q > 0
  S rate;        ///< b [1], >= 0
  std::array<S, kBacks> back_modulus;  ///< C_k [Pa], >= 0
  std::array<S, kBacks> back_rate;     ///< gamma_k [1], >= 0

  static VoceChaboche of(const UniaxialMaterial<S>& m, const MaterialValues<S>& values) {
    VoceChaboche law{m.stiffness,
                     m.yield,
                     m.raised * m.stresses * number_of(values, MaterialField::SaturationStress),
                     m.rates * number_of(values, MaterialField::SaturationRate),
                     {},
                     {}};
    for (std::size_t k = 0; k < kBacks; ++k) {
      law.back_modulus[k] = m.moduli * number_of(values, MaterialField::BackModulus1, k);
      law.back_rate[k] = m.rates * number_of(values, MaterialField::BackRate1, k);
    }
    return law;
  }
  Grown<S> radius(const S& accumulated, const S& p) const {
    using plastica::exp;
    const S left = saturation * exp(-rate * (accumulated + p));
    return {yield + saturation - left, rate * left};
  }
  S radius_integral(const S& accumulated, const S& p) const {
    using plastica::exp;
    const S softened = saturation * exp(-rate * accumulated);
    return (yield + saturation) * p - softened * detail::decay(rate, p, exp(-rate * p));
  }
  S drive(std::size_t k, const S& /*accumulated*/, const S& along) const {
    return back_modulus[k] - back_rate[k] * along;
  }
  Grown<S> shift(std::size_t k, const S& /*accumulated*/, const S& drive, const S& p) const {
    using plastica::exp;
    const S power = exp(-back_rate[k] * p);
    return {drive * detail::decay(back_rate[k], p, power), drive * power};
  }
  const S& recovery(std::size_t k) const { return back_rate[k]; }
  Grown<S> source(std::size_t k, const S& /*accumulated*/, const S& /*p*/,
                  const BackFlow<S>& flow) const {
    return {back_modulus[k] * flow.decayed, back_modulus[k] * flow.power};
  }
  S source_integral(std::size_t k, const S& /*accumulated*/, const S& p, const S& decayed) const {
    return back_modulus[k] * detail::decay_integral(back_rate[k], p, decayed);
  }
  /// The radius shrinks by no more than what is left of a negative Q.
  S latest(const S& over, const S& accumulated) const {
    using plastica::exp;
    const S shrinks = max(constant<S>(0), -saturation * exp(-rate * accumulated));
    return (over + shrinks) / stiffness;
  }
};

}  // namespace plastica::law
