#pragma once

#include <cstddef>

#include "plastica/law/uniaxial_law.hpp"
#include "plastica/law/uniaxial_material.hpp"

namespace plastica::law {

/// Linear hardening: part isotropic (the yield stress grows), part kinematic (Prager: the elastic
/// range moves). Both moduli are d stress / d plastic strain.
template <class S>
struct LinearHardening {
  using Scalar = S;
  static constexpr HardeningLaw kLaw = HardeningLaw::Linear;
  static constexpr bool kByNewton = false;
  static constexpr bool kRecovers = false;
  static constexpr std::size_t kBacks = 1;
  using State = LawState<S, kBacks>;

  S stiffness;  ///< [Pa], > 0
  S yield;      ///< initial yield stress [Pa], > 0
  S isotropic;  ///< [Pa], >= 0
  S kinematic;  ///< [Pa], >= 0

  /// With the tangent modulus E_t of the stress-strain curve, the plastic modulus is
  /// E E_t/(E - E_t).
  static LinearHardening of(const UniaxialMaterial<S>& m, const MaterialValues<S>& values) {
    const S& young = number_of(values, MaterialField::YoungsModulus);
    const S& tangent = number_of(values, MaterialField::TangentModulus);
    const S& fraction = number_of(values, MaterialField::KinematicFraction);
    const S modulus = m.moduli * young * tangent / (young - tangent);
    return {m.stiffness, m.yield, m.raised * (constant<S>(1) - fraction) * modulus,
            fraction * modulus};
  }
  Grown<S> radius(const S& accumulated, const S& p) const {
    return {yield + isotropic * (accumulated + p), isotropic};
  }
  S radius_integral(const S& accumulated, const S& p) const {
    return (yield + isotropic * (accumulated + constant<S>(0.5) * p)) * p;
  }
  S drive(std::size_t /*k*/, const S& /*accumulated*/, const S& /*along*/) const {
    return kinematic;
  }
  Grown<S> shift(std::size_t /*k*/, const S& /*accumulated*/, const S& drive, const S& p) const {
    return {drive * p, drive};
  }
  Grown<S> source(std::size_t /*k*/, const S& /*accumulated*/, const S& p,
                  const BackFlow<S>& /*flow*/) const {
    return {kinematic * p, kinematic};
  }
  S source_integral(std::size_t /*k*/, const S& /*accumulated*/, const S& p,
                    const S& /*decayed*/) const {
    return constant<S>(0.5) * kinematic * p * p;
  }
};

/// With the trial overstress f: p = f / (K + H_iso + H_kin) (Simo and Hughes 1998, box 1.5).
template <class S>
inline UniaxialResponse<S, typename LinearHardening<S>::State> respond(
    const LinearHardening<S>& law, const typename LinearHardening<S>::State& before,
    const S& strain) {
  const S trial = law.stiffness * (strain - before.plastic);
  const S relative = trial - before.back_stress[0];
  const auto backward = relative < constant<S>(0);
  const S over = abs(relative) - (law.yield + law.isotropic * before.accumulated);
  const auto yields = over > constant<S>(0);
  const S hardening = law.isotropic + law.kinematic;
  // Without the sample: a loop over samples divides once.
  const S softness = constant<S>(1) / (law.stiffness + hardening);
  const S dp = max(over * softness, constant<S>(0));
  // Chosen, not multiplied by -1 or 1: a product costs a dual number twelve operations.
  const S along = select(backward, -dp, dp);
  UniaxialResponse<S, typename LinearHardening<S>::State> now;
  now.state.plastic = before.plastic + along;
  now.state.accumulated = before.accumulated + dp;
  now.state.back_stress[0] = before.back_stress[0] + law.kinematic * along;
  now.stress = law.stiffness * (strain - now.state.plastic);
  now.tangent = select(yields, law.stiffness * hardening * softness, law.stiffness);
  return now;
}

}  // namespace plastica::law
