#include "plastica/coupon/shape.hpp"

#include <algorithm>

namespace plastica::coupon {
namespace {

bool is_round(SectionShape shape) {
  return shape == SectionShape::Circle || shape == SectionShape::RoundTube;
}

void set_bending(const Scene& scene, const SectionProperties& p, CouponShape& shape) {
  const bool round = is_round(scene.section.shape);
  shape.load_per_stress = p.section_modulus_x;
  shape.lever = p.second_moment_x / p.section_modulus_x;
  if (shape.formulas == Formulas::Report) {
    shape.stiffness_factor = 0.5;
    shape.report_lever = 2.0 * shape.lever;
    // sigma I_x / b against sigma I_x / (h/2).
    if (!round) shape.cap_factor = shape.lever / scene.section.width;
  } else if (scene.yield_cap == YieldCap::FullyPlastic) {
    shape.cap_factor = p.plastic_section_modulus_x / p.section_modulus_x;
  }
}

void set_torsion(const Scene& scene, const SectionProperties& p, CouponShape& shape) {
  const bool round = is_round(scene.section.shape);
  shape.load_per_stress = p.torsion_modulus;
  shape.lever = p.torsion_constant / p.torsion_modulus;
  if (shape.formulas == Formulas::Report) {
    const double b = scene.section.width;
    const double h = scene.section.height;
    const double longer = std::max(b, h);
    const double shorter = std::min(b, h);
    shape.stiffness_factor =
        0.5 * std::max(p.second_moment_x, p.second_moment_y) / p.torsion_constant;
    shape.report_lever = round ? shape.lever : 0.5 * longer;
    if (!round) {
      shape.cap_factor = b * b * h * h / (3.0 * longer + 1.8 * shorter) / p.torsion_modulus;
    }
  } else if (scene.yield_cap == YieldCap::FullyPlastic) {
    shape.cap_factor = p.plastic_torsion_modulus / p.torsion_modulus;
  }
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
  shape.shear_modulus_given = material.shear_modulus.has_value();
  shape.shear_yield_given = material.shear_yield_stress.has_value();
  shape.break_given = material.break_strain.has_value();
  shape.break_shear_given = material.break_shear_strain.has_value();

  const SectionProperties p = section_properties(scene.section, material.poisson_ratio);
  switch (shape.deformation) {
    case Deformation::Tension: shape.load_per_stress = p.area; break;
    case Deformation::Bending: set_bending(scene, p, shape); break;
    case Deformation::Torsion: set_torsion(scene, p, shape); break;
  }
  return shape;
}

}  // namespace plastica::coupon
