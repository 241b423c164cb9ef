#pragma once

#include <tuple>
#include <type_traits>

#include "plastica/law/multilinear.hpp"
#include "plastica/law/rate_factor.hpp"
#include "plastica/law/voce_chaboche.hpp"

namespace plastica::law {

/// A uniaxial law each point of which has the rate of its own flow: the radius is that of the law
/// times the factor of the increment's mean rate. Needs `set_time` before it responds.
/// @tparam Law  one that is solved by Newton's method, of scalars of one number each
template <class Law>
struct Rated : Law {
  using Scalar = typename Law::Scalar;
  using S = Scalar;
  static constexpr bool kDecays = false;   // the factor does not
  static constexpr bool kHasKinks = true;  // Johnson and Cook's, at the reference rate

  RateFactor<S> factor;

  static Rated of(const UniaxialMaterial<S>& m, const MaterialValues<S>& values) {
    return {Law::of(m, values), RateFactor<S>::of(m.rate, values, constant<S>(1) / m.rates)};
  }
  /// Before the increments that take so long [s]; of 0 nothing flows.
  void set_time(double seconds) { factor.per_second = constant<S>(1.0 / seconds); }

  Grown<S> radius(const S& accumulated, const S& p) const {
    const Grown<S> at_rest = Law::radius(accumulated, p);
    const Grown<S> raised = factor.after(p);
    return {raised.value * at_rest.value,
            raised.value * at_rest.slope + raised.slope * at_rest.value};
  }
  S radius_integral(const S& accumulated, const S& p) const {
    return factor.after(p).value * Law::radius_integral(accumulated, p);
  }
};

/// The hardening laws with rates. Ideal plasticity and linear hardening are tables of no point, and
/// of one far away: `as_table`.
template <class S>
using RatedLaws = std::tuple<Rated<VoceChaboche<S>>, Rated<Multilinear<S>>>;

/// The same material with another hardening law: a table in place of a law that is one.
template <class S>
inline HardeningLaw as_table(HardeningLaw law, MaterialValues<S>& values) {
  if (law != HardeningLaw::Ideal && law != HardeningLaw::Linear) return law;
  const auto at = [&](MaterialField field) -> S& {
    return values[static_cast<std::size_t>(field)];
  };
  for (std::size_t i = 0; i < 2 * Hardening::kTablePoints; ++i) {
    values[static_cast<std::size_t>(MaterialField::PlasticStrain1) + i] = constant<S>(0);
  }
  if (law == HardeningLaw::Ideal) return HardeningLaw::Multilinear;
  const S far = constant<S>(1e3);
  const S& young = at(MaterialField::YoungsModulus);
  const S& tangent = at(MaterialField::TangentModulus);
  at(MaterialField::PlasticStrain1) = far;
  at(MaterialField::FlowStress1) =
      at(MaterialField::YieldStress) + far * (young * tangent / (young - tangent));
  return HardeningLaw::Multilinear;
}

}  // namespace plastica::law
