#include <array>
#include <numbers>

#include "plastica/model/check_value.hpp"
#include "plastica/model/section_fields.hpp"
#include "plastica/model/section_parts.hpp"

namespace plastica::model_detail {
namespace {

using std::numbers::pi;

double power4(double x) { return x * x * x * x; }

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

class Round : public SectionKind {
 public:
  SectionEdge edge() const final { return SectionEdge::Round; }
  std::string_view beyond_caps(bool /*fully_plastic*/) const final { return "41 %"; }
};

class Circle final : public Round {
 public:
  SectionShape shape() const override { return SectionShape::Circle; }
  std::string_view word() const override { return "circle"; }
  std::span<const Field> dimensions() const override {
    static constexpr std::array<Field, 1> kFields{kSectionRadius};
    return kFields;
  }
  std::string label(const Section& s) const override {
    return "circle, radius " + in_mm(s.radius) + " mm";
  }
  void check(const Section& s, const SourceLocation& where) const override {
    require_positive(s.radius, where, "section.radius");
  }
  SectionProperties properties(const Section& s, double nu) const override {
    return ring(s.radius, 0.0, nu);
  }
  bool in_report() const override { return true; }
};

class RoundTube final : public Round {
 public:
  SectionShape shape() const override { return SectionShape::RoundTube; }
  std::string_view word() const override { return "round_tube"; }
  std::span<const Field> dimensions() const override {
    static constexpr std::array<Field, 2> kFields{
        kSectionRadius, number<PLASTICA_REACH(scene.section.inner_radius)>(
                            "section.inner_radius", Dimension::Length, kPositive,
                            "inner radius r of a round tube, below R")};
    return kFields;
  }
  std::string label(const Section& s) const override {
    return "round tube, radius " + in_mm(s.radius) + " mm, inside " + in_mm(s.inner_radius) + " mm";
  }
  void check(const Section& s, const SourceLocation& where) const override {
    require_inside(s.inner_radius, s.radius, where, "section.inner_radius", "section.radius");
    require_positive(s.radius, where, "section.radius");
  }
  SectionProperties properties(const Section& s, double nu) const override {
    SectionProperties p = ring(s.radius, s.inner_radius, nu);
    const double wall = s.radius - s.inner_radius;
    const double middle = (s.radius + s.inner_radius) / 2.0;
    p.bredt_torsion_constant = 2.0 * pi * middle * middle * middle * wall;
    p.bredt_torsion_modulus = 2.0 * pi * middle * middle * wall;
    return p;
  }
  double hole_radius(const Section& s) const override { return s.inner_radius; }
  std::vector<SectionWall> walls(const Section& s) const override {
    return {{SectionWall::Kind::Round, 2.0 * s.radius / (s.radius - s.inner_radius), {true, true}}};
  }
};

}  // namespace

const SectionKind& circle_kind() {
  static const Circle kind;
  return kind;
}

const SectionKind& round_tube_kind() {
  static const RoundTube kind;
  return kind;
}

}  // namespace plastica::model_detail
