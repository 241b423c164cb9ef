#include "plastica/model/material_field.hpp"

namespace plastica {

MaterialValues<double> material_values(const Material& material) {
  const Hardening& h = material.hardening;
  return {material.youngs_modulus,
          material.poisson_ratio,
          material.shear_modulus.value_or(0.0),
          material.yield_stress,
          material.shear_yield_stress.value_or(0.0),
          material.break_strain.value_or(0.0),
          material.break_shear_strain.value_or(0.0),
          h.tangent_modulus,
          h.kinematic_share,
          h.saturation_stress,
          h.saturation_rate,
          h.backstress_modulus[0],
          h.backstress_modulus[1],
          h.backstress_modulus[2],
          h.backstress_rate[0],
          h.backstress_rate[1],
          h.backstress_rate[2]};
}

}  // namespace plastica
