#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "plastica/solve/newton_step.hpp"

/// Newton's method for the equilibrium of a chain, with the consistent tangent.
///
/// Unknown are the joints' angles (and shifts), the free translations of the root, the multipliers
/// of the constraints and, under path control, the time. Each iteration places the segments, asks
/// the laws, factors the chain once and solves for the imbalance, a column per constraint and one
/// for the time; a small dense system joins them (chain/README.md).
namespace plastica::solve {

/// Whether an imbalance is worth another iteration. What is not a number is not.
template <class S>
mask_t<S> may_improve(const S& imbalance, const S& enough) {
  return (imbalance > enough) & (imbalance < constant<S>(kIsDouble<S> ? 1e100 : 1e30));
}

/// Seeks the equilibrium at `w.time`, or on a path condition, from the current unknowns.
///
/// @param assemble  (work, slopes): places the chain and gathers all that acts on it; where slopes
///                  are asked for, how it changes, too
/// @param condition  asked for at each iteration with the placed chain; its default makes time
///                   fixed
/// @return not converged after `max_iterations`, or as soon as a number is not finite
template <class L, bool kElastic, class Assemble, class Condition>
NewtonOutcome<typename L::Scalar> equilibrate(const chain::Chain<L>& chain,
                                              const Assemble& assemble,
                                              const NewtonOptions& options,
                                              NewtonWork<L, kElastic>& w,
                                              const Condition& condition_at) {
  using S = typename L::Scalar;
  NewtonOutcome<S> outcome;
  bool polished = false;
  mask_t<S> ended = w.settled;              // or by what one solve leaves
  mask_t<S> lost = in_all_lanes<S>(false);  // while others go on
  std::array<S, kMaxPatience> recent{};     // imbalances before the last steps of each lane
  w.stepped = constant<S>(0);
  for (int iteration = 0;; ++iteration) {
    const S enough = constant<S>(reachable<S>(options.tolerance, iteration));
    // Waiting for others to be polished, a lane may see more iterations than it takes.
    const auto note = [&](const S& imbalance) {
      const std::size_t last = outcome.imbalance.size() - 1;
      outcome.imbalance[std::min(static_cast<std::size_t>(iteration), last)] = imbalance;
    };
    // What may be the end of one solve is looked at without slopes; but not where contacts are
    // decided, which is done once an iteration.
    const bool may_end = options.one_solve && iteration > 0;
    const bool looks = may_end && std::none_of(chain.constraints.begin(), chain.constraints.end(),
                                               [](const auto& k) { return k.one_sided; });
    assemble(w, !looks);
    const mask_t<S> hold = may_end ? detail::constraints_hold(chain, w) : lost;
    if (may_end && any(hold)) {
      w.recursion.sum(chain, w.q, w.placement, w.stage, w.joints, w.outer_forces, w.transmitted);
      const S imbalance = detail::relative_imbalance(chain, w);
      const S little = constant<S>(reachable<S>(options.one_solve_tolerance, iteration));
      note(imbalance);
      outcome.iterations = iteration;
      ended = ended | (hold & (imbalance <= little));
      outcome.converged = ended & !lost;
      if (!any(!(ended | lost))) break;
    }
    if (looks) assemble(w, true);
    const PathCondition<L> condition = condition_at(w);
    if (condition.active) detail::stiffen_condition(chain, condition, w);
    w.recursion.factor(chain, w.q, w.placement, w.stage, w.joints, w.outer_forces, w.transmitted);
    S imbalance = detail::relative_imbalance(chain, w);
    if (condition.active) imbalance = max(imbalance, abs(condition.value));
    note(imbalance);
    outcome.iterations = iteration;
    outcome.converged = (ended | (imbalance <= enough)) & !lost;
    const mask_t<S> out = outcome.solves >= constant<S>(options.max_iterations);
    mask_t<S> going = may_improve(imbalance, enough) & !ended & !lost & !out;
    if (options.patience > 0) {
      const S& before = recent[static_cast<std::size_t>(options.patience - 1)];
      const mask_t<S> early = outcome.solves < constant<S>(options.patience);
      going = going & (early | (imbalance <= constant<S>(0.1) * before));
    }
    // A value that is there gets its derivatives from one more step.
    const mask_t<S> worth = kIsDouble<S> ? outcome.converged & !out : !out;
    const bool polishes =
        (kCarriesDerivatives<S> || options.polishes) && !any(going) && any(worth) && !polished;
    if ((!any(going) && !polishes) || is_raised(options.stop)) break;
    polished = polishes;
    if constexpr (kHasLanes<S>) lost = lost | (!(going | outcome.converged));
    detail::solve_imbalance(chain, condition, w);
    for (std::size_t k = 0; k < chain.constraints.size(); ++k)
      detail::solve_constraint(chain, k, w);
    if (condition.active) detail::solve_time(chain, condition, w);
    detail::join_columns(chain, condition, w);
    detail::combine_columns(chain, condition, w);
    const mask_t<S> stays = lost | (polishes ? w.settled | out : outcome.converged);
    outcome.solves = outcome.solves + select(stays, constant<S>(0), constant<S>(1));
    for (std::size_t k = recent.size(); k-- > 0;) {
      recent[k] = select(stays, recent[k], k > 0 ? recent[k - 1] : imbalance);
    }
    detail::take_step(chain, condition, stays, w);
  }
  return outcome;
}

/// The same in statics.
template <class L, bool kElastic, class Condition>
NewtonOutcome<typename L::Scalar> equilibrate(const chain::Chain<L>& chain,
                                              chain::JointLaws<L, kElastic>& laws,
                                              const NewtonOptions& options,
                                              NewtonWork<L, kElastic>& w,
                                              const Condition& condition_at) {
  return equilibrate(
      chain,
      [&](NewtonWork<L, kElastic>& work, bool /*slopes*/) { detail::assemble(chain, laws, work); },
      options, w, condition_at);
}

/// The same at a given time.
template <class L, bool kElastic>
NewtonOutcome<typename L::Scalar> equilibrate(const chain::Chain<L>& chain,
                                              chain::JointLaws<L, kElastic>& laws,
                                              const NewtonOptions& options,
                                              NewtonWork<L, kElastic>& w) {
  return equilibrate(chain, laws, options, w,
                     [](const NewtonWork<L, kElastic>&) { return PathCondition<L>{}; });
}

}  // namespace plastica::solve
