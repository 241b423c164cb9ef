#include "plastica/theory/uniaxial.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "plastica/base/domain.hpp"
#include "plastica/model/hardening_kind.hpp"

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
  require_domain(plastic_strain >= 0.0, "plastic_strain >= 0");
  return hardening_kind(material.hardening.law).monotonic_stress(plastic_strain, material);
}

double tension_stress(double strain, const Material& material) {
  require_domain(strain >= 0.0 && std::isfinite(strain), "a finite strain >= 0");
  const double E = material.youngs_modulus;
  if (strain <= material.yield_stress / E) return E * strain;
  double low = 0.0;
  double high = strain;
  while (true) {
    const double plastic = 0.5 * (low + high);
    if (plastic <= low || plastic >= high) return monotonic_stress(plastic, material);
    (E * (strain - plastic) > monotonic_stress(plastic, material) ? low : high) = plastic;
  }
}

}  // namespace plastica::theory
