#pragma once

#include <array>
#include <cstddef>

#include "plastica/law/section_form.hpp"
#include "plastica/model/material.hpp"
#include "plastica/model/section.hpp"

namespace plastica::law::testing {

/// Steel with each hardening law; its shear values are not those of an isotropic material, so that
/// no test leans on them.
inline Material steel(HardeningLaw law = HardeningLaw::Ideal) {
  Material material;
  material.youngs_modulus = 200e9;
  material.shear_modulus = 70e9;
  material.yield_stress = 300e6;
  material.shear_yield_stress = 150e6;
  material.hardening.law = law;
  material.hardening.tangent_modulus = 8e9;
  material.hardening.kinematic_fraction = 0.6;
  material.hardening.saturation_stress = 80e6;
  material.hardening.saturation_rate = 12.0;
  material.hardening.backstress_modulus = {20e9, 4e9, 0.5e9};
  material.hardening.backstress_rate = {300.0, 40.0, 0.0};
  material.hardening.plastic_strain = {0.002, 0.01, 0.04};
  material.hardening.flow_stress = {330e6, 320e6, 400e6};
  return material;
}

/// A rectangle of two to one, upright.
inline Section upright() { return {.width = 0.05, .height = 0.1}; }

inline SectionForm form_of(const Section& section, const Material& material,
                           YieldCap cap = YieldCap::FirstYield,
                           Formulas formulas = Formulas::Mechanics) {
  return section_form(section, section_properties(section, 0.3), material, cap, formulas);
}

/// The material's numbers as any scalar.
template <class S>
MaterialValues<S> values_of(const Material& material) {
  const MaterialValues<double> plain = material_values(material);
  MaterialValues<S> values;
  for (std::size_t i = 0; i < kMaterialFields; ++i) values[i] = constant<S>(plain[i]);
  return values;
}

template <class S>
SectionStrain<S> strain_of(const std::array<double, kSectionAxes>& plain) {
  SectionStrain<S> strain;
  for (std::size_t i = 0; i < kSectionAxes; ++i) strain[i] = constant<S>(plain[i]);
  return strain;
}

/// Section strain at which the extreme fibre of each component alone reaches the yield stress.
inline std::array<double, kSectionAxes> yield_strain(const SectionForm& form,
                                                     const Material& material) {
  std::array<double, kSectionAxes> strain{};
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    const auto m = uniaxial_material(form.axis[i], material_values(material));
    strain[i] = m.yield / m.stiffness / form.lever[i];
  }
  return strain;
}

/// Reproducible numbers in [-1, 1].
class Shaker {
 public:
  explicit Shaker(unsigned seed) : state_(seed) {}
  double operator()() {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<double>(state_ >> 8U) / 8388608.0 - 1.0;
  }

 private:
  unsigned state_;
};

}  // namespace plastica::law::testing
