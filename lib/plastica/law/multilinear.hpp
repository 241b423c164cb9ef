#pragma once

#include <array>
#include <cstddef>

#include "plastica/law/newton_return.hpp"
#include "plastica/law/uniaxial_material.hpp"

namespace plastica::law {

/// Straight lines through a table of stress over plastic strain, beyond whose last point the stress
/// stays. A fraction of each slope is kinematic (Prager), as in linear hardening; the slope is that
/// at the accumulated plastic strain.
template <class S>
struct Multilinear {
  using Scalar = S;
  static constexpr HardeningLaw kLaw = HardeningLaw::Multilinear;
  static constexpr bool kByNewton = true;
  static constexpr bool kHasKinks = true;
  static constexpr bool kRecovers = false;
  static constexpr std::size_t kBacks = 1;
  static constexpr std::size_t kLines = Hardening::kTablePoints;
  using State = LawState<S, kBacks>;

  S stiffness;             ///< [Pa], > 0
  S yield;                 ///< [Pa], > 0
  S isotropic, kinematic;  ///< of the slopes [1]: their fractions, and what a rate makes of one
  S steepest;              ///< by what the slopes fall at the most [Pa], >= 0
  std::array<S, kLines> begin;  ///< accumulated plastic strain at which a line begins [1]
  std::array<S, kLines> width;  ///< over which it goes [1]; 0: there is none
  std::array<S, kLines> slope;  ///< [Pa]

  static Multilinear of(const UniaxialMaterial<S>& m, const MaterialValues<S>& values) {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S& fraction = number_of(values, MaterialField::KinematicFraction);
    Multilinear law{m.stiffness, m.yield, m.raised * (one - fraction), fraction, {}, {}, {}, {}};
    law.steepest = zero;
    const S strains = one / m.rates;
    S strain = zero;
    S stress = number_of(values, MaterialField::YieldStress);
    for (std::size_t i = 0; i < kLines; ++i) {
      const S& next_strain = number_of(values, MaterialField::PlasticStrain1, i);
      const S& next_stress = number_of(values, MaterialField::FlowStress1, i);
      const auto is_there = next_strain > strain;
      const S width = select(is_there, next_strain - strain, one);
      law.begin[i] = strains * strain;
      law.width[i] = select(is_there, strains * width, zero);
      law.slope[i] = select(is_there, m.moduli * (next_stress - stress) / width, zero);
      law.steepest = max(law.steepest, -(law.isotropic + law.kinematic) * law.slope[i]);
      strain = select(is_there, next_strain, strain);
      stress = select(is_there, next_stress, stress);
    }
    return law;
  }
  Grown<S> radius(const S& accumulated, const S& p) const {
    const Grown<S> grown = growth(accumulated + p);
    return {yield + isotropic * grown.value, isotropic * grown.slope};
  }
  S radius_integral(const S& accumulated, const S& p) const {
    return yield * p + isotropic * (area(accumulated + p) - area(accumulated));
  }
  S drive(std::size_t /*k*/, const S& accumulated, const S& /*along*/) const {
    return kinematic * growth(accumulated).slope;
  }
  Grown<S> shift(std::size_t /*k*/, const S& accumulated, const S& /*drive*/, const S& p) const {
    const Grown<S> grown = growth(accumulated + p);
    return {kinematic * (grown.value - growth(accumulated).value), kinematic * grown.slope};
  }
  Grown<S> source(std::size_t k, const S& accumulated, const S& p,
                  const BackFlow<S>& /*flow*/) const {
    return shift(k, accumulated, S{}, p);
  }
  S source_integral(std::size_t /*k*/, const S& accumulated, const S& p,
                    const S& /*decayed*/) const {
    return kinematic * (area(accumulated + p) - area(accumulated) - growth(accumulated).value * p);
  }
  /// No slope falls by more than `steepest`.
  S latest(const S& over, const S& /*accumulated*/) const { return over / (stiffness - steepest); }

 private:
  /// Stress of the table beyond the yield stress; at a kink the slope of what comes.
  Grown<S> growth(const S& accumulated) const {
    const S zero = constant<S>(0);
    Grown<S> grown{zero, zero};
    for (std::size_t i = 0; i < kLines; ++i) {
      const S on = accumulated - begin[i];
      grown.value += slope[i] * min(max(on, zero), width[i]);
      grown.slope += select((on >= zero) & (on < width[i]), slope[i], zero);
    }
    return grown;
  }
  /// The integral of that from 0.
  S area(const S& accumulated) const {
    const S zero = constant<S>(0);
    S sum = zero;
    for (std::size_t i = 0; i < kLines; ++i) {
      const S on = max(accumulated - begin[i], zero);
      const S part = min(on, width[i]);
      sum += slope[i] * part * (on - constant<S>(0.5) * part);
    }
    return sum;
  }
};

}  // namespace plastica::law
