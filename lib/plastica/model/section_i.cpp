#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "plastica/model/check_value.hpp"
#include "plastica/model/section_fields.hpp"
#include "plastica/model/section_parts.hpp"
#include "plastica/model/torsion.hpp"

namespace plastica::model_detail {
namespace {

using std::numbers::pi;

/// What a fillet adds in the corner of two lines: a square of side r without a quarter of a circle.
struct Fillet {
  double area;      ///< (1 - pi/4) r^2 [m^2]
  double distance;  ///< of its centroid from both lines [m]
  double spread;    ///< radius of gyration about the centroid, along either line [m]
};

Fillet fillet_of(double r) {
  const double fraction = 1.0 - pi / 4.0;
  const double distance = (10.0 - 3.0 * pi) / (12.0 - 3.0 * pi);
  // Of the square 1/3, less the quarter circle about its centre at (1, 1): pi/4 (1 + 1/4) - 2/3.
  const double about_line = 1.0 / 3.0 - (5.0 * pi / 16.0 - 2.0 / 3.0);
  return {fraction * r * r, distance * r,
          std::sqrt(about_line / fraction - distance * distance) * r};
}

/// Where the web's side and the flange's inner side meet, in the quarter x, y > 0.
struct Corner {
  double x, y;
};

Corner corner_of(const Section& s) {
  return {0.5 * s.web_thickness, 0.5 * s.height - s.flange_thickness};
}

/// Sum of A x^2 or A y^2 of a quarter's fillet.
double fillet_moment(const Fillet& fillet, double distance) {
  return fillet.area * (distance * distance + fillet.spread * fillet.spread);
}

/// Volume of Nadai's sand heap over the fillet, and the web and flange beside it. The heap is as
/// high as the boundary is far; that of the open side is all points within r of what begins at the
/// fillet's centre.
double heap_of_junction(const Section& s) {
  constexpr int kPoints = 300;
  const Corner corner = corner_of(s);
  const double cx = corner.x + s.fillet_radius;
  const double cy = corner.y - s.fillet_radius;
  const double dx = cx / kPoints;
  const double dy = (0.5 * s.height - cy) / kPoints;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    for (int j = 0; j < kPoints; ++j) {
      const double x = (i + 0.5) * dx;
      const double y = cy + (j + 0.5) * dy;
      const double to_open = std::hypot(cx - x, y - cy) - s.fillet_radius;
      const double to_outside = std::min(0.5 * s.width - x, 0.5 * s.height - y);
      sum += std::max(std::min(to_open, to_outside), 0.0);
    }
  }
  return sum * dx * dy;
}

double sand_heap_modulus_i(const Section& s) {
  const Corner corner = corner_of(s);
  const double web = corner.x * corner.x / 2.0 * (corner.y - s.fillet_radius);
  const double t = s.flange_thickness;
  const double outstand = 0.5 * s.width - corner.x - s.fillet_radius;
  const double flange = t * t / 4.0 * outstand - t * t * t / 24.0;
  return 2.0 * 4.0 * (web + flange + heap_of_junction(s));
}

/// J: flanges and web as rectangles, and the circles that fit into the two junctions.
double torsion_constant_i(const Section& s) {
  const double tf = s.flange_thickness;
  const double tw = s.web_thickness;
  const double r = s.fillet_radius;
  const double wide = r + tw / 2.0;
  const double high = r + tf;
  const double circle = (wide * wide + high * high - r * r) / (2.0 * r + tf);
  const double fraction = tw / tf * (0.145 + 0.1 * r / tf);
  return 2.0 / 3.0 * (s.width - 0.63 * tf) * tf * tf * tf +
         (s.height - 2.0 * tf) * tw * tw * tw / 3.0 + 2.0 * fraction * std::pow(circle, 4);
}

/// Cowper's kappa of a thin-walled I-section, for a force along the web.
double cowper_i(const Section& s, double nu) {
  const double h = s.height - s.flange_thickness;
  const double m = 2.0 * s.width * s.flange_thickness / (h * s.web_thickness);
  const double n2 = s.width * s.width / (h * h);
  const double bottom = 12.0 + m * (72.0 + m * (150.0 + m * 90.0)) +
                        nu * (11.0 + m * (66.0 + m * (135.0 + m * 90.0))) +
                        30.0 * n2 * (m + m * m) + 5.0 * nu * n2 * (8.0 * m + 9.0 * m * m);
  return 10.0 * (1.0 + nu) * (1.0 + 3.0 * m) * (1.0 + 3.0 * m) / bottom;
}

class ISection final : public SectionKind {
 public:
  SectionShape shape() const override { return SectionShape::ISection; }
  std::string_view word() const override { return "i_section"; }
  std::span<const Field> dimensions() const override {
    static constexpr std::array<Field, 5> kFields{
        kSectionWidth, kSectionHeight,
        number<PLASTICA_REACH(scene.section.flange_thickness)>("section.flange_thickness",
                                                               Dimension::Length, kNotNegative,
                                                               "of both flanges of an I-section"),
        number<PLASTICA_REACH(scene.section.web_thickness)>(
            "section.web_thickness", Dimension::Length, kNotNegative,
            "of an I-section, whose web is along y"),
        number<PLASTICA_REACH(scene.section.fillet_radius)>(
            "section.fillet_radius", Dimension::Length, kNotNegative,
            "between flanges and web of an I-section; 0: none")};
    return kFields;
  }
  bool needs(const Field& dimension) const override {
    return dimension.path != "section.fillet_radius";
  }
  std::string label(const Section& s) const override {
    std::string text = "I-section, " + sides_in_mm(s.width, s.height) + ", flanges " +
                       in_mm(s.flange_thickness) + " mm, web " + in_mm(s.web_thickness) + " mm";
    if (s.fillet_radius > 0.0) text += ", fillets " + in_mm(s.fillet_radius) + " mm";
    return text;
  }
  void check(const Section& s, const SourceLocation& where) const override {
    require_positive(s.width, where, "section.width");
    require_positive(s.height, where, "section.height");
    require_positive(s.flange_thickness, where, "section.flange_thickness");
    require_positive(s.web_thickness, where, "section.web_thickness");
    require_not_negative(s.fillet_radius, where, "section.fillet_radius");
    const double r = s.fillet_radius;
    const std::string no_web =
        "leaves no web: flanges and fillets must be below section.height = " +
        number_text(s.height) + " together";
    require(s.flange_thickness < 0.5 * s.height, where, "section.flange_thickness",
            s.flange_thickness, no_web);
    require(s.flange_thickness + r < 0.5 * s.height, where, "section.fillet_radius", r, no_web);
    // The torsion is that of walls that are thin, or at least no thicker than they are wide.
    const double outstand = 0.5 * (s.width - s.web_thickness);
    const std::string too_small =
        "leaves no flange beyond the web and its fillets: section.width = " + number_text(s.width) +
        " is too small";
    require(outstand > 0.5 * s.flange_thickness, where, "section.web_thickness", s.web_thickness,
            too_small);
    require(outstand - r > 0.5 * s.flange_thickness, where, "section.fillet_radius", r, too_small);
  }
  SectionProperties properties(const Section& s, double nu) const override {
    const double b = s.width, h = s.height, tf = s.flange_thickness, tw = s.web_thickness;
    const double hw = h - 2.0 * tf;
    const Fillet fillet = fillet_of(s.fillet_radius);
    const Corner corner = corner_of(s);
    const double x = corner.x + fillet.distance;
    const double y = corner.y - fillet.distance;
    SectionProperties p;
    p.area = 2.0 * b * tf + hw * tw + 4.0 * fillet.area;
    p.second_moment_x =
        (b * h * h * h - (b - tw) * hw * hw * hw) / 12.0 + 4.0 * fillet_moment(fillet, y);
    p.second_moment_y =
        (2.0 * tf * b * b * b + hw * tw * tw * tw) / 12.0 + 4.0 * fillet_moment(fillet, x);
    set_bending(p, b / 2.0, h / 2.0);
    p.plastic_section_modulus_x = (b * h * h - (b - tw) * hw * hw) / 4.0 + 4.0 * fillet.area * y;
    p.plastic_section_modulus_y = (2.0 * tf * b * b + hw * tw * tw) / 4.0 + 4.0 * fillet.area * x;
    p.torsion_constant = torsion_constant_i(s);
    p.torsion_modulus = p.torsion_constant / std::max(tf, tw);
    p.plastic_torsion_modulus = sand_heap_modulus_i(s);
    p.shear_coefficient_y = cowper_i(s, nu);
    // The flanges alone, each a rectangle.
    p.shear_coefficient_x = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu) * 2.0 * b * tf / p.area;
    return p;
  }
  std::optional<SectionQuarter> quarter(const Section& s) const override {
    const Corner corner = corner_of(s);
    const double x = 0.5 * s.width;
    const double y = 0.5 * s.height;
    SectionQuarter quarter{
        {{0.0, corner.x, 0.0, corner.y}, {0.0, corner.x, corner.y, y}, {corner.x, x, corner.y, y}},
        {}};
    if (s.fillet_radius > 0.0) {
      const Fillet fillet = fillet_of(s.fillet_radius);
      // Four places keep area, first and second moments.
      for (const double to_x : {-fillet.spread, fillet.spread}) {
        for (const double to_y : {-fillet.spread, fillet.spread}) {
          quarter.spots.push_back({0.25 * fillet.area, corner.x + fillet.distance + to_x,
                                   corner.y - fillet.distance - to_y});
        }
      }
    }
    return quarter;
  }
  /// Of thin walls: twice the distance from the middle of the wall.
  double twist_shear(const Section& s, const SectionProperties& /*properties*/,
                     const std::array<double, 2>& point) const override {
    const Corner corner = corner_of(s);
    const auto [x, y] = point;
    if (std::fabs(y) >= corner.y) {
      return 2.0 * std::fabs(std::fabs(y) - 0.5 * (s.height - s.flange_thickness));
    }
    // A fillet has the largest there is.
    return std::fabs(x) > corner.x ? s.flange_thickness : 2.0 * std::fabs(x);
  }
  SectionWarping warping() const override { return SectionWarping::Much; }
  std::vector<SectionWall> walls(const Section& s) const override {
    const double r = s.fillet_radius;
    const double outstand = 0.5 * (s.width - s.web_thickness) - r;
    const double web = s.height - 2.0 * (s.flange_thickness + r);
    return {{SectionWall::Kind::Outstand, outstand / s.flange_thickness, {true, true}},
            {SectionWall::Kind::Internal, web / s.web_thickness, {false, false}}};
  }
};

}  // namespace

const SectionKind& i_section_kind() {
  static const ISection kind;
  return kind;
}

}  // namespace plastica::model_detail
