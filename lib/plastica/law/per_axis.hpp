#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/base/each_of.hpp"
#include "plastica/law/plastic_work.hpp"
#include "plastica/law/section_form.hpp"
#include "plastica/law/section_response.hpp"

namespace plastica::law {

/// A section that never yields: its components do not know of each other.
template <class S>
struct ElasticSection {
  SectionForce<S> stiffness;  ///< E I_x, E I_y, G J [N m^2], E A [N]

  struct State {};
};

/// @param has  what of the strain there is
template <class S, class Has = AllComponents>
inline SectionResponse<S> respond(const ElasticSection<S>& law,
                                  const typename ElasticSection<S>::State& /*before*/,
                                  typename ElasticSection<S>::State& /*after*/,
                                  const SectionStrain<S>& strain, Has /*has*/ = {}) {
  SectionResponse<S> now;
  now.elastic_energy = constant<S>(0);
  now.plastic_work = constant<S>(0);
  for_each_of<kSectionAxes>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
    if (!Has::has(i)) return;
    now.force[i] = law.stiffness[i] * strain[i];
    now.tangent(i, i) = law.stiffness[i];
    now.elastic_energy = now.elastic_energy + constant<S>(0.5) * now.force[i] * strain[i];
  });
  return now;
}

/// Wendelius' section: each component is a uniaxial law between the strain and the stress of its
/// extreme fibre, on its own (see `SectionForm`).
///
/// Work per length is force d(section strain) = (modulus/lever) stress d(strain of the fibre), so
/// energies of the uniaxial law count with modulus/lever, `area`.
/// @tparam Uniaxial  one of `UniaxialLaws`
template <class S, class Uniaxial>
struct PerAxisSection {
  std::array<Uniaxial, kSectionAxes> axis;
  std::array<S, kSectionAxes> lever;
  std::array<S, kSectionAxes> modulus;
  std::array<S, kSectionAxes> area;      ///< modulus/lever [m^2]
  std::array<S, kSectionAxes> softness;  ///< area/stiffness [m^2/Pa]

  /// Calls `use` with each uniaxial law.
  template <class Use>
  void each_uniaxial(const Use& use) {
    for (Uniaxial& law : axis) use(law);
  }

  struct State {
    std::array<typename Uniaxial::State, kSectionAxes> axis{};
  };
};

/// Whether the components of a law do not know of each other.
template <class Law>
inline constexpr bool kIsPerAxis = false;
template <class S, class Uniaxial>
inline constexpr bool kIsPerAxis<PerAxisSection<S, Uniaxial>> = true;

/// @param has  what of the strain there is
template <class S, class Uniaxial, class Has = AllComponents>
inline SectionResponse<S> respond(const PerAxisSection<S, Uniaxial>& law,
                                  const typename PerAxisSection<S, Uniaxial>::State& before,
                                  typename PerAxisSection<S, Uniaxial>::State& after,
                                  const SectionStrain<S>& strain, Has /*has*/ = {}) {
  SectionResponse<S> now;
  now.elastic_energy = constant<S>(0);
  now.plastic_work = constant<S>(0);
  for_each_of<kSectionAxes>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
    if (!Has::has(i)) return;
    const auto fibre = respond(law.axis[i], before.axis[i], S(law.lever[i] * strain[i]));
    now.force[i] = law.modulus[i] * fibre.stress;
    now.tangent(i, i) = law.modulus[i] * law.lever[i] * fibre.tangent;
    now.elastic_energy += constant<S>(0.5) * law.softness[i] * fibre.stress * fibre.stress;
    now.plastic_work += law.area[i] * plastic_work(law.axis[i], before.axis[i], fibre);
    after.axis[i] = fibre.state;
  });
  return now;
}

/// @param material  numbers of `material_values`, of which some may carry derivatives
template <class S>
inline ElasticSection<S> elastic_section(const SectionForm& form,
                                         const MaterialValues<S>& material) {
  ElasticSection<S> law;
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    law.stiffness[i] = uniaxial_material(form.axis[i], material).stiffness *
                       constant<S>(form.lever[i] * form.modulus[i]);
  }
  return law;
}

/// @tparam Uniaxial  see PerAxisSection
template <class Uniaxial, class S>
inline PerAxisSection<S, Uniaxial> per_axis_section(const SectionForm& form,
                                                    const MaterialValues<S>& material) {
  PerAxisSection<S, Uniaxial> law;
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    law.axis[i] = Uniaxial::of(uniaxial_material(form.axis[i], material), material);
    law.lever[i] = constant<S>(form.lever[i]);
    law.modulus[i] = constant<S>(form.modulus[i]);
    law.area[i] = law.modulus[i] / law.lever[i];
    law.softness[i] = law.area[i] / law.axis[i].stiffness;
  }
  return law;
}

}  // namespace plastica::law
