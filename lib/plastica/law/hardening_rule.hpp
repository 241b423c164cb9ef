#pragma once

#include <array>
#include <cstddef>

#include "plastica/law/uniaxial.hpp"
#include "plastica/law/uniaxial_material.hpp"

/// The uniaxial hardening laws in terms of a section's yield surface.
///
/// All stresses are over the yield stress, p is the equivalent plastic strain of the increment:
///   level:  radius of the surface, and its integral over p;
///   shift:  what the increment adds to back stress k along the flow, and its integral over p.
/// `along` is the back stress before the increment, measured along the flow.
namespace plastica::law {

/// A function of p with its derivatives by p and by `along`, and its integral from 0 to p.
template <class S>
struct HardeningTerm {
  S value, slope, by_along, integral;
};

/// @tparam Uniaxial  the law whose numbers it has: IdealPlastic has neither level nor shift
template <class S, class Uniaxial>
struct HardeningRule;

template <class S>
struct HardeningRule<S, IdealPlastic<S>> {
  static constexpr std::size_t kBacks = 0;

  explicit HardeningRule(const UniaxialMaterial<S>& /*m*/) {}
  S level(const S& /*accumulated*/) const { return constant<S>(1); }
};

template <class S>
struct HardeningRule<S, LinearHardening<S>> {
  static constexpr std::size_t kBacks = 1;
  S isotropic, kinematic;

  explicit HardeningRule(const UniaxialMaterial<S>& m)
      : isotropic((constant<S>(1) - m.kinematic_share) * m.plastic_modulus / m.yield),
        kinematic(m.kinematic_share * m.plastic_modulus / m.yield) {}

  S level(const S& accumulated) const { return constant<S>(1) + isotropic * accumulated; }
  HardeningTerm<S> level(const S& accumulated, const S& p) const {
    const S begins = level(accumulated);
    return {begins + isotropic * p, isotropic, constant<S>(0),
            (begins + constant<S>(0.5) * isotropic * p) * p};
  }
  HardeningTerm<S> shift(std::size_t /*k*/, const S& /*along*/, const S& p) const {
    return {kinematic * p, kinematic, constant<S>(0), constant<S>(0.5) * kinematic * p * p};
  }
};

/// The dynamic recovery of a back stress is taken along the flow only (radial evanescence, Burlet
/// and Cailletaud, Eng. Comput. 3, 1986, 143): shift = (C - gamma along)(1 - exp(-gamma p))/gamma.
/// For a single component it is Armstrong and Frederick's.
template <class S>
struct HardeningRule<S, VoceChaboche<S>> {
  static constexpr std::size_t kBacks = kBackStresses;
  S saturation, rate;
  std::array<S, kBacks> back_modulus, back_rate;

  explicit HardeningRule(const UniaxialMaterial<S>& m)
      : saturation(m.saturation / m.yield), rate(m.rate), back_rate(m.back_rate) {
    for (std::size_t k = 0; k < kBacks; ++k) back_modulus[k] = m.back_modulus[k] / m.yield;
  }

  S level(const S& accumulated) const {
    using plastica::exp;
    return constant<S>(1) + saturation * (constant<S>(1) - exp(-rate * accumulated));
  }
  HardeningTerm<S> level(const S& accumulated, const S& p) const {
    using plastica::exp;
    const S softened = saturation * exp(-rate * accumulated);
    const S power = exp(-rate * p);
    const S top = constant<S>(1) + saturation;
    return {top - softened * power, softened * rate * power, constant<S>(0),
            top * p - softened * detail::decay(rate, p, power)};
  }
  HardeningTerm<S> shift(std::size_t k, const S& along, const S& p) const {
    using plastica::exp;
    const S drive = back_modulus[k] - back_rate[k] * along;
    const S power = exp(-back_rate[k] * p);
    const S decayed = detail::decay(back_rate[k], p, power);
    // (p - decayed)/rate; where that would cancel, its series.
    const S y = back_rate[k] * p;
    const auto nearly_line = y < constant<S>(sizeof(real_t<S>) == 8 ? 1e-4 : 1e-2);
    const S divisor = select(nearly_line, constant<S>(1), back_rate[k]);
    const S series = constant<S>(0.5) * p * p * (constant<S>(1) - constant<S>(1.0 / 3.0) * y);
    const S integral = select(nearly_line, series, (p - decayed) / divisor);
    return {drive * decayed, drive * power, -back_rate[k] * decayed, drive * integral};
  }
};

}  // namespace plastica::law
