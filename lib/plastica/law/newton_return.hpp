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

namespace detail {

/// The flow of one increment of a law, and what it is sought from.
template <class Law>
class NewtonReturn {
 public:
  using S = typename Law::Scalar;
  using State = typename Law::State;
  static constexpr std::size_t kBacks = Law::kBacks;
  static constexpr bool kDouble = sizeof(real_t<S>) == 8;
  static constexpr bool kRated = requires(const Law& law) { law.factor; };
  static constexpr bool kDecays = requires { requires Law::kDecays; };

  PLASTICA_ALWAYS_INLINE NewtonReturn(const Law& law, const State& before, const S& strain)
      : law_(law), before_(before), strain_(strain), begun_(before.accumulated) {
    trial_ = law.stiffness * (strain - before.plastic);
    S back = constant<S>(0);
    for (const S& x : before.back_stress) back += x;
    direction_ = sign(trial_ - back);
    if constexpr (kDecays) {
      begun_ = law.left(before.accumulated);
      radius_ = law.radius_left(begun_);
    } else {
      radius_ = law.radius(begun_, constant<S>(0));
    }
    over_ = direction_ * (trial_ - back) - radius_.value;
    yields_ = over_ > constant<S>(0);
  }
  PLASTICA_ALWAYS_INLINE bool any_yields() const { return any(yields_); }
  /// Of an increment that does not flow.
  PLASTICA_ALWAYS_INLINE UniaxialResponse<S, State> elastic() const {
    return {trial_, law_.stiffness, before_};
  }

  /// Before all that follows.
  PLASTICA_ALWAYS_INLINE void begin() {
    slope_ = law_.stiffness + radius_.slope;
    if constexpr (kDecays) bend_ = law_.rate * radius_.slope;
    for_each_of<kBacks>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      drive_[k] = law_.drive(k, before_.accumulated, S(direction_ * before_.back_stress[k]));
      slope_ += drive_[k];
      if constexpr (kDecays) bend_ += law_.recovery(k) * drive_[k];
    });
    begins_ = over_ + radius_.value;
  }

  /// f at a flow.
  PLASTICA_ALWAYS_INLINE S residual_at(const S& p) {
    Grown<S> grown;
    if constexpr (kDecays) {
      grown = law_.radius_left(begun_ * Law::decayed_to(law_.rate, p));
      bend_ = law_.rate * grown.slope;
    } else {
      grown = law_.radius(begun_, p);
    }
    S residual = begins_ - law_.stiffness * p - grown.value;
    slope_ = law_.stiffness + grown.slope;
    for_each_of<kBacks>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      shift_[k] = law_.shift(k, before_.accumulated, drive_[k], p);
      residual -= shift_[k].value;
      slope_ += shift_[k].slope;
      if constexpr (kDecays) bend_ += law_.recovery(k) * shift_[k].slope;
    });
    return residual;
  }

  /// A flow that is less than one step from the root. @param[out] residual  there
  PLASTICA_ALWAYS_INLINE S seek(S& residual) {
    const S zero = constant<S>(0);
    S p = zero;
    S low = zero;
    S latest;
    if constexpr (kDecays) {
      latest = law_.latest_left(over_, begun_);
    } else {
      latest = law_.latest(over_, before_.accumulated);
    }
    S high = select(yields_, latest, zero);
    const S after_newton = constant<S>(kRated           ? 1e-9
                                       : Law::kHasKinks ? (kDouble ? 1e-15 : 1e-6)
                                       : kDecays        ? (kDouble ? 1e-4 : 1e-2)
                                                        : (kDouble ? 1e-5 : 1e-2));
    const S after_halving = constant<S>(kDouble ? 1e-8 : 3e-4);
    // What rounding makes of f: below it there is nothing to seek. A rate's slope may be far above
    // K.
    S rounding = constant<S>(kDouble ? 2e-16 : 1e-7) * begins_ / law_.stiffness;
    auto active = yields_;
    residual = over_;
    if constexpr (kRated) {
      p = select(yields_, first_flow(law_, S(over_ / radius_.value), high), zero);
      residual = residual_at(p);
    }
    for (int step = 0; step < kMaxReturnSteps; ++step) {
      low = select(residual > zero, p, low);
      high = select(residual < zero, p, high);
      const S newton = stepped(law_, p, step_of(residual));
      if constexpr (kRated) rounding = constant<S>(2e-16) * begins_ / slope_;
      const auto inside = (newton >= low) & (newton <= high);
      const S next = select(inside, newton, constant<S>(0.5) * (low + high));
      const S enough = max(select(inside, after_newton, after_halving) * next, rounding);
      const auto moves = active & (abs(next - p) > enough);
      p = select(active, next, p);
      active = moves;
      residual = residual_at(p);
      if (!any(active)) break;
    }
    return p;
  }

  /// After one more step, without the bracket: it squares the error, and a dual scalar gets the
  /// derivative of the root from it.
  PLASTICA_ALWAYS_INLINE UniaxialResponse<S, State> finish(const S& p, const S& residual) const {
    const S zero = constant<S>(0);
    const S last = select(yields_, residual / slope_, zero);
    const S flow = select(yields_, p + last, zero);
    UniaxialResponse<S, State> now;
    now.state.plastic = before_.plastic + direction_ * flow;
    now.state.accumulated = before_.accumulated + flow;
    for_each_of<kBacks>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      // The last step is far below what second order would show.
      const S grown = select(yields_, shift_[k].value + shift_[k].slope * last, zero);
      now.state.back_stress[k] = before_.back_stress[k] + direction_ * grown;
    });
    now.stress = law_.stiffness * (strain_ - now.state.plastic);
    // K h / (K + h), with the hardening modulus h = slope - K at the end of the increment.
    const S elastic_plastic = law_.stiffness * (slope_ - law_.stiffness) / slope_;
    now.tangent = select(yields_, elastic_plastic, law_.stiffness);
    return now;
  }

 private:
  PLASTICA_ALWAYS_INLINE S step_of(const S& residual) const {
    const S newton = residual / slope_;
    if constexpr (kDecays) {
      const S divisor = constant<S>(1) - constant<S>(0.5) * newton * (bend_ / slope_);
      return newton / max(constant<S>(0.5), divisor);
    } else {
      return newton;
    }
  }

  const Law& law_;
  const State& before_;
  const S& strain_;
  S trial_, direction_, over_, begins_;
  S begun_;  ///< what the radius is a function of, besides the flow
  Grown<S> radius_;
  S slope_;                  ///< -f'
  S bend_ = constant<S>(0);  ///< f'', of a law that decays
  std::array<S, kBacks> drive_;
  std::array<Grown<S>, kBacks> shift_;
  mask_t<S> yields_;
};

}  // namespace detail

