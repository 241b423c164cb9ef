#pragma once

#include <array>
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

/// Stress along the flow p, R + sum d X_k, of back stresses that were `along` it [Pa].
template <class Law, class S, std::size_t kBacks>
inline S flow_stress(const Law& law, const S& accumulated, const S& p,
                     const std::array<S, kBacks>& along) {
  S stress = law.radius(accumulated, p).value;
  if constexpr (kBacks > 0) {
    for (std::size_t k = 0; k < kBacks; ++k) {
      const S drive = law.drive(k, accumulated, along[k]);
      stress += along[k] + law.shift(k, accumulated, drive, p).value;
    }
  }
  return stress;
}

/// The integral of that over the flow [J/m^3].
template <class Law, class S, std::size_t kBacks>
inline S flow_work(const Law& law, const S& accumulated, const S& p,
                   const std::array<S, kBacks>& along) {
  S work = law.radius_integral(accumulated, p);
  if constexpr (kBacks > 0) {
    for (std::size_t k = 0; k < kBacks; ++k) {
      const S decayed = back_flow(law, k, accumulated, p).decayed;
      work += along[k] * decayed + law.source_integral(k, accumulated, p, decayed);
    }
  }
  return work;
}

/// Back stresses of a state, along a direction of flow.
/// @param direction  +1 or -1
template <class Law>
inline std::array<typename Law::Scalar, Law::kBacks> backs_along(
    const typename Law::State& state, const typename Law::Scalar& direction) {
  std::array<typename Law::Scalar, Law::kBacks> along;
  if constexpr (Law::kBacks > 0) {
    for (std::size_t k = 0; k < Law::kBacks; ++k) along[k] = direction * state.back_stress[k];
  }
  return along;
}

template <class Law>
requires Law::kByNewton inline typename Law::Scalar plastic_work(
    const Law& law, const typename Law::State& before,
    const UniaxialResponse<typename Law::Scalar, typename Law::State>& now) {
  using S = typename Law::Scalar;
  const S direction = sign(now.state.plastic - before.plastic);
  return flow_work(law, before.accumulated, S(now.state.accumulated - before.accumulated),
                   backs_along<Law>(before, direction));
}

}  // namespace plastica::law
