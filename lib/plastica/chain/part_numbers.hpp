#pragma once

#include "plastica/chain/layout.hpp"
#include "plastica/law/per_axis.hpp"

namespace plastica::chain {

/// What a part of a beam resists its joints with, as the formulas of its scene have it.
template <class S>
struct PartNumbers {
  law::SectionForce<S> stiffness;  ///< EI_x, EI_y, GJ [N m^2], EA [N]
  law::SectionForce<S> yield;      ///< at which each alone yields [N m], [N]
  S shear_modulus{};               ///< [Pa]
};

/// @param material  numbers of the part's material, some of which may be parameters
template <class S>
PartNumbers<S> part_numbers(const BeamPart& part, const MaterialValues<S>& material) {
  PartNumbers<S> numbers;
  numbers.stiffness = law::elastic_section(part.form, material).stiffness;
  for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
    numbers.yield[k] = constant<S>(part.form.modulus[k]) *
                       law::uniaxial_material(part.form.axis[k], material).yield;
  }
  const law::UniaxialForm& torsion = part.form.axis[law::kTorsion];
  numbers.shear_modulus =
      law::uniaxial_material(torsion, material).stiffness / constant<S>(torsion.stiffness_factor);
  return numbers;
}

}  // namespace plastica::chain