/// Return mapping of a law that has none of its own, exact over the increment.
///
/// The flow p solves
///   f(p) = d K (e - e_p) - K p - d sum X_k(p) - R(p) = 0,
/// inside of a bracket from 0 to the law's `latest`. It ends when one more Newton step is sure to
/// reach rounding: after a Newton step of 1e-5 p (which leaves its square; of a law with kinks it
/// may not be skipped; with a rate, of 1e-9 p), after one of Halley's of 1e-4 p (which leaves its
/// cube; `kDecays`), or after a halving of the bracket by 1e-8 p (which leaves itself), or where
/// rounding is all that is left. A lane that is done waits for its neighbours and does not change.
///
/// With g = -f' and f'' = b R' + sum gamma_k (d X_k)', Halley's step is
/// (f/g)/(1 - f f''/(2 g^2)); its divisor is held at 1/2 where the parabola has no root.
template <class Law>
requires Law::kByNewton inline UniaxialResponse<typename Law::Scalar, typename Law::State> respond(
    const Law& law, const typename Law::State& before, const typename Law::Scalar& strain) {
  using S = typename Law::Scalar;
  detail::NewtonReturn<Law> increment(law, before, strain);
  if (!increment.any_yields()) return increment.elastic();
  increment.begin();
  S residual;
  S p;
  if constexpr (kCarriesDerivatives<S> && requires { law.values(); }) {
    // The values alone find the flow; the last step has its derivatives (implicit functions).
    const auto values = law.values();
    const auto values_before = values_of(before);
    const auto value = value_of(strain);
    detail::NewtonReturn alone(values, values_before, value);
    alone.begin();
    decltype(value_of(strain)) left;
    p = S(alone.seek(left));
    residual = increment.residual_at(p);
  } else {
    p = increment.seek(residual);
  }
  return increment.finish(p, residual);
}

}  // namespace plastica::law
