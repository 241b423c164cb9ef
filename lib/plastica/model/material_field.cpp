#include "plastica/model/material_field.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace plastica {

MaterialValues<double> material_values(const Material& material) {
  const Hardening& h = material.hardening;
  const RateDependence& rate = material.rate;
  MaterialValues<double> values{material.youngs_modulus,
                                material.poisson_ratio,
                                material.shear_modulus.value_or(0.0),
                                material.yield_stress,
                                material.shear_yield_stress.value_or(0.0),
                                material.break_strain.value_or(0.0),
                                material.break_shear_strain.value_or(0.0),
                                h.tangent_modulus,
                                h.kinematic_fraction,
                                h.saturation_stress,
                                h.saturation_rate};
  const auto copy = [&](const auto& numbers, MaterialField first) {
    std::copy(numbers.begin(), numbers.end(), values.begin() + static_cast<std::ptrdiff_t>(first));
  };
  copy(h.backstress_modulus, MaterialField::BackModulus1);
  copy(h.backstress_rate, MaterialField::BackRate1);
  copy(std::array{rate.reference_rate.value_or(0.0), rate.exponent.value_or(0.0),
                  rate.coefficient.value_or(0.0)},
       MaterialField::ReferenceRate);
  copy(h.plastic_strain, MaterialField::PlasticStrain1);
  copy(h.flow_stress, MaterialField::FlowStress1);
  return values;
}

}  // namespace plastica
