#include "plastica/theory/uniaxial.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace plastica::theory {

double ideal_plastic_stress(double strain, double youngs_modulus, double yield_stress) {
  return std::clamp(youngs_modulus * strain, -yield_stress, yield_stress);
}

double ideal_plastic_unloading_stress(double strain, double turning_strain, double youngs_modulus,
                                      double yield_stress) {
  const double turning_stress = ideal_plastic_stress(turning_strain, youngs_modulus, yield_stress);
  return std::clamp(turning_stress + youngs_modulus * (strain - turning_strain), -yield_stress,
                    yield_stress);
}

double ideal_plastic_permanent_strain(double strain, double youngs_modulus, double yield_stress) {
  return strain - ideal_plastic_stress(strain, youngs_modulus, yield_stress) / youngs_modulus;
}

double bilinear_stress(double strain, double youngs_modulus, double yield_stress,
                       double tangent_modulus) {
  const double elastic = ideal_plastic_stress(strain, youngs_modulus, yield_stress);
  return elastic + tangent_modulus * (strain - elastic / youngs_modulus);
}

double voce_yield_stress(double accumulated_strain, double yield_stress, double saturation_stress,
                         double saturation_rate) {
  return yield_stress - saturation_stress * std::expm1(-saturation_rate * accumulated_strain);
}

double backstress(double start, double increment, double modulus, double rate) {
  if (rate == 0.0) return start + modulus * increment;
  const double decay = std::expm1(-rate * std::abs(increment));
  return start + decay * (start - std::copysign(modulus / rate, increment));
}

double stabilized_backstress(double plastic_amplitude, double modulus, double rate) {
  if (rate == 0.0) return modulus * plastic_amplitude;
  return modulus / rate * std::tanh(rate * plastic_amplitude);
}

double monotonic_stress(double plastic_strain, const Material& material) {
  const Hardening& h = material.hardening;
  switch (h.law) {
    case HardeningLaw::Ideal: break;
    case HardeningLaw::Linear:
      return material.yield_stress +
             plastic_modulus(material.youngs_modulus, h.tangent_modulus) * plastic_strain;
    case HardeningLaw::VoceChaboche: {
      double stress = voce_yield_stress(plastic_strain, material.yield_stress, h.saturation_stress,
                                        h.saturation_rate);
      for (std::size_t i = 0; i < h.backstress_modulus.size(); ++i) {
        stress += backstress(0.0, plastic_strain, h.backstress_modulus[i], h.backstress_rate[i]);
      }
      return stress;
    }
  }
  return material.yield_stress;
}

}  // namespace plastica::theory
