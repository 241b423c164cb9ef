#pragma once

#include <cstddef>
#include <optional>
#include <tuple>

#include "plastica/chain/lane_fields.hpp"
#include "plastica/chain/view.hpp"
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
  [&]<class... Law>(std::tuple<Law...>*) {
    std::size_t number = 0;
    const auto is_it = [&] { return number++ == static_cast<std::size_t>(law); };
    ((is_it() ? use(static_cast<chain::SectionJoints<L, false, Law>&>(joints)) : void()), ...);
  }(static_cast<chain::LaneLaws<double>*>(nullptr));
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
