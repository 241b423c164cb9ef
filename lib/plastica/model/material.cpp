#include "plastica/model/material.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "plastica/model/check_value.hpp"

namespace plastica {
namespace {

using model_detail::require;
using model_detail::require_not_negative;
using model_detail::require_positive;

void check_hardening(const Material& material, const SourceLocation& where) {
  const Hardening& h = material.hardening;
  switch (h.law) {
    case HardeningLaw::Ideal: return;
    case HardeningLaw::Linear:
      require(h.tangent_modulus >= 0.0 && h.tangent_modulus < material.youngs_modulus, where,
              "material.hardening.tangent_modulus", h.tangent_modulus,
              "must be at least zero and below material.youngs_modulus = " +
                  model_detail::number_text(material.youngs_modulus));
      require(h.kinematic_share >= 0.0 && h.kinematic_share <= 1.0, where,
              "material.hardening.kinematic_share", h.kinematic_share, "must be within 0 and 1");
      return;
    case HardeningLaw::VoceChaboche:
      require(std::isfinite(h.saturation_stress) && h.saturation_stress > -material.yield_stress,
              where, "material.hardening.saturation_stress", h.saturation_stress,
              "must be finite and above -material.yield_stress = " +
                  model_detail::number_text(-material.yield_stress));
      require_not_negative(h.saturation_rate, where, "material.hardening.saturation_rate");
      for (std::size_t i = 0; i < h.backstress_modulus.size(); ++i) {
        const std::string index = "_" + std::to_string(i + 1);
        require_not_negative(h.backstress_modulus[i], where,
                             "material.hardening.backstress_modulus" + index);
        require_not_negative(h.backstress_rate[i], where,
                             "material.hardening.backstress_rate" + index);
      }
      return;
  }
  throw InputError(where, "material.hardening.law", "", "must be ideal, linear or voce_chaboche");
}

}  // namespace

double resolved_shear_modulus(const Material& material) {
  return material.shear_modulus.value_or(material.youngs_modulus /
                                         (2.0 * (1.0 + material.poisson_ratio)));
}

double resolved_shear_yield_stress(const Material& material) {
  return material.shear_yield_stress.value_or(material.yield_stress / std::numbers::sqrt3);
}

std::optional<double> resolved_break_shear_strain(const Material& material) {
  if (material.break_shear_strain) return material.break_shear_strain;
  if (material.break_strain) return std::numbers::sqrt3 * *material.break_strain;
  return std::nullopt;
}

double plastic_modulus(double youngs_modulus, double tangent_modulus) {
  return youngs_modulus * tangent_modulus / (youngs_modulus - tangent_modulus);
}

void check_material(const Material& material, const SourceLocation& where) {
  require_positive(material.youngs_modulus, where, "material.youngs_modulus");
  require(material.poisson_ratio > -1.0 && material.poisson_ratio <= 0.5, where,
          "material.poisson_ratio", material.poisson_ratio, "must be above -1 and at most 0.5");
  if (material.shear_modulus)
    require_positive(*material.shear_modulus, where, "material.shear_modulus");
  require_positive(material.density, where, "material.density");
  require_positive(material.yield_stress, where, "material.yield_stress");
  if (material.shear_yield_stress)
    require_positive(*material.shear_yield_stress, where, "material.shear_yield_stress");
  if (material.break_strain)
    require_positive(*material.break_strain, where, "material.break_strain");
  if (material.break_shear_strain)
    require_positive(*material.break_shear_strain, where, "material.break_shear_strain");
  check_hardening(material, where);
}

}  // namespace plastica
