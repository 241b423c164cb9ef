#include "plastica/law/section_form.hpp"

#include <algorithm>

#include "plastica/model/section_kind.hpp"

namespace plastica::law {
namespace {

/// Wendelius' factors on stiffness and cap.
void set_report(const Section& section, const SectionProperties& p, SectionForm& form) {
  form.axis[kBendingX].stiffness_factor = 0.5;
  form.axis[kBendingY].stiffness_factor = 0.5;
  form.axis[kTorsion].stiffness_factor =
      0.5 * std::max(p.second_moment_x, p.second_moment_y) / p.torsion_constant;
  if (section_kind(section).round()) return;
  const double b = section.width;
  const double h = section.height;
  form.axis[kBendingX].cap_factor = form.lever[kBendingX] / b;
  form.axis[kBendingY].cap_factor = form.lever[kBendingY] / h;
  form.axis[kTorsion].cap_factor =
      b * b * h * h / (3.0 * std::max(b, h) + 1.8 * std::min(b, h)) / p.torsion_modulus;
}

}  // namespace

SectionForm section_form(const Section& section, const SectionProperties& p,
                         const Material& material, YieldCap cap, Formulas formulas) {
  SectionForm form;
  form.modulus = {p.section_modulus_x, p.section_modulus_y, p.torsion_modulus, p.area};
  form.lever = {p.second_moment_x / p.section_modulus_x, p.second_moment_y / p.section_modulus_y,
                p.torsion_constant / p.torsion_modulus, 1.0};
  for (UniaxialForm& axis : form.axis) {
    axis.shear_modulus_given = material.shear_modulus.has_value();
    axis.shear_yield_given = material.shear_yield_stress.has_value();
    axis.formulas = formulas;
    axis.rate = material.rate.law;
    axis.strain_rate = material.rate.strain_rate.value_or(0.0);
  }
  form.axis[kTorsion].shear = true;
  if (formulas == Formulas::Report) {
    set_report(section, p, form);
  } else if (cap == YieldCap::FullyPlastic) {
    form.axis[kBendingX].cap_factor = p.plastic_section_modulus_x / p.section_modulus_x;
    form.axis[kBendingY].cap_factor = p.plastic_section_modulus_y / p.section_modulus_y;
    form.axis[kTorsion].cap_factor = p.plastic_torsion_modulus / p.torsion_modulus;
  }
  return form;
}

}  // namespace plastica::law
