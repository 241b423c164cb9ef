#pragma once

#include <array>
#include <cstddef>

#include "plastica/law/uniaxial_law.hpp"

namespace plastica::law {
namespace detail {

/// How many Newton steps a return may take. It converges quadratically; the bracket halves the
/// rest. Reached only by NaN.
inline constexpr int kMostReturnSteps = 60;

}  // namespace detail

/// Return mapping of a law that has none of its own, exact over the increment.
///
/// The flow p solves
///   f(p) = d K (e - e_p) - K p - d sum X_k(p) - R(p) = 0,
/// inside of a bracket from 0 to the law's `latest`. It ends when one more Newton step is sure to
/// reach rounding: after a Newton step of 1e-5 p (which leaves its square; of a law with kinks it
/// may not be skipped) or a halving of the bracket by 1e-8 p (which leaves itself). A lane that is
/// done waits for its neighbours and does not change.
template <class Law>
requires Law::kByNewton inline UniaxialResponse<typename Law::Scalar, typename Law::State> respond(
    const Law& law, const typename Law::State& before, const typename Law::Scalar& strain) {
  using S = typename Law::Scalar;
  constexpr std::size_t kBacks = Law::kBacks;
  constexpr bool kDouble = sizeof(real_t<S>) == 8;
  const S zero = constant<S>(0);
  const S trial = law.stiffness * (strain - before.plastic);
  S total_back = zero;
  for (const S& x : before.back_stress) total_back += x;
  const S direction = sign(trial - total_back);
  Grown<S> radius = law.radius(before.accumulated, zero);
  const S over = direction * (trial - total_back) - radius.value;
  const auto yields = over > zero;
  if (!any(yields)) return {trial, law.stiffness, before};

  std::array<S, kBacks> along;
  for (std::size_t k = 0; k < kBacks; ++k) along[k] = direction * before.back_stress[k];
  const S begins = over + radius.value;
  std::array<BackFlow<S>, kBacks> flow;
  S slope;  // -f'
  const auto residual_at = [&](const S& p) {
    radius = law.radius(before.accumulated, p);
    S residual = begins - law.stiffness * p - radius.value;
    slope = law.stiffness + radius.slope;
    for (std::size_t k = 0; k < kBacks; ++k) {
      flow[k] = back_flow(law, k, before.accumulated, p);
      const Grown<S> shift = back_shift(law, k, along[k], flow[k]);
      residual -= shift.value;
      slope += shift.slope;
    }
    return residual;
  };

  S p = zero;
  S low = zero;
  S high = select(yields, law.latest(over, before.accumulated), zero);
  const S after_newton =
      constant<S>(Law::kHasKinks ? (kDouble ? 1e-15 : 1e-6) : (kDouble ? 1e-5 : 1e-2));
  const S after_halving = constant<S>(kDouble ? 1e-8 : 3e-4);
  auto active = yields;
  S residual = residual_at(p);
  for (int step = 0; step < detail::kMostReturnSteps; ++step) {
    low = select(residual > zero, p, low);
    high = select(residual < zero, p, high);
    const S newton = p + residual / slope;
    const auto inside = (newton >= low) & (newton <= high);
    const S next = select(inside, newton, constant<S>(0.5) * (low + high));
    const auto moves =
        active & (abs(next - p) > select(inside, after_newton, after_halving) * next);
    p = select(active, next, p);
    active = moves;
    residual = residual_at(p);
    if (!any(active)) break;
  }
  // One step without the bracket: it squares the error, and a dual scalar gets the derivative of
  // the root from it.
  p = select(yields, p + residual / slope, zero);

  UniaxialResponse<S, typename Law::State> now;
  now.state.plastic = before.plastic + direction * p;
  now.state.accumulated = before.accumulated + p;
  for (std::size_t k = 0; k < kBacks; ++k) {
    const BackFlow<S> ends = back_flow(law, k, before.accumulated, p);
    now.state.back_stress[k] =
        before.back_stress[k] + direction * back_shift(law, k, along[k], ends).value;
  }
  now.stress = law.stiffness * (strain - now.state.plastic);
  // K h / (K + h), with the hardening modulus h = slope - K at the end of the increment.
  const S elastic_plastic = law.stiffness * (slope - law.stiffness) / slope;
  now.tangent = select(yields, elastic_plastic, law.stiffness);
  return now;
}

}  // namespace plastica::law
