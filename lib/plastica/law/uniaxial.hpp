#pragma once

#include <tuple>
#include <type_traits>

#include "plastica/law/ideal_plastic.hpp"
#include "plastica/law/linear_hardening.hpp"
#include "plastica/law/multilinear.hpp"
#include "plastica/law/uniaxial_law.hpp"
#include "plastica/law/voce_chaboche.hpp"

/// Uniaxial elastic-plastic laws: pure functions of one joint or fibre.
///
/// `respond(law, state, strain)` takes the state before a straight strain increment and returns
/// stress, tangent and the state after; it is the exact solution of the law over the increment,
/// however long (no sub-steps), so a curve does not depend on how densely its plastic parts are
/// sampled. Tension, bending and torsion all use it: `strain` and `stress` are those of the extreme
/// fibre.
namespace plastica::law {

/// All of them.
template <class S>
using UniaxialLaws =
    std::tuple<IdealPlastic<S>, LinearHardening<S>, VoceChaboche<S>, Multilinear<S>>;

/// Calls `use(tag)` with `std::type_identity` of the law's type, so that each is compiled by
/// itself and ideal plasticity pays for nothing else.
template <class S, class Use>
inline void with_law_type(HardeningLaw hardening, Use&& use) {
  const auto if_it_is = [&]<class Law>(std::type_identity<Law> tag) {
    if (hardening == Law::kLaw) use(tag);
  };
  [&]<class... Law>(std::type_identity<std::tuple<Law...>>) {
    (if_it_is(std::type_identity<Law>{}), ...);
  }(std::type_identity<UniaxialLaws<S>>{});
}

}  // namespace plastica::law
