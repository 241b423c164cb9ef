#include "plastica/model/material.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "plastica/model/check_value.hpp"
#include "plastica/model/hardening_kind.hpp"
#include "plastica/model/material_field.hpp"
#include "plastica/model/rate_kind.hpp"

namespace plastica {
namespace {

using model_detail::require;
using model_detail::require_positive;

void check_rate(const Material& material, const SourceLocation& where) {
  Setup setup;
  setup.scene.material = material;
  const RateKind& kind = rate_kind(material.rate.law);
  for (const Field& field : kind.parameters()) {
    const FieldValue value = field.get(setup);
    if (const double* number = std::get_if<double>(&value)) {
      check_field(field, *number, where);
    } else if (RateKind::needs(field)) {
      throw InputError(
          where, field.path, "",
          "is missing: material.rate.law = \"" + std::string(kind.word()) + "\" needs it");
    }
  }
}

void check_hardening(const Material& material, const SourceLocation& where) {
  const HardeningKind& kind = hardening_kind(material.hardening.law);
  Setup setup;
  setup.scene.material = material;
  for (const Field& field : kind.parameters()) {
    check_field(field, std::get<double>(field.get(setup)), where);
  }
  const MaterialValues<double> values = material_values(material);
  const auto broken = kind.broken_rule(values);
  if (!broken) return;
  for (const Field& field : kind.parameters()) {
    if (field.material != broken->field) continue;
    throw InputError(where, field.path,
                     model_detail::number_text(values[static_cast<std::size_t>(broken->field)]),
                     broken->rule);
  }
}

}  // namespace

bool has_own_rates(const Material& material) {
  return material.rate.law != RateLaw::None && !material.rate.strain_rate;
}

double resolved_shear_modulus(const Material& material) {
  return material.shear_modulus.value_or(material.youngs_modulus /
                                         (2.0 * (1.0 + material.poisson_ratio)));
}

std::string shown_name(const Material& material) {
  const Material usual;
  const bool is_usual = material.youngs_modulus == usual.youngs_modulus &&
                        material.yield_stress == usual.yield_stress;
  return material.name == usual.name && !is_usual ? std::string() : material.name;
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
  check_rate(material, where);
}

}  // namespace plastica
