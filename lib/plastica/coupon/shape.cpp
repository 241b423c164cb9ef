#include "plastica/coupon/shape.hpp"

#include <algorithm>

#include "plastica/law/section_form.hpp"
#include "plastica/model/section_kind.hpp"

namespace plastica::coupon {
namespace {

/// Takes one component of the section's form.
void take(const law::SectionForm& form, law::Axis axis, CouponShape& shape) {
  shape.load_per_stress = form.modulus[axis];
  shape.lever = form.lever[axis];
  shape.stiffness_factor = form.axis[axis].stiffness_factor;
  shape.cap_factor = form.axis[axis].cap_factor;
}

/// The lever of Wendelius' break strain: h in its (24), c/2 in its (8).
double report_lever(const Section& section, Deformation deformation, double lever) {
  if (deformation == Deformation::Bending) return 2.0 * lever;
  return section_kind(section).round() ? lever : 0.5 * std::max(section.width, section.height);
}

}  // namespace

CouponShape coupon_shape(const Scene& scene) {
  const Material& material = scene.material;
  CouponShape shape;
  shape.deformation = scene.drive.deformation;
  shape.hardening = material.hardening.law;
  shape.formulas = scene.formulas;
  shape.break_measure = scene.break_measure;
  shape.length = scene.beam.length / scene.beam.segments;
  shape.rate = material.rate.law;
  shape.strain_rate = material.rate.strain_rate.value_or(0.0);
  shape.shear_modulus_given = material.shear_modulus.has_value();
  shape.shear_yield_given = material.shear_yield_stress.has_value();
  shape.break_given = material.break_strain.has_value();
  shape.break_shear_given = material.break_shear_strain.has_value();

  const SectionProperties p = section_properties(scene.section, material.poisson_ratio);
  const law::SectionForm form =
      law::section_form(scene.section, p, material, scene.yield_cap, scene.formulas);
  switch (shape.deformation) {
    case Deformation::Tension: take(form, law::kAxial, shape); break;
    case Deformation::Bending: take(form, law::kBendingX, shape); break;
    case Deformation::Torsion: take(form, law::kTorsion, shape); break;
  }
  if (shape.formulas == Formulas::Report && shape.deformation != Deformation::Tension) {
    shape.report_lever = report_lever(scene.section, shape.deformation, shape.lever);
  }
  return shape;
}

}  // namespace plastica::coupon
