#pragma once

#include <limits>

#include "plastica/base/scalar.hpp"
#include "plastica/law/uniaxial_law.hpp"
#include "plastica/model/material_field.hpp"

namespace plastica::law {

/// By how much a plastic strain rate raises the radius of the yield surface: see `RateDependence`.
///
/// Of an increment the rate is its mean, p over the time that it takes, so that stresses are of
/// first order in the increment where the rate changes, and exact where it does not.
template <class S>
struct RateFactor {
  RateLaw law = RateLaw::None;
  S reference;         ///< in terms of p [1/s], > 0
  S power;             ///< 1/P [1]
  S coefficient;       ///< c [1]
  S per_second = S{};  ///< one over the time of the increment [1/s]; 0: it takes for ever

  /// @param strains  by what equivalent plastic strains are to be multiplied: see UniaxialMaterial
  static RateFactor of(RateLaw law, const MaterialValues<S>& values, const S& strains) {
    const S one = constant<S>(1);
    RateFactor factor{law, strains * number_of(values, MaterialField::ReferenceRate), one,
                      number_of(values, MaterialField::RateCoefficient)};
    if (law == RateLaw::CowperSymonds) {
      factor.power = one / number_of(values, MaterialField::RateExponent);
    }
    return factor;
  }

  /// At a rate [1/s], > 0.
  S at_rate(const S& rate) const {
    using plastica::exp;
    using plastica::log;
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    switch (law) {
      case RateLaw::None: break;
      case RateLaw::CowperSymonds: return one + exp(power * log(rate / reference));
      case RateLaw::JohnsonCook: return one + coefficient * max(log(rate / reference), zero);
    }
    return one;
  }

  /// After an increment p, and its slope by p. At p = 0, where Cowper and Symonds have no slope, it
  /// is 0.
  Grown<S> after(const S& p) const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    // In no time nothing flows, whatever the stress.
    const S endless = constant<S>(std::numeric_limits<real_t<S>>::infinity());
    if (!any(per_second < endless)) return {endless, zero};
    const S rate = p * per_second;
    if (!any(rate > zero)) return {one, zero};
    const S value = at_rate(rate);
    switch (law) {
      case RateLaw::None: break;
      case RateLaw::CowperSymonds: return {value, power * (value - one) / p};
      case RateLaw::JohnsonCook: return {value, select(rate > reference, coefficient / p, zero)};
    }
    return {one, zero};
  }

  /// The increment at which the factor would be 1 + excess, or `most`: the flow of an overstress is
  /// at the most this where nothing softens.
  S reached(const S& excess, const S& most) const {
    using plastica::exp;
    using plastica::log;
    if (!any(per_second > constant<S>(0)) || !any(excess > constant<S>(0))) return most;
    const S seconds = constant<S>(1) / per_second;
    switch (law) {
      case RateLaw::None: break;
      case RateLaw::CowperSymonds:
        return min(most, reference * seconds * exp(min(log(excess) / power, largest())));
      case RateLaw::JohnsonCook:
        if (!any(coefficient > constant<S>(0))) break;
        return min(most, reference * seconds * exp(min(excess / coefficient, largest())));
    }
    return most;
  }

  /// A step of Newton's method in the variable in which the factor is a straight line: p^(1/P), or
  /// ln p. In it the residual of a return is concave, so that steps from above come to the root
  /// without passing it; in p itself its slope has no bound.
  S stepped(const S& p, const S& step) const {
    using plastica::exp;
    using plastica::log;
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S newton = p + step;
    if (!any(p > zero) || !any(per_second > zero)) return newton;
    const S fraction = step / p;
    switch (law) {
      case RateLaw::None: break;
      case RateLaw::CowperSymonds: {
        const S grown = one + power * fraction;
        if (!any(grown > zero)) return newton;
        return p * exp(log(grown) / power);
      }
      case RateLaw::JohnsonCook: {
        if (!any(p * per_second > reference)) return newton;
        return p * exp(min(max(fraction, -largest()), largest()));
      }
    }
    return newton;
  }

 private:
  static S largest() { return constant<S>(300); }
};

}  // namespace plastica::law
