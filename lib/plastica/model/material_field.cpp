#include "plastica/model/material_field.hpp"

#include <algorithm>
#include <cstddef>

namespace plastica {

MaterialValues<double> material_values(const Material& material) {
  const Hardening& h = material.hardening;
  MaterialValues<double> values{material.youngs_modulus,
                                material.poisson_ratio,
                                material.shear_modulus.value_or(0.0),
                                material.yield_stress,
                                material.shear_yield_stress.value_or(0.0),
                                material.break_strain.value_or(0.0),
                                material.break_shear_strain.value_or(0.0),
                                h.tangent_modulus,
                                h.kinematic_share,
                                h.saturation_stress,
                                h.saturation_rate};
  const auto copy = [&](const auto& numbers, MaterialField first) {
    std::copy(numbers.begin(), numbers.end(), values.begin() + static_cast<std::ptrdiff_t>(first));
  };
  copy(h.backstress_modulus, MaterialField::BackModulus1);
  copy(h.backstress_rate, MaterialField::BackRate1);
  copy(h.plastic_strain, MaterialField::PlasticStrain1);
  copy(h.flow_stress, MaterialField::FlowStress1);
  return values;
}

}  // namespace plastica
