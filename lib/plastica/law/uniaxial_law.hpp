#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/scalar.hpp"

/// What the uniaxial laws share: a law is a file of its own, and a line in law/uniaxial.hpp.
///
/// All laws share the split e = e_elastic + e_plastic, s = K e_elastic, and the yield condition
/// |s - sum X_k| <= R. While the flow of an increment goes one way (direction d = +-1), p is by how
/// much it has grown. A law says, each as a function of p and of the accumulated plastic strain at
/// the increment's begin:
///   radius(accumulated, p)                       R, and its slope by p
///   radius_integral(accumulated, p)              of R over p, from 0
///   recovery(k)                                  gamma_k, where back stresses recover (kRecovers)
///   drive(k, accumulated, along)                 slope of d X_k at the begin; along: d X_k(0)
///   shift(k, accumulated, drive, p)              by how much d X_k has grown, and its slope
///   source(k, accumulated, p, flow)              what the flow adds to d X_k, and its slope
///   source_integral(k, accumulated, p, decayed)  of it over p
/// so that d X_k(p) = d X_k(0) + shift = d X_k(0) exp(-gamma_k p) + source. Sections with one yield
/// surface and fibres under two stresses ask for the same.
namespace plastica::law {

/// State of a law. A law without back stresses has no room for any.
template <class S, std::size_t kBacks>
struct LawState {
  S plastic{};                          ///< permanent strain [1]
  S accumulated{};                      ///< sum of |d plastic| [1], >= 0
  std::array<S, kBacks> back_stress{};  ///< X_k [Pa]
};
template <class S>
struct LawState<S, 0> {
  S plastic{};
  S accumulated{};
};

/// A state without its derivatives.
template <class S, std::size_t kBacks>
inline auto values_of(const LawState<S, kBacks>& state) {
  LawState<decltype(value_of(state.plastic)), kBacks> values;
  values.plastic = value_of(state.plastic);
  values.accumulated = value_of(state.accumulated);
  if constexpr (kBacks > 0) {
    for (std::size_t k = 0; k < kBacks; ++k) {
      values.back_stress[k] = value_of(state.back_stress[k]);
    }
  }
  return values;
}

/// What `respond` returns. @tparam State the law's state after the increment
template <class S, class State>
struct UniaxialResponse {
  S stress;   ///< [Pa]
  S tangent;  ///< d stress / d strain at the end of the increment [Pa]
  State state;
};

/// A number that changes with the flow p of an increment.
template <class S>
struct Grown {
  S value;
  S slope;  ///< by p
};

/// What an increment leaves of a back stress, and adds to it along the flow.
template <class S>
struct BackFlow {
  S power;    ///< exp(-gamma p), what is left of it [1]
  S decayed;  ///< the integral of that over p
  Grown<S> source;
};

namespace detail {

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

/// The integral of `decay` over x, (x - decayed)/rate; where that would cancel, its series.
template <class S>
inline S decay_integral(const S& rate, const S& x, const S& decayed) {
  const S y = rate * x;
  const auto small = y < constant<S>(sizeof(real_t<S>) == 8 ? 1e-4 : 1e-2);
  const S series = constant<S>(0.5) * x * x * (constant<S>(1) - constant<S>(1.0 / 3.0) * y);
  return select(small, series, (x - decayed) / select(small, constant<S>(1), rate));
}

}  // namespace detail

template <class Law, class S>
inline BackFlow<S> back_flow(const Law& law, std::size_t k, const S& accumulated, const S& p) {
  using plastica::exp;
  BackFlow<S> flow{constant<S>(1), p, {}};
  if constexpr (Law::kRecovers) {
    flow.power = exp(-law.recovery(k) * p);
    flow.decayed = detail::decay(law.recovery(k), p, flow.power);
  }
  if constexpr (Law::kBacks > 0) flow.source = law.source(k, accumulated, p, flow);
  return flow;
}

/// Where Newton's method for the flow of an increment begins: at nothing, or, of a law with a rate,
/// where the factor alone would take up the overstress.
/// @param excess  the overstress of the begin over the radius
template <class Law, class S>
inline S first_flow(const Law& law, const S& excess, const S& most) {
  if constexpr (requires { law.factor; }) return law.factor.reached(excess, most);
  return constant<S>(0);
}

/// A step of Newton's method, in the variable that suits the law.
template <class Law, class S>
inline S stepped(const Law& law, const S& p, const S& step) {
  if constexpr (requires { law.factor; }) {
    return law.factor.stepped(p, step);
  } else {
    return p + step;
  }
}

}  // namespace plastica::law
