#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/each_of.hpp"
#include "plastica/law/uniaxial_law.hpp"

namespace plastica::law {
namespace detail {

/// How many Newton steps a return may take. It converges quadratically; the bracket halves the
/// rest. Reached only by NaN.
inline constexpr int kMaxReturnSteps = 60;

}  // namespace detail

/// Return mapping of a law that has none of its own, exact over the increment.
///
/// The flow p solves
///   f(p) = d K (e - e_p) - K p - d sum X_k(p) - R(p) = 0,
/// inside of a bracket from 0 to the law's `latest`. It ends when one more Newton step is sure to
/// reach rounding: after a Newton step of 1e-5 p (which leaves its square; of a law with kinks it
/// may not be skipped; with a rate, of 1e-9 p) or a halving of the bracket by 1e-8 p (which leaves
/// itself), or where rounding is all that is left. A lane that is done waits for its neighbours and
/// does not change.
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
  const Grown<S> radius = law.radius(before.accumulated, zero);
  const S over = direction * (trial - total_back) - radius.value;
  const auto yields = over > zero;
  if (!any(yields)) return {trial, law.stiffness, before};

  std::array<S, kBacks> drive;
  S slope = law.stiffness + radius.slope;  // -f'
  for_each_of<kBacks>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
    drive[k] = law.drive(k, before.accumulated, S(direction * before.back_stress[k]));
    slope += drive[k];
  });
  const S begins = over + radius.value;
  const auto residual_at = [&](const S& p) PLASTICA_ALWAYS_INLINE {
    const Grown<S> grown = law.radius(before.accumulated, p);
    S residual = begins - law.stiffness * p - grown.value;
    slope = law.stiffness + grown.slope;
    for_each_of<kBacks>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      const Grown<S> shift = law.shift(k, before.accumulated, drive[k], p);
      residual -= shift.value;
      slope += shift.slope;
    });
    return residual;
  };

  S p = zero;
  S low = zero;
  S high = select(yields, law.latest(over, before.accumulated), zero);
  constexpr bool kRated = requires { law.factor; };
  const S after_newton = constant<S>(kRated           ? 1e-9
                                     : Law::kHasKinks ? (kDouble ? 1e-15 : 1e-6)
                                                      : (kDouble ? 1e-5 : 1e-2));
  const S after_halving = constant<S>(kDouble ? 1e-8 : 3e-4);
  // What rounding makes of f: below it there is nothing to seek. A rate's slope may be far above K.
  S rounding = constant<S>(kDouble ? 2e-16 : 1e-7) * begins / law.stiffness;
  auto active = yields;
  S residual = over;
  if constexpr (kRated) {
    p = select(yields, first_flow(law, S(over / radius.value), high), zero);
    residual = residual_at(p);
  }
  for (int step = 0; step < detail::kMaxReturnSteps; ++step) {
    low = select(residual > zero, p, low);
    high = select(residual < zero, p, high);
    const S newton = stepped(law, p, S(residual / slope));
    if constexpr (kRated) rounding = constant<S>(2e-16) * begins / slope;
    const auto inside = (newton >= low) & (newton <= high);
    const S next = select(inside, newton, constant<S>(0.5) * (low + high));
    const S enough = max(select(inside, after_newton, after_halving) * next, rounding);
    const auto moves = active & (abs(next - p) > enough);
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
  for_each_of<kBacks>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
    const Grown<S> shift = law.shift(k, before.accumulated, drive[k], p);
    now.state.back_stress[k] = before.back_stress[k] + direction * shift.value;
  });
  now.stress = law.stiffness * (strain - now.state.plastic);
  // K h / (K + h), with the hardening modulus h = slope - K at the end of the increment.
  const S elastic_plastic = law.stiffness * (slope - law.stiffness) / slope;
  now.tangent = select(yields, elastic_plastic, law.stiffness);
  return now;
}

}  // namespace plastica::law
