#pragma once

#include <type_traits>

#include "plastica/law/interaction.hpp"

/// The laws with one yield surface, compiled once for all levels: their return is long, and each of
/// the five surfaces has it with each of the hardening laws.
namespace plastica {

/// A section law whose `respond` is a call into surface_law_*.cpp.
/// @tparam Section  law::InteractionSection<S, …>
template <class Section>
struct SurfaceLaw {
  using S = std::remove_cvref_t<decltype(Section::cap[0])>;
  using State = typename Section::State;
  static constexpr bool kSeesAxial = Section::kSeesAxial;
  Section section;

  template <class Use>
  void each_uniaxial(const Use& use) {
    section.each_uniaxial(use);
  }
};

/// See law::respond.
template <class Section>
law::SectionResponse<typename SurfaceLaw<Section>::S> respond(
    const SurfaceLaw<Section>& law, const typename Section::State& before,
    typename Section::State& after,
    const law::SectionStrain<typename SurfaceLaw<Section>::S>& strain);

}  // namespace plastica
