#pragma once

#include <cstddef>

#include "plastica/law/uniaxial.hpp"

/// Plastic work per volume [J/m^3] of one increment, the integral of stress d plastic strain.
///
/// Exact for each law: the flow of an increment runs one way, so the stress is known as a function
/// of the plastic strain. (A trapezoid over the sample would count the elastic part of it.)
namespace plastica::law {

/// The stress stays at yield while it flows.
template <class S>
inline S plastic_work(const IdealPlastic<S>& /*law*/, const typename IdealPlastic<S>::State& before,
                      const UniaxialResponse<S, typename IdealPlastic<S>::State>& now) {
  return now.stress * (now.state.plastic - before.plastic);
}

/// The stress is a straight line over the plastic strain, of slope H_iso + H_kin.
template <class S>
inline S plastic_work(const LinearHardening<S>& law,
                      const typename LinearHardening<S>::State& before,
                      const UniaxialResponse<S, typename LinearHardening<S>::State>& now) {
  const S flow = now.state.plastic - before.plastic;
  const S begins = now.stress - (law.isotropic + law.kinematic) * flow;
  return constant<S>(0.5) * (begins + now.stress) * flow;
}

/// The integral of yield + Q - Q exp(-b (p + s)) + d sum X_k(s) over s from 0 to dp. With
/// d X_k' = C_k - gamma_k d X_k, X_k's part is (C_k dp - d (X_k(dp) - X_k(0)))/gamma_k; where that
/// would cancel (gamma_k dp small), a trapezoid and its first correction.
template <class S>
inline S plastic_work(const VoceChaboche<S>& law, const typename VoceChaboche<S>::State& before,
                      const UniaxialResponse<S, typename VoceChaboche<S>::State>& now) {
  using plastica::exp;
  const S one = constant<S>(1);
  const S dp = now.state.accumulated - before.accumulated;
  const S direction = sign(now.state.plastic - before.plastic);
  const S softened = law.saturation * exp(-law.rate * before.accumulated);
  S work = (law.yield + law.saturation) * dp -
           softened * detail::decay(law.rate, dp, exp(-law.rate * dp));
  for (std::size_t k = 0; k < kBackStresses; ++k) {
    const S growth = direction * (now.state.back_stress[k] - before.back_stress[k]);
    const S y = law.back_rate[k] * dp;
    const auto nearly_line = y < constant<S>(sizeof(real_t<S>) == 8 ? 1e-4 : 1e-2);
    const S rate = select(nearly_line, one, law.back_rate[k]);
    const S sum = direction * (now.state.back_stress[k] + before.back_stress[k]);
    const S by_line = dp * (constant<S>(0.5) * sum + constant<S>(1.0 / 12.0) * y * growth);
    work += select(nearly_line, by_line, (law.back_modulus[k] * dp - growth) / rate);
  }
  return work;
}

}  // namespace plastica::law
