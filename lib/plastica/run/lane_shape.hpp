#pragma once

#include <optional>
#include <type_traits>

#include "plastica/chain/lane_fields.hpp"
#include "plastica/chain/view.hpp"
#include "plastica/law/uniaxial.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/solve/lane_newton.hpp"

/// Which models can lie in lanes beside each other.
namespace plastica {

/// The law of a model's joints, if lanes have it.
std::optional<solve::LaneLaw> lane_law(const ChainModel& model);

/// Whether two models have the same level, law and segments, with supports, loads and masses of the
/// same kind at the same segments; all other numbers may differ.
bool same_shape(const ChainModel& a, const ChainModel& b);

/// Whether two motions have the same stops, samples and histories, of loads and supports in their
/// order.
bool same_times(const ChainModel& a, const ChainModel& b);

/// Calls `use` with a chain's joints as what they are.
template <class L, class Use>
void with_joints(solve::LaneLaw law, chain::SectionJointsBase<L, false>& joints, const Use& use) {
  const auto as = [&](auto tag) {
    using Law = typename decltype(tag)::type;
    use(static_cast<chain::SectionJoints<L, false, Law>&>(joints));
  };
  using S = double;
  switch (law) {
    case solve::LaneLaw::Elastic: as(std::type_identity<law::ElasticSection<S>>{}); return;
    case solve::LaneLaw::Ideal:
      as(std::type_identity<law::PerAxisSection<S, law::IdealPlastic<S>>>{});
      return;
    case solve::LaneLaw::Linear:
      as(std::type_identity<law::PerAxisSection<S, law::LinearHardening<S>>>{});
      return;
    case solve::LaneLaw::VoceChaboche:
      as(std::type_identity<law::PerAxisSection<S, law::VoceChaboche<S>>>{});
      return;
    case solve::LaneLaw::Multilinear:
      as(std::type_identity<law::PerAxisSection<S, law::Multilinear<S>>>{});
      return;
  }
}

/// A view of a model at a level in lanes.
template <class L>
chain::View<L> view_of(const ChainModel& model) {
  if constexpr (requires(chain::View<L> view) { view.across; }) {
    return {model.across};
  } else {
    return {};
  }
}

}  // namespace plastica
