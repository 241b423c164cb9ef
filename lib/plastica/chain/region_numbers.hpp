#pragma once

#include "plastica/chain/layout.hpp"
#include "plastica/law/per_axis.hpp"

namespace plastica::chain {

/// What a region of a beam resists its joints with, as the formulas of its scene have it.
template <class S>
struct RegionNumbers {
  law::SectionForce<S> stiffness;  ///< EI_x, EI_y, GJ [N m^2], EA [N]
  law::SectionForce<S> yield;      ///< at which each alone yields [N m], [N]
  S shear_modulus{};               ///< [Pa]
};

/// @param material  numbers of the region's material, some of which may be parameters
template <class S>
RegionNumbers<S> region_numbers(const BeamRegion& region, const MaterialValues<S>& material) {
  RegionNumbers<S> numbers;
  numbers.stiffness = law::elastic_section(region.form, material).stiffness;
  for (std::size_t k = 0; k < law::kSectionAxes; ++k) {
    numbers.yield[k] = constant<S>(region.form.modulus[k]) *
                       law::uniaxial_material(region.form.axis[k], material).yield;
  }
  const law::UniaxialForm& torsion = region.form.axis[law::kTorsion];
  numbers.shear_modulus =
      law::uniaxial_material(torsion, material).stiffness / constant<S>(torsion.stiffness_factor);
  return numbers;
}

}  // namespace plastica::chain
