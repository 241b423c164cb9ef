#include "plastica/model/section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plastica/model/check_value.hpp"
#include "plastica/model/torsion.hpp"

namespace plastica {
namespace {

using model_detail::require_positive;
using std::numbers::pi;

double power4(double x) { return x * x * x * x; }

/// W and the outer distances follow from I and the half sides for every shape.
void set_bending(SectionProperties& p, double half_width, double half_height) {
  p.outer_distance_x = half_height;
  p.outer_distance_y = half_width;
  p.section_modulus_x = p.second_moment_x / half_height;
  p.section_modulus_y = p.second_moment_y / half_width;
}

SectionProperties rectangle(double b, double h, double nu) {
  SectionProperties p;
  p.area = b * h;
  p.second_moment_x = b * h * h * h / 12.0;
  p.second_moment_y = h * b * b * b / 12.0;
  set_bending(p, b / 2.0, h / 2.0);
  p.plastic_section_modulus_x = b * h * h / 4.0;
  p.plastic_section_modulus_y = h * b * b / 4.0;
  const double c = std::max(b, h);
  const double s = std::min(b, h);
  p.torsion_constant = saint_venant_beta(c / s) * c * s * s * s;
  p.torsion_modulus = saint_venant_alpha(c / s) * c * s * s;
  p.plastic_torsion_modulus = sand_heap_modulus_rectangle(b, h);
  p.shear_coefficient_x = p.shear_coefficient_y = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
  return p;
}

/// The solid circle is the round tube with r = 0.
SectionProperties ring(double R, double r, double nu) {
  SectionProperties p;
  p.area = pi * (R * R - r * r);
  p.second_moment_x = p.second_moment_y = pi * (power4(R) - power4(r)) / 4.0;
  set_bending(p, R, R);
  const double cubes = R * R * R - r * r * r;
  p.plastic_section_modulus_x = p.plastic_section_modulus_y = 4.0 * cubes / 3.0;
  p.torsion_constant = pi * (power4(R) - power4(r)) / 2.0;
  p.torsion_modulus = p.torsion_constant / R;
  p.plastic_torsion_modulus = 2.0 * pi * cubes / 3.0;
  const double m2 = r * r / (R * R);
  const double q = (1.0 + m2) * (1.0 + m2);
  p.shear_coefficient_x = p.shear_coefficient_y =
      6.0 * (1.0 + nu) * q / ((7.0 + 6.0 * nu) * q + (20.0 + 12.0 * nu) * m2);
  return p;
}

/// Cowper's kappa of a thin-walled box.
/// @param depth, web       middle-line length along the force and thickness of the walls along it
/// @param breadth, flange  the same of the walls across the force
double cowper_box(double depth, double web, double breadth, double flange, double nu) {
  const double m = breadth * flange / (depth * web);
  const double n = breadth / depth;
  const double top = 10.0 * (1.0 + nu) * (1.0 + 3.0 * m) * (1.0 + 3.0 * m);
  const double bottom = (12.0 + m * (72.0 + m * (150.0 + m * 90.0))) +
                        nu * (11.0 + m * (66.0 + m * (135.0 + m * 90.0))) +
                        10.0 * n * n * ((3.0 + nu) * m + 3.0 * m * m);
  return top / bottom;
}

SectionProperties rectangular_tube(const Section& s, double nu) {
  const double b = s.width, h = s.height, bi = s.inner_width, hi = s.inner_height;
  const BoxDimensions box{.width = b, .height = h, .inner_width = bi, .inner_height = hi};
  SectionProperties p;
  p.area = b * h - bi * hi;
  p.second_moment_x = (b * h * h * h - bi * hi * hi * hi) / 12.0;
  p.second_moment_y = (h * b * b * b - hi * bi * bi * bi) / 12.0;
  set_bending(p, b / 2.0, h / 2.0);
  p.plastic_section_modulus_x = (b * h * h - bi * hi * hi) / 4.0;
  p.plastic_section_modulus_y = (h * b * b - hi * bi * bi) / 4.0;
  const BoxTorsion torsion = box_torsion(box);
  p.torsion_constant = torsion.constant;
  p.torsion_modulus = torsion.modulus;
  p.plastic_torsion_modulus = sand_heap_modulus_box(box);
  const BoxTorsion bredt = bredt_box(box);
  p.bredt_torsion_constant = bredt.constant;
  p.bredt_torsion_modulus = bredt.modulus;
  const double side_wall = (b - bi) / 2.0, top_wall = (h - hi) / 2.0;
  const double middle_width = b - side_wall, middle_height = h - top_wall;
  p.shear_coefficient_y = cowper_box(middle_height, side_wall, middle_width, top_wall, nu);
  p.shear_coefficient_x = cowper_box(middle_width, top_wall, middle_height, side_wall, nu);
  return p;
}

SectionProperties shape_properties(const Section& s, double nu) {
  switch (s.shape) {
    case SectionShape::Rectangle: return rectangle(s.width, s.height, nu);
    case SectionShape::Circle: return ring(s.radius, 0.0, nu);
    case SectionShape::RoundTube: {
      SectionProperties p = ring(s.radius, s.inner_radius, nu);
      const double wall = s.radius - s.inner_radius;
      const double middle = (s.radius + s.inner_radius) / 2.0;
      p.bredt_torsion_constant = 2.0 * pi * middle * middle * middle * wall;
      p.bredt_torsion_modulus = 2.0 * pi * middle * middle * wall;
      return p;
    }
    case SectionShape::RectangularTube: return rectangular_tube(s, nu);
  }
  throw InputError({}, "section.shape", "",
                   "must be rectangle, circle, round_tube or rectangular_tube");
}

void require_inside(double inner, double outer, const SourceLocation& where,
                    std::string_view inner_field, std::string_view outer_field) {
  require_positive(inner, where, inner_field);
  model_detail::require(
      inner < outer, where, inner_field, inner,
      "must be below " + std::string(outer_field) + " = " + model_detail::number_text(outer));
}

}  // namespace

SectionProperties section_properties(const Section& section, double poisson_ratio) {
  SectionProperties p = shape_properties(section, poisson_ratio);
  if (section.shear_coefficient) {
    p.shear_coefficient_x = p.shear_coefficient_y = *section.shear_coefficient;
  }
  return p;
}

void check_section(const Section& s, const SourceLocation& where) {
  switch (s.shape) {
    case SectionShape::RectangularTube:
      require_inside(s.inner_width, s.width, where, "section.inner_width", "section.width");
      require_inside(s.inner_height, s.height, where, "section.inner_height", "section.height");
      [[fallthrough]];
    case SectionShape::Rectangle:
      require_positive(s.width, where, "section.width");
      require_positive(s.height, where, "section.height");
      break;
    case SectionShape::RoundTube:
      require_inside(s.inner_radius, s.radius, where, "section.inner_radius", "section.radius");
      [[fallthrough]];
    case SectionShape::Circle: require_positive(s.radius, where, "section.radius"); break;
  }
  if (s.shear_coefficient) {
    require_positive(*s.shear_coefficient, where, "section.shear_coefficient");
  }
}

}  // namespace plastica
