#include <array>
#include <cmath>

#include "plastica/model/check_value.hpp"
#include "plastica/model/section_fields.hpp"
#include "plastica/model/section_parts.hpp"

namespace plastica::model_detail {
namespace {

/// Published numbers have three digits or more.
constexpr double kRounded = 1.005;

class ByNumbers final : public SectionKind {
 public:
  SectionShape shape() const override { return SectionShape::Numbers; }
  std::string_view word() const override { return "numbers"; }
  std::span<const Field> dimensions() const override {
    using enum Dimension;
    static constexpr std::array<Field, 10> kFields{
        number<PLASTICA_REACH(scene.section.numbers.area)>("section.area", Area, kNotNegative,
                                                           "numbers: A"),
        number<PLASTICA_REACH(scene.section.numbers.second_moment_x)>(
            "section.second_moment_x", SecondMoment, kNotNegative, "numbers: I_x"),
        number<PLASTICA_REACH(scene.section.numbers.second_moment_y)>(
            "section.second_moment_y", SecondMoment, kNotNegative, "numbers: I_y"),
        number<PLASTICA_REACH(scene.section.numbers.section_modulus_x)>(
            "section.section_modulus_x", SectionModulus, kNotNegative,
            "numbers: W_x, at first yield"),
        number<PLASTICA_REACH(scene.section.numbers.section_modulus_y)>(
            "section.section_modulus_y", SectionModulus, kNotNegative,
            "numbers: W_y, at first yield"),
        number<PLASTICA_REACH(scene.section.numbers.plastic_section_modulus_x)>(
            "section.plastic_section_modulus_x", SectionModulus, kNotNegative,
            "numbers: Z_x, when all yields"),
        number<PLASTICA_REACH(scene.section.numbers.plastic_section_modulus_y)>(
            "section.plastic_section_modulus_y", SectionModulus, kNotNegative,
            "numbers: Z_y, when all yields"),
        number<PLASTICA_REACH(scene.section.numbers.torsion_constant)>(
            "section.torsion_constant", SecondMoment, kNotNegative, "numbers: J"),
        number<PLASTICA_REACH(scene.section.numbers.torsion_modulus)>(
            "section.torsion_modulus", SectionModulus, kNotNegative,
            "numbers: W_t, torque over shear stress at first yield"),
        number<PLASTICA_REACH(scene.section.numbers.plastic_torsion_modulus)>(
            "section.plastic_torsion_modulus", SectionModulus, kNotNegative,
            "numbers: torque over shear stress when all yields")};
    return kFields;
  }
  bool needs(const Field& /*dimension*/) const override { return true; }
  std::string label(const Section& s) const override {
    return "given by its numbers, A " + number_text(1e6 * s.numbers.area) + " mm^2, I_x " +
           number_text(1e12 * s.numbers.second_moment_x) + " mm^4, I_y " +
           number_text(1e12 * s.numbers.second_moment_y) + " mm^4";
  }
  void check(const Section& s, const SourceLocation& where) const override {
    Setup setup;
    setup.scene.section = s;
    for (const Field& field : dimensions()) {
      require_positive(std::get<double>(field.get(setup)), where, field.path);
    }
    const SectionNumbers& n = s.numbers;
    const auto no_less = [&](double plastic, double elastic, std::string_view field) {
      require(plastic >= elastic, where, field, plastic,
              "must be no less than that at first yield, " + number_text(elastic));
    };
    no_less(n.plastic_section_modulus_x, n.section_modulus_x, "section.plastic_section_modulus_x");
    no_less(n.plastic_section_modulus_y, n.section_modulus_y, "section.plastic_section_modulus_y");
    no_less(n.plastic_torsion_modulus, n.torsion_modulus, "section.plastic_torsion_modulus");
    // A thin wall around the outside has the largest I of an area: I <= A (I/W)^2.
    const auto fits = [&](double moment, double modulus, std::string_view field) {
      const double lever = moment / modulus;
      require(moment <= (1.0 + 1e-9) * n.area * lever * lever, where, field, moment,
              "is more than an area of " + number_text(n.area) +
                  " m^2 has within I/W = " + number_text(lever) + " m of its axis");
    };
    fits(n.second_moment_x, n.section_modulus_x, "section.second_moment_x");
    fits(n.second_moment_y, n.section_modulus_y, "section.second_moment_y");
    // Z is the integral of |y|: Z^2 <= A I (Cauchy and Schwarz).
    const auto leaves = [&](double plastic, double moment, std::string_view field) {
      const double most = std::sqrt(n.area * moment);
      require(plastic <= kRounded * most, where, field, plastic,
              "is more than sqrt(A I) = " + number_text(most) +
                  " m^3, which no section of this area and second moment has");
    };
    leaves(n.plastic_section_modulus_x, n.second_moment_x, "section.plastic_section_modulus_x");
    leaves(n.plastic_section_modulus_y, n.second_moment_y, "section.plastic_section_modulus_y");
    // Warping makes a section softer than one that stays plane, whose J is the polar moment.
    const double polar = n.second_moment_x + n.second_moment_y;
    require(n.torsion_constant <= kRounded * polar, where, "section.torsion_constant",
            n.torsion_constant,
            "is more than I_x + I_y = " + number_text(polar) + " m^4, which a round section has");
  }
  SectionProperties properties(const Section& s, double /*nu*/) const override {
    const SectionNumbers& n = s.numbers;
    SectionProperties p;
    p.area = n.area;
    p.second_moment_x = n.second_moment_x;
    p.second_moment_y = n.second_moment_y;
    set_bending(p, n.second_moment_y / n.section_modulus_y,
                n.second_moment_x / n.section_modulus_x);
    p.plastic_section_modulus_x = n.plastic_section_modulus_x;
    p.plastic_section_modulus_y = n.plastic_section_modulus_y;
    p.torsion_constant = n.torsion_constant;
    p.torsion_modulus = n.torsion_modulus;
    p.plastic_torsion_modulus = n.plastic_torsion_modulus;
    // Of the section, or none: `check_scene` refuses shear without it.
    p.shear_coefficient_x = p.shear_coefficient_y = 0.0;
    return p;
  }
  SectionWarping warping() const override { return SectionWarping::Unknown; }
};

}  // namespace

const SectionKind& numbers_kind() {
  static const ByNumbers kind;
  return kind;
}

}  // namespace plastica::model_detail
