#include <algorithm>
#include <array>

#include "plastica/model/check_value.hpp"
#include "plastica/model/section_fields.hpp"
#include "plastica/model/section_parts.hpp"
#include "plastica/model/torsion.hpp"

namespace plastica::model_detail {
namespace {

class Rectangle final : public SectionKind {
 public:
  SectionShape shape() const override { return SectionShape::Rectangle; }
  std::string_view word() const override { return "rectangle"; }
  std::span<const Field> dimensions() const override {
    static constexpr std::array<Field, 2> kFields{kSectionWidth, kSectionHeight};
    return kFields;
  }
  std::string label(const Section& s) const override {
    return "rectangle, " + sides_in_mm(s.width, s.height);
  }
  void check(const Section& s, const SourceLocation& where) const override {
    require_positive(s.width, where, "section.width");
    require_positive(s.height, where, "section.height");
  }
  SectionProperties properties(const Section& s, double nu) const override {
    const double b = s.width;
    const double h = s.height;
    SectionProperties p;
    p.area = b * h;
    p.second_moment_x = b * h * h * h / 12.0;
    p.second_moment_y = h * b * b * b / 12.0;
    set_bending(p, b / 2.0, h / 2.0);
    p.plastic_section_modulus_x = b * h * h / 4.0;
    p.plastic_section_modulus_y = h * b * b / 4.0;
    const double longer = std::max(b, h);
    const double shorter = std::min(b, h);
    const double ratio = longer / shorter;
    p.torsion_constant = saint_venant_beta(ratio) * longer * shorter * shorter * shorter;
    p.torsion_modulus = saint_venant_alpha(ratio) * longer * shorter * shorter;
    p.plastic_torsion_modulus = sand_heap_modulus_rectangle(b, h);
    p.shear_coefficient_x = p.shear_coefficient_y = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
    return p;
  }
  SectionEdge edge() const override { return SectionEdge::Rectangle; }
  std::optional<SectionQuarter> quarter(const Section& s) const override {
    return SectionQuarter{{{0.0, 0.5 * s.width, 0.0, 0.5 * s.height}}, {}};
  }
  double twist_shear(const Section& s, const SectionProperties& /*properties*/,
                     const std::array<double, 2>& point) const override {
    return saint_venant_shear(s.width, s.height, point[0], point[1]);
  }
  bool holds_plastic_block() const override { return true; }
  std::string_view beyond_caps(bool fully_plastic) const override {
    return fully_plastic ? "50 %" : "100 %";
  }
  bool in_report() const override { return true; }
};

}  // namespace

const SectionKind& rectangle_kind() {
  static const Rectangle kind;
  return kind;
}

}  // namespace plastica::model_detail
