#include "plastica/model/section.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "plastica/model/check_value.hpp"
#include "plastica/model/section_kind.hpp"
#include "plastica/model/section_parts.hpp"

namespace plastica {

using model_detail::require_positive;

std::span<const SectionKind* const> section_kinds() {
  using namespace model_detail;
  static const std::array<const SectionKind*, 6> kinds{&rectangle_kind(),  &circle_kind(),
                                                       &round_tube_kind(), &rectangular_tube_kind(),
                                                       &i_section_kind(),  &numbers_kind()};
  return kinds;
}

const SectionKind& section_kind(SectionShape shape) {
  for (const SectionKind* kind : section_kinds()) {
    if (kind->shape() == shape) return *kind;
  }
  throw InputError({}, "section.shape", std::to_string(static_cast<int>(shape)),
                   "is none of the shapes that there are");
}

SectionQuarter exchanged(SectionQuarter quarter) {
  for (SectionBlock& block : quarter.blocks) {
    std::swap(block.x_from, block.y_from);
    std::swap(block.x_to, block.y_to);
  }
  for (SectionSpot& spot : quarter.spots) std::swap(spot.x, spot.y);
  return quarter;
}

double SectionKind::twist_shear(const Section& /*section*/, const SectionProperties& /*properties*/,
                                const std::array<double, 2>& /*point*/) const {
  throw std::logic_error("a section without fibres has no shear stress at points");
}

void model_detail::set_bending(SectionProperties& p, double half_width, double half_height) {
  p.outer_distance_x = half_height;
  p.outer_distance_y = half_width;
  p.section_modulus_x = p.second_moment_x / half_height;
  p.section_modulus_y = p.second_moment_y / half_width;
}

std::string model_detail::in_mm(double length) { return rounded(1e3 * length, 4); }

std::string model_detail::sides_in_mm(double width, double height) {
  return in_mm(width) + " x " + in_mm(height) + " mm";
}

void model_detail::require_inside(double inner, double outer, const SourceLocation& where,
                                  std::string_view inner_field, std::string_view outer_field) {
  require_positive(inner, where, inner_field);
  require(inner < outer, where, inner_field, inner,
          "must be below " + std::string(outer_field) + " = " + number_text(outer));
}

SectionProperties section_properties(const Section& section, double poisson_ratio) {
  SectionProperties p = section_kind(section).properties(section, poisson_ratio);
  if (section.shear_coefficient) {
    p.shear_coefficient_x = p.shear_coefficient_y = *section.shear_coefficient;
  }
  return p;
}

void check_section(const Section& section, const SourceLocation& where) {
  section_kind(section).check(section, where);
  if (section.shear_coefficient) {
    require_positive(*section.shear_coefficient, where, "section.shear_coefficient");
  }
}

bool must_be_said(const SectionKind& kind, const Field& dimension) {
  const bool some =
      std::ranges::any_of(kind.dimensions(), [&](const Field& field) { return kind.needs(field); });
  return !some || kind.needs(dimension);
}

}  // namespace plastica
