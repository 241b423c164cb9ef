#include <array>

#include "plastica/model/check_value.hpp"
#include "plastica/model/section_fields.hpp"
#include "plastica/model/section_parts.hpp"
#include "plastica/model/torsion.hpp"

namespace plastica::model_detail {
namespace {

BoxDimensions box_of(const Section& s) {
  return {.width = s.width,
          .height = s.height,
          .inner_width = s.inner_width,
          .inner_height = s.inner_height};
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

class RectangularTube final : public SectionKind {
 public:
  SectionShape shape() const override { return SectionShape::RectangularTube; }
  std::string_view word() const override { return "rectangular_tube"; }
  std::span<const Field> dimensions() const override {
    static constexpr std::array<Field, 4> kFields{
        kSectionWidth, kSectionHeight,
        number<PLASTICA_REACH(scene.section.inner_width)>("section.inner_width", Dimension::Length,
                                                          kPositive,
                                                          "width of a rectangular tube's hole"),
        number<PLASTICA_REACH(scene.section.inner_height)>("section.inner_height",
                                                           Dimension::Length, kPositive,
                                                           "height of a rectangular tube's hole")};
    return kFields;
  }
  std::string label(const Section& s) const override {
    return "rectangular tube, " + sides_in_mm(s.width, s.height) + ", inside " +
           sides_in_mm(s.inner_width, s.inner_height);
  }
  void check(const Section& s, const SourceLocation& where) const override {
    require_inside(s.inner_width, s.width, where, "section.inner_width", "section.width");
    require_inside(s.inner_height, s.height, where, "section.inner_height", "section.height");
    require_positive(s.width, where, "section.width");
    require_positive(s.height, where, "section.height");
  }
  SectionProperties properties(const Section& s, double nu) const override {
    const double b = s.width, h = s.height, bi = s.inner_width, hi = s.inner_height;
    SectionProperties p;
    p.area = b * h - bi * hi;
    p.second_moment_x = (b * h * h * h - bi * hi * hi * hi) / 12.0;
    p.second_moment_y = (h * b * b * b - hi * bi * bi * bi) / 12.0;
    set_bending(p, b / 2.0, h / 2.0);
    p.plastic_section_modulus_x = (b * h * h - bi * hi * hi) / 4.0;
    p.plastic_section_modulus_y = (h * b * b - hi * bi * bi) / 4.0;
    p.box = solved_box(box_of(s));
    p.torsion_constant = p.box->torsion.constant;
    p.torsion_modulus = p.box->torsion.modulus;
    p.plastic_torsion_modulus = p.box->plastic_modulus;
    const BoxTorsion bredt = bredt_box(box_of(s));
    p.bredt_torsion_constant = bredt.constant;
    p.bredt_torsion_modulus = bredt.modulus;
    const double side_wall = (b - bi) / 2.0, top_wall = (h - hi) / 2.0;
    const double middle_width = b - side_wall, middle_height = h - top_wall;
    p.shear_coefficient_y = cowper_box(middle_height, side_wall, middle_width, top_wall, nu);
    p.shear_coefficient_x = cowper_box(middle_width, top_wall, middle_height, side_wall, nu);
    return p;
  }
  std::optional<SectionQuarter> quarter(const Section& s) const override {
    const double x = 0.5 * s.width;
    const double y = 0.5 * s.height;
    const double xi = 0.5 * s.inner_width;
    const double yi = 0.5 * s.inner_height;
    return SectionQuarter{{{0.0, xi, yi, y}, {xi, x, 0.0, yi}, {xi, x, yi, y}}, {}};
  }
  double twist_shear(const Section& /*section*/, const SectionProperties& p,
                     const std::array<double, 2>& point) const override {
    return p.box->shear_at(point);
  }
  bool holds_plastic_block() const override { return true; }
  std::string_view beyond_caps(bool fully_plastic) const override {
    return fully_plastic ? "50 to 100 %" : "100 %";
  }
  std::vector<SectionWall> walls(const Section& s) const override {
    // Walls across y lie along x, and bending about x compresses one of them evenly.
    const double along_x = s.inner_width / (0.5 * (s.height - s.inner_height));
    const double along_y = s.inner_height / (0.5 * (s.width - s.inner_width));
    return {{SectionWall::Kind::Internal, along_x, {true, false}},
            {SectionWall::Kind::Internal, along_y, {false, true}}};
  }
};

}  // namespace

const SectionKind& rectangular_tube_kind() {
  static const RectangularTube kind;
  return kind;
}

}  // namespace plastica::model_detail
