#pragma once

#include <cstddef>

#include "plastica/law/uniaxial_law.hpp"
#include "plastica/law/uniaxial_material.hpp"

namespace plastica::law {

/// Ideal plasticity, Wendelius' law: the stress never leaves [-yield, yield].
template <class S>
struct IdealPlastic {
  using Scalar = S;
  static constexpr HardeningLaw kLaw = HardeningLaw::Ideal;
  static constexpr bool kByNewton = false;
  static constexpr bool kRecovers = false;
  static constexpr std::size_t kBacks = 0;
  using State = LawState<S, kBacks>;

  S stiffness;   ///< K: E, or G in torsion [Pa], > 0
  S compliance;  ///< 1/K, kept so that the kernel does not divide
  S yield;       ///< [Pa], > 0

  static IdealPlastic of(const UniaxialMaterial<S>& m, const MaterialValues<S>& /*values*/) {
    return {m.stiffness, constant<S>(1) / m.stiffness, m.yield};
  }
  Grown<S> radius(const S& /*accumulated*/, const S& /*p*/) const {
    return {yield, constant<S>(0)};
  }
  S radius_integral(const S& /*accumulated*/, const S& p) const { return yield * p; }
};

/// Closest-point return: the trial stress K (e - e_p), clipped; what is cut off is permanent.
///
/// The permanent strain is written as a play: it stays while the strain is within yield/K of it
/// and is dragged along beyond. So only a max and a min wait for the sample before.
template <class S>
inline UniaxialResponse<S, typename IdealPlastic<S>::State> respond(
    const IdealPlastic<S>& law, const typename IdealPlastic<S>::State& before, const S& strain) {
  const S reach = law.yield * law.compliance;
  const S trial = law.stiffness * (strain - before.plastic);
  // Member by member: gathered at the end, dual numbers would go through memory (four times
  // slower).
  UniaxialResponse<S, typename IdealPlastic<S>::State> now;
  now.stress = min(max(trial, -law.yield), law.yield);
  now.tangent = select(abs(trial) > law.yield, constant<S>(0), law.stiffness);
  now.state.plastic = min(max(before.plastic, strain - reach), strain + reach);
  now.state.accumulated = before.accumulated + abs(now.state.plastic - before.plastic);
  return now;
}

}  // namespace plastica::law
