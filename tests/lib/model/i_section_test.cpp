#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "plastica/model/profile_table.hpp"
#include "plastica/model/section_kind.hpp"
#include "tests/reference/reference_table.hpp"

// I-sections against published tables, and against sums over a fine grid that know the outline
// alone.

namespace plastica {
namespace {

/// Half a unit in the last digit that a table prints, of four significant ones beyond 10^4.
double last_digit(const std::string& text) {
  const std::size_t dot = text.find('.');
  if (dot != std::string::npos) {
    return std::pow(10.0, -static_cast<double>(text.size() - dot - 1));
  }
  return std::pow(10.0, std::max(static_cast<double>(text.size()) - 4.0, 0.0));
}

TEST(Profiles, HaveThePublishedProperties) {
  const testing::ReferenceTable table("european-sections/published.csv");
  ASSERT_EQ(table.rows(), profile_table().size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text("name", row);
    SCOPED_TRACE(name);
    const Section& section = named_profile(name);
    check_section(section);
    const SectionProperties p = section_properties(section, 0.3);
    // Tables round up, down or off: one unit of the last digit.
    const auto expect = [&](const std::string& column, double value) {
      EXPECT_NEAR(value, table.at(column, row), 1.0001 * last_digit(table.text(column, row)))
          << column;
    };
    expect("A_cm2", 1e4 * p.area);
    expect("I_y_cm4", 1e8 * p.second_moment_x);
    expect("W_el_y_cm3", 1e6 * p.section_modulus_x);
    expect("W_pl_y_cm3", 1e6 * p.plastic_section_modulus_x);
    expect("I_z_cm4", 1e8 * p.second_moment_y);
    expect("W_el_z_cm3", 1e6 * p.section_modulus_y);
    expect("W_pl_z_cm3", 1e6 * p.plastic_section_modulus_y);
    const double published = table.at("I_T_cm4", row);
    EXPECT_NEAR(1e8 * p.torsion_constant, published,
                std::max(0.002 * published, last_digit(table.text("I_T_cm4", row))));
    // What torsion at first yield and beyond must fulfil, and fibres need.
    EXPECT_GT(p.plastic_torsion_modulus, p.torsion_modulus);
    EXPECT_LT(p.plastic_torsion_modulus, std::sqrt(p.torsion_constant * p.area));
  }
}

TEST(Profiles, AreFoundHoweverTheyAreWritten) {
  EXPECT_EQ(named_profile("IPE 200").name, "IPE 200");
  EXPECT_EQ(named_profile("ipe200").name, "IPE 200");
  EXPECT_EQ(named_profile("HE 300 A").name, "HEA 300");
  EXPECT_EQ(named_profile("HE1000B").name, "HEB 1000");
  EXPECT_THROW(named_profile("IPE 210"), InputError);
  EXPECT_THROW(named_profile("HE 300"), InputError);
}

/// Whether a point of the quarter x, y > 0 is in the section.
bool inside(const Section& s, double x, double y) {
  if (x > 0.5 * s.width || y > 0.5 * s.height) return false;
  const double wx = 0.5 * s.web_thickness;
  const double fy = 0.5 * s.height - s.flange_thickness;
  if (x <= wx || y >= fy) return true;
  const double r = s.fillet_radius;
  return x < wx + r && y > fy - r && std::hypot(wx + r - x, y - (fy - r)) >= r;
}

TEST(ISection, HasTheIntegralsOfItsOutline) {
  Section s;
  s.shape = SectionShape::ISection;
  s.width = 0.08;
  s.height = 0.1;
  s.flange_thickness = 0.009;
  s.web_thickness = 0.006;
  s.fillet_radius = 0.014;
  constexpr int kPoints = 2000;
  double area = 0.0, ix = 0.0, iy = 0.0, zx = 0.0, zy = 0.0;
  const double dx = 0.5 * s.width / kPoints;
  const double dy = 0.5 * s.height / kPoints;
  for (int i = 0; i < kPoints; ++i) {
    for (int j = 0; j < kPoints; ++j) {
      const double x = (i + 0.5) * dx;
      const double y = (j + 0.5) * dy;
      if (!inside(s, x, y)) continue;
      const double cell = 4.0 * dx * dy;
      area += cell;
      ix += cell * y * y;
      iy += cell * x * x;
      zx += cell * y;
      zy += cell * x;
    }
  }
  const SectionProperties p = section_properties(s, 0.3);
  EXPECT_NEAR(p.area / area, 1.0, 3e-4);
  EXPECT_NEAR(p.second_moment_x / ix, 1.0, 3e-4);
  EXPECT_NEAR(p.second_moment_y / iy, 1.0, 3e-4);
  EXPECT_NEAR(p.plastic_section_modulus_x / zx, 1.0, 3e-4);
  EXPECT_NEAR(p.plastic_section_modulus_y / zy, 1.0, 3e-4);
  EXPECT_DOUBLE_EQ(p.section_modulus_x, p.second_moment_x / 0.05);
}

/// Nadai's heap of two flanges and a web that meet without fillets, each counted alone, misses the
/// junctions: the web's heap goes on a little into the flanges.
TEST(ISection, HasASandHeapLittleAboveThatOfItsPlates) {
  Section s;
  s.shape = SectionShape::ISection;
  s.width = 0.1;
  s.height = 0.2;
  s.flange_thickness = 0.004;
  s.web_thickness = 0.003;
  const auto plate = [](double b, double t) { return t * t * (3.0 * b - t) / 6.0; };
  const double plates = 2.0 * plate(0.1, 0.004) + 0.5 * 0.003 * 0.003 * 0.192;
  const double heap = section_properties(s, 0.3).plastic_torsion_modulus;
  EXPECT_GT(heap, plates);
  EXPECT_LT(heap, 1.02 * plates);
}

/// The energy of the shear flow: kappa = I^2/(A integral of S^2/t ds) with nu = 0, where Cowper's
/// value is that.
TEST(ISection, ShearsAsItsShearFlowSays) {
  const Section& s = named_profile("IPE 300");
  Section sharp = s;
  sharp.fillet_radius = 0.0;
  const double h = s.height - s.flange_thickness;  // between the flanges' middles
  const double b = s.width, tf = s.flange_thickness, tw = s.web_thickness;
  const double inertia = 2.0 * b * tf * h * h / 4.0 + tw * h * h * h / 12.0;
  const double area = 2.0 * b * tf + h * tw;
  constexpr int kPoints = 20000;
  double energy = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    // Four half flanges, from the tip: S = tf u h/2; the web: S = b tf h/2 + tw (h^2/4 - y^2)/2.
    const double u = 0.5 * b * (i + 0.5) / kPoints;
    const double flange = tf * u * h / 2.0;
    energy += 4.0 * flange * flange / tf * 0.5 * b / kPoints;
    const double y = h * ((i + 0.5) / kPoints - 0.5);
    const double web = b * tf * h / 2.0 + tw * (h * h / 4.0 - y * y) / 2.0;
    energy += web * web / tw * h / kPoints;
  }
  const double kappa_area = inertia * inertia / energy;
  const SectionProperties p = section_properties(sharp, 0.0);
  // Cowper's coefficient is of the area between the middles.
  EXPECT_NEAR(p.shear_coefficient_y * area / kappa_area, 1.0, 1e-6);
  EXPECT_NEAR(p.shear_coefficient_x * p.area, 5.0 / 6.0 * 2.0 * b * tf, 1e-12);
}

bool refused(const Section& section, const std::string& text) {
  try {
    check_section(section);
  } catch (const InputError& error) {
    return std::string(error.what()).find(text) != std::string::npos;
  }
  return false;
}

TEST(ISection, IsRefusedIfItIsNone) {
  Section s = named_profile("IPE 100");
  Section thick = s;
  thick.flange_thickness = 0.049;
  EXPECT_TRUE(refused(thick, "leaves no web"));
  Section wide = s;
  wide.web_thickness = 0.05;
  EXPECT_TRUE(refused(wide, "leaves no flange"));
  Section round = s;
  round.fillet_radius = 0.06;
  EXPECT_TRUE(refused(round, "section.fillet_radius = 0.06: leaves no"));
  Section none = s;
  none.web_thickness = 0.0;
  EXPECT_TRUE(refused(none, "section.web_thickness = 0: must be positive"));
}

TEST(SectionNumbers, AreTakenAsTheyAreAndChecked) {
  const SectionProperties i = section_properties(named_profile("HEB 200"), 0.3);
  Section s;
  s.shape = SectionShape::Numbers;
  s.numbers = {.area = i.area,
               .second_moment_x = i.second_moment_x,
               .second_moment_y = i.second_moment_y,
               .section_modulus_x = i.section_modulus_x,
               .section_modulus_y = i.section_modulus_y,
               .plastic_section_modulus_x = i.plastic_section_modulus_x,
               .plastic_section_modulus_y = i.plastic_section_modulus_y,
               .torsion_constant = i.torsion_constant,
               .torsion_modulus = i.torsion_modulus,
               .plastic_torsion_modulus = i.plastic_torsion_modulus};
  check_section(s);
  const SectionProperties p = section_properties(s, 0.3);
  EXPECT_NEAR(p.outer_distance_x, 0.1, 1e-12);
  EXPECT_EQ(p.torsion_constant, i.torsion_constant);
  Section mistyped = s;
  mistyped.numbers.section_modulus_x *= 10.0;  // too near to its area for so large an I_x
  EXPECT_THROW(check_section(mistyped), InputError);
  Section weak = s;
  weak.numbers.plastic_section_modulus_y = 0.9 * weak.numbers.section_modulus_y;
  EXPECT_THROW(check_section(weak), InputError);
  Section stiff = s;
  stiff.numbers.torsion_constant = 1.01 * (i.second_moment_x + i.second_moment_y);
  EXPECT_TRUE(refused(stiff, "section.torsion_constant = "));
  Section strong = s;
  strong.numbers.plastic_section_modulus_x = 1.01 * std::sqrt(i.area * i.second_moment_x);
  EXPECT_TRUE(refused(strong, "section.plastic_section_modulus_x = "));
  Section lacking = s;
  lacking.numbers.torsion_constant = 0.0;
  EXPECT_THROW(check_section(lacking), InputError);
}

TEST(SectionKinds, AreInTheOrderOfTheirShapes) {
  for (std::size_t i = 0; i < section_kinds().size(); ++i) {
    EXPECT_EQ(section_kinds()[i]->shape(), static_cast<SectionShape>(i));
  }
}

}  // namespace
}  // namespace plastica
