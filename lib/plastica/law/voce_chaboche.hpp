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
/// and falls with p, so Newton's method from p = 0 never overshoots. All that changes with p decays
/// at rates of its own, so that f'' comes with f' and the return takes Halley's steps.
template <class S>
struct VoceChaboche {
  using Scalar = S;
  static constexpr HardeningLaw kLaw = HardeningLaw::VoceChaboche;
  static constexpr bool kByNewton = true;
  static constexpr bool kHasKinks = false;
  static constexpr bool kRecovers = true;
  static constexpr bool kDecays = true;
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
  /// The same without derivatives.
  auto values() const requires kCarriesDerivatives<S> {
    const auto of = [](const std::array<S, kBacks>& x) {
      return std::array{value_of(x[0]), value_of(x[1]), value_of(x[2])};
    };
    return VoceChaboche<decltype(value_of(stiffness))>{value_of(stiffness),  value_of(yield),
                                                       value_of(saturation), value_of(rate),
                                                       of(back_modulus),     of(back_rate)};
  }
  Grown<S> radius(const S& accumulated, const S& p) const {
    using plastica::exp;
    return radius_left(saturation * exp(-rate * (accumulated + p)));
  }
  /// How much Q is still to come [Pa].
  S left(const S& accumulated) const {
    using plastica::exp;
    return saturation * exp(-rate * accumulated);
  }
  /// @param left  what it is after the flow
  Grown<S> radius_left(const S& left) const { return {yield + saturation - left, rate * left}; }
  S radius_integral(const S& accumulated, const S& p) const {
    using plastica::exp;
    return (yield + saturation) * p - left(accumulated) * detail::decay(rate, p, exp(-rate * p));
  }
  S drive(std::size_t k, const S& /*accumulated*/, const S& along) const {
    return back_modulus[k] - back_rate[k] * along;
  }
  Grown<S> shift(std::size_t k, const S& /*accumulated*/, const S& drive, const S& p) const {
    const S power = decayed_to(back_rate[k], p);
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
    return latest_left(over, left(accumulated));
  }
  S latest_left(const S& over, const S& left) const {
    return (over + max(constant<S>(0), -left)) / stiffness;
  }
  /// exp(-rate p). Laws with fewer back stresses than there is room for have rates of 0.
  static S decayed_to(const S& rate, const S& p) {
    using plastica::exp;
    if constexpr (!kCarriesDerivatives<S>) {
      if (!any(rate > constant<S>(0))) return constant<S>(1);
    }
    return exp(-rate * p);
  }
};

}  // namespace plastica::law
