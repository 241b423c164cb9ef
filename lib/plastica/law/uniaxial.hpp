#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "plastica/base/scalar.hpp"

/// Uniaxial elastic-plastic laws: pure functions of one joint or fibre.
///
/// All laws share the split e = e_elastic + e_plastic, s = K e_elastic, and the yield condition
/// |s - back stress| <= yield stress. `respond(law, state, strain)` takes the state before a
/// straight strain increment and returns stress, tangent and the state after; it is the exact
/// solution of the law over the increment, however long (no sub-steps), so a curve does not depend
/// on how densely its plastic parts are sampled. Tension, bending and torsion all use it: `strain`
/// and `stress` are those of the extreme fibre.
namespace plastica::law {

/// What `respond` returns. @tparam State the law's state after the increment
template <class S, class State>
struct UniaxialResponse {
  S stress;   ///< [Pa]
  S tangent;  ///< d stress / d strain at the end of the increment [Pa]
  State state;
};

/// Ideal plasticity, the report's law: the stress never leaves [-yield, yield].
template <class S>
struct IdealPlastic {
  S stiffness;   ///< K: E, or G in torsion [Pa], > 0
  S compliance;  ///< 1/K, kept so that the kernel does not divide
  S yield;       ///< [Pa], > 0

  struct State {
    S plastic{};      ///< permanent strain [1]
    S accumulated{};  ///< sum of |d plastic| [1], >= 0
  };
};

/// Linear hardening: part isotropic (the yield stress grows), part kinematic (Prager: the elastic
/// range moves). Both moduli are d stress / d plastic strain.
template <class S>
struct LinearHardening {
  S stiffness;  ///< [Pa], > 0
  S yield;      ///< initial yield stress [Pa], > 0
  S isotropic;  ///< [Pa], >= 0
  S kinematic;  ///< [Pa], >= 0

  struct State {
    S plastic{};
    S accumulated{};
    S back_stress{};  ///< [Pa]
  };
};

inline constexpr std::size_t kBackStresses = 3;

/// Voce isotropic hardening with Chaboche back stresses.
///
/// Yield stress: yield + Q (1 - exp(-b p)), p the accumulated plastic strain (Voce 1948).
/// Back stress: the sum of dX_k = C_k d e_p - gamma_k X_k dp (Armstrong and Frederick 1966;
/// Chaboche 1986). gamma_k = 0 makes a part linear (Prager).
template <class S>
struct VoceChaboche {
  S stiffness;   ///< [Pa], > 0
  S yield;       ///< [Pa], > 0
  S saturation;  ///< Q [Pa]; may be negative (cyclic softening), yield + Q > 0
  S rate;        ///< b [1], >= 0
  std::array<S, kBackStresses> back_modulus;  ///< C_k [Pa], >= 0
  std::array<S, kBackStresses> back_rate;     ///< gamma_k [1], >= 0

