#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "plastica/chain/joint_numbers.hpp"
#include "plastica/law/per_axis.hpp"

namespace plastica {

/// The joints of a chain with the law that its scene names.
///
/// @param materials  numbers of each part (parts)
template <class L, bool kElastic>
std::unique_ptr<chain::SectionJointsBase<L, kElastic>> make_joints(
    const Scene& scene, const std::vector<chain::PartForm>& parts,
    const std::vector<MaterialValues<typename L::Scalar>>& materials,
    std::vector<chain::SectionJoint<L>> joints, const chain::View<L>& view) {
  using S = typename L::Scalar;
  std::unique_ptr<chain::SectionJointsBase<L, kElastic>> made;
  /// @param law_of  from a part's form and material to its law
  const auto make = [&](const auto& law_of) {
    using Law = std::remove_cvref_t<decltype(law_of(parts[0], materials[0]))>;
    std::vector<Law> laws;
    laws.reserve(parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p) laws.push_back(law_of(parts[p], materials[p]));
    made = std::make_unique<chain::SectionJoints<L, kElastic, Law>>(
        view.section_axes(), std::move(laws), std::move(joints));
  };
  const auto elastic = [](const chain::PartForm& part, const MaterialValues<S>& material) {
    return law::elastic_section(part.form, material);
  };
  switch (scene.yield_model) {
    case YieldModel::Elastic: make(elastic); break;
    default:
      law::with_law_type<S>(scene.material.hardening.law, [&](auto tag) {
        make([](const chain::PartForm& part, const MaterialValues<S>& material) {
          return law::per_axis_section<typename decltype(tag)::type>(part.form, material);
        });
      });
      break;
  }
  return made;
}

}  // namespace plastica
