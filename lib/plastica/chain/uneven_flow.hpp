#pragma once

#include <cstddef>
#include <span>

#include "plastica/base/scalar.hpp"
#include "plastica/law/section_response.hpp"

/// Energies of joints whose components have unlike lengths, as those between two sections.
///
/// What a law says is per length of the first component. A component that is d longer stores
/// d F^2/2K more and dissipates d F dp more, p = strain - F/K its permanent part, F its mean while
/// it flows.
namespace plastica::chain {

/// What is known of such a joint at the end of a step.
template <class S>
struct UnevenState {
  law::SectionStrain<S> permanent;  ///< strain - F/K
  law::SectionForce<S> force;
  S energy{};  ///< stored per length [J/m]
};

template <class S>
UnevenState<S> uneven_state(const law::SectionStrain<S>& strain, const law::SectionResponse<S>& now,
                            const law::SectionForce<S>& stiffness,
                            std::span<const std::size_t> components) {
  UnevenState<S> state{{}, now.force, now.elastic_energy};
  for (const std::size_t k : components) {
    state.permanent[k] = strain[k] - now.force[k] / stiffness[k];
  }
  return state;
}

/// F^2/2K.
template <class S>
S energy_of(const S& force, const S& stiffness) {
  return constant<S>(0.5) * force * force / stiffness;
}

/// The mean of each component's force while it flows in a step, by which that does work.
///
/// Where components do not know of each other, and one flows by dp with the slope
/// H = dF/dp = K T/(K - T), it is F - H dp/2, exactly for ideal plasticity and linear hardening.
///
/// Where they yield together, a step from F_0 to F with the flow dp goes elastically first, along
/// G = F - F_0 + K dp, to where the flow begins, F_0 + t G, and then along the yield surface: the
/// mean is (F_0 + t G + F)/2. Of t it is known that all components together do the work W:
///   t = (D - 2 A)/(G dp),  D = (F - F_0) dp,  A = F dp - W,
/// within 0 ... 1: exactly for one component of ideal plasticity and linear hardening, else off by
/// the square of the step. W is work against F: what the law stores and dissipates in the step,
/// less what F^2/2K has grown. (Fibres store more than that by their own stresses.)
/// @tparam kPerAxis  whether components do not know of each other
/// @param stiffness  K of each component
/// @param components  those that the law sees; others have no flow
template <bool kPerAxis, class S>
law::SectionForce<S> mean_of_flow(const UnevenState<S>& before, const UnevenState<S>& after,
                                  const law::SectionResponse<S>& now,
                                  const law::SectionForce<S>& stiffness,
                                  std::span<const std::size_t> components) {
  law::SectionForce<S> mean;
  if constexpr (kPerAxis) {
    for (const std::size_t k : components) {
      const S& tangent = now.tangent(k, k);
      const S harder =
          stiffness[k] * tangent / max(stiffness[k] - tangent, constant<S>(1e-6) * stiffness[k]);
      const S flow = after.permanent[k] - before.permanent[k];
      mean[k] = now.force[k] - constant<S>(0.5) * harder * flow;
    }
    return mean;
  }
  const S zero = constant<S>(0);
  const S half = constant<S>(0.5);
  S along = now.plastic_work + after.energy - before.energy;
  S of_end = zero;
  S of_change = zero;
  S of_trial = zero;
  for (const std::size_t k : components) {
    const S& end = after.force[k];
    const S& begin = before.force[k];
    const S flow = after.permanent[k] - before.permanent[k];
    along = along - half * (end * end - begin * begin) / stiffness[k];
    of_end = of_end + end * flow;
    of_change = of_change + (end - begin) * flow;
    of_trial = of_trial + (end - begin + stiffness[k] * flow) * flow;
  }
  const S begins = of_change - constant<S>(2) * (of_end - along);
  const S t = select(of_trial > zero, min(max(begins / of_trial, zero), constant<S>(1)), zero);
  for (const std::size_t k : components) {
    const S change = after.force[k] - before.force[k];
    const S flow = after.permanent[k] - before.permanent[k];
    mean[k] = half * (before.force[k] + after.force[k] + t * (change + stiffness[k] * flow));
  }
  return mean;
}

/// What components dissipate in a step that are longer than the first by `excess`. Where the law
/// says that nothing flows, it is 0, and not what rounding makes of it.
template <bool kPerAxis, class S>
S uneven_work(const law::SectionStrain<S>& excess, const UnevenState<S>& before,
              const UnevenState<S>& after, const law::SectionResponse<S>& now,
              const law::SectionForce<S>& stiffness, std::span<const std::size_t> components) {
  const S zero = constant<S>(0);
  const mask_t<S> flows = (now.plastic_work > zero) | (now.plastic_work < zero);
  const law::SectionForce<S> mean =
      mean_of_flow<kPerAxis>(before, after, now, stiffness, components);
  S work = zero;
  for (const std::size_t k : components) {
    work = work + excess[k] * mean[k] * (after.permanent[k] - before.permanent[k]);
  }
  return select(flows, work, zero);
}

}  // namespace plastica::chain