  struct State {
    S plastic{};
    S accumulated{};
    std::array<S, kBackStresses> back_stress{};  ///< X_k [Pa]
  };
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

/// With the trial overstress f: dp = f / (K + H_iso + H_kin) (Simo and Hughes 1998, box 1.5).
template <class S>
inline UniaxialResponse<S, typename LinearHardening<S>::State> respond(
    const LinearHardening<S>& law, const typename LinearHardening<S>::State& before,
    const S& strain) {
  const S trial = law.stiffness * (strain - before.plastic);
  const S relative = trial - before.back_stress;
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
  now.state.back_stress = before.back_stress + law.kinematic * along;
  now.stress = law.stiffness * (strain - now.state.plastic);
  now.tangent = select(yields, law.stiffness * hardening * softness, law.stiffness);
  return now;
}

namespace detail {

/// How many Newton steps the return of VoceChaboche may take. It converges quadratically; the
/// bracket halves the rest. Reached only by NaN.
inline constexpr int kMostReturnSteps = 60;

/// (1 - exp(-rate x))/rate, given power = exp(-rate x): by its series where the difference would
/// cancel, which also has the right derivative by a rate of zero.
template <class S>
inline S decay(const S& rate, const S& x, const S& power) {
  const S one = constant<S>(1);
  const S y = rate * x;
  const auto small = y < constant<S>(sizeof(real_t<S>) == 8 ? 1e-4 : 1e-2);
  const S series =
      x * (one - y * constant<S>(1.0 / 2.0) *
                     (one - y * constant<S>(1.0 / 3.0) * (one - y * constant<S>(1.0 / 4.0))));
  return select(small, series, (one - power) / select(small, one, rate));
}

}  // namespace detail

/// Return mapping of Voce and Chaboche, exact over the increment.
///
/// While the plastic strain runs one way (direction d = +-1) the back stresses have the closed
/// form X_k(dp) = d C_k/gamma_k + (X_k - d C_k/gamma_k) exp(-gamma_k dp), and dp solves
///   f(dp) = d K (e - e_p) - K dp - d sum X_k(dp) - yield - Q (1 - exp(-b (p + dp))) = 0.
/// For Q >= 0, f is convex and falls with dp, so Newton from dp = 0 never overshoots; for Q < 0 a
/// bracket keeps it inside. It ends when one more Newton step is sure to reach rounding: after a
/// Newton step of 1e-5 dp (which leaves its square) or a halving of the bracket by 1e-8 dp (which
/// leaves itself). A lane that is done waits for its neighbours and does not change.
template <class S>
inline UniaxialResponse<S, typename VoceChaboche<S>::State> respond(
    const VoceChaboche<S>& law, const typename VoceChaboche<S>::State& before, const S& strain) {
  using plastica::exp;
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  const S trial = law.stiffness * (strain - before.plastic);
  S total_back = zero;
  for (const S& x : before.back_stress) total_back += x;
  const S direction = sign(trial - total_back);
  const S softened = law.saturation * exp(-law.rate * before.accumulated);
  const S over = direction * (trial - total_back) - (law.yield + law.saturation - softened);
  const auto yields = over > zero;
  if (!any(yields)) return {trial, law.stiffness, before};

  // C_k - gamma_k d X_k: the slope of d X_k where the increment begins.
  std::array<S, kBackStresses> drive;
  S slope = law.stiffness + softened * law.rate;
  for (std::size_t k = 0; k < kBackStresses; ++k) {
    drive[k] = law.back_modulus[k] - law.back_rate[k] * direction * before.back_stress[k];
    slope += drive[k];
  }
  // f(dp), and -f'(dp) in `slope`. d (X_k(dp) - X_k) = drive_k (1 - exp(-gamma_k dp)) / gamma_k.
  const auto residual_at = [&](const S& dp) {
    const S iso_power = exp(-law.rate * dp);
    S residual = over - law.stiffness * dp - softened * (one - iso_power);
    slope = law.stiffness + softened * law.rate * iso_power;
    for (std::size_t k = 0; k < kBackStresses; ++k) {
      const S power = exp(-law.back_rate[k] * dp);
      residual -= drive[k] * detail::decay(law.back_rate[k], dp, power);
      slope += drive[k] * power;
    }
    return residual;
  };

  S dp = zero;
  S low = zero;
  S high = select(yields, (over + max(zero, -softened)) / law.stiffness, zero);
  constexpr bool kDouble = sizeof(real_t<S>) == 8;
  const S after_newton = constant<S>(kDouble ? 1e-5 : 1e-2);
  const S after_halving = constant<S>(kDouble ? 1e-8 : 3e-4);
  auto active = yields;
  S residual = over;  // at dp = 0, where no power needs to be computed
  for (int step = 0; step < detail::kMostReturnSteps; ++step) {
    low = select(residual > zero, dp, low);
    high = select(residual < zero, dp, high);
    const S newton = dp + residual / slope;
    const auto inside = (newton >= low) & (newton <= high);
    const S next = select(inside, newton, constant<S>(0.5) * (low + high));
    const auto moves =
        active & (abs(next - dp) > select(inside, after_newton, after_halving) * next);
    dp = select(active, next, dp);
    active = moves;
    residual = residual_at(dp);
    if (!any(active)) break;
  }
  // One step without the bracket: it squares the error, and a dual scalar gets the derivative of
  // the root from it.
  dp = select(yields, dp + residual / slope, zero);

  UniaxialResponse<S, typename VoceChaboche<S>::State> now;
  now.state.plastic = before.plastic + direction * dp;
  now.state.accumulated = before.accumulated + dp;
  for (std::size_t k = 0; k < kBackStresses; ++k) {
    const S power = exp(-law.back_rate[k] * dp);
    now.state.back_stress[k] =
        before.back_stress[k] + direction * drive[k] * detail::decay(law.back_rate[k], dp, power);
  }
  now.stress = law.stiffness * (strain - now.state.plastic);
  // K h / (K + h), with the hardening modulus h = slope - K at the end of the increment.
  const S elastic_plastic = law.stiffness * (slope - law.stiffness) / slope;
  now.tangent = select(yields, elastic_plastic, law.stiffness);
  return now;
}

}  // namespace plastica::law
