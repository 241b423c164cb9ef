#include "plastica/theory/report_formulas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plastica/model/material.hpp"
#include "plastica/model/section.hpp"

// How far the source document's equations are from mechanics, each as a number.

namespace plastica::theory {
namespace {

constexpr double kE = 210e9;
constexpr double kNu = 0.3;
const double kG = resolved_shear_modulus({.youngs_modulus = kE, .poisson_ratio = kNu});
constexpr double kFormulaL = 0.1;  // length of each segment, and the tributary length of a joint

SectionProperties rectangle(double width, double height) {
  return section_properties({.width = width, .height = height}, kNu);
}

SectionProperties circle(double radius) {
  return section_properties({.shape = SectionShape::Circle, .radius = radius}, kNu);
}

/// The torsion stiffness of Wendelius' report over G J/l, without the factor 2 of (1) that (2)
/// shares.
double torsion_ratio(const SectionProperties& p) {
  const double second_moment = report::torsion_second_moment(p.second_moment_x, p.second_moment_y);
  const double printed = report::torsion_stiffness(kE, kNu, second_moment, kFormulaL, kFormulaL);
  return 2.0 * printed / (kG * p.torsion_constant / kFormulaL);
}

TEST(ReportFormulas, BendingStiffnessIsHalfOfMechanics) {
  const SectionProperties p = rectangle(0.02, 0.03);
  const double printed = report::bending_stiffness(kE, p.second_moment_x, kFormulaL, kFormulaL);
  EXPECT_DOUBLE_EQ(printed / (kE * p.second_moment_x / kFormulaL), 0.5);
}

TEST(ReportFormulas, TorsionOfACircleIsHalfOfMechanics) {
  EXPECT_NEAR(torsion_ratio(circle(0.01)), 0.5, 1e-12);
}

TEST(ReportFormulas, TorsionOfASquareIsFiftyNinePercentOfMechanics) {
  EXPECT_NEAR(torsion_ratio(rectangle(0.02, 0.02)), 0.593, 5e-4);
}

TEST(ReportFormulas, TorsionAtTwoToOneIsFortySixPercentTooStiff) {
  EXPECT_NEAR(torsion_ratio(rectangle(0.02, 0.01)), 1.458, 5e-4);
  EXPECT_NEAR(torsion_ratio(rectangle(0.01, 0.02)), 1.458, 5e-4);
}

TEST(ReportFormulas, BendingCapsOfASquareAreHalfOfFirstYield) {
  const SectionProperties p = rectangle(0.02, 0.02);
  EXPECT_NEAR(report::bending_cap_x(355e6, p.second_moment_x, 0.02) / (355e6 * p.section_modulus_x),
              0.5, 1e-12);
  EXPECT_NEAR(report::bending_cap_y(355e6, p.second_moment_y, 0.02) / (355e6 * p.section_modulus_y),
              0.5, 1e-12);
}

TEST(ReportFormulas, BendingCapsAreRightOnlyAtTwoToOne) {
  // I_x/b against I_x/(h/2): equal where h = 2b, and then the other axis is off by four.
  const SectionProperties p = rectangle(0.01, 0.02);
  EXPECT_NEAR(report::bending_cap_x(1.0, p.second_moment_x, 0.01) / p.section_modulus_x, 1.0,
              1e-12);
  EXPECT_NEAR(report::bending_cap_y(1.0, p.second_moment_y, 0.02) / p.section_modulus_y, 0.25,
              1e-12);
}

TEST(ReportFormulas, TorsionCapIsFourPercentTooLargeAtTwoToOne) {
  EXPECT_NEAR(report::torsion_cap(1.0, 0.02, 0.01) / rectangle(0.02, 0.01).torsion_modulus,
              1.0 / ((3.0 + 0.9) * 0.24587834), 1e-6);
  EXPECT_NEAR(report::torsion_cap(1.0, 0.01, 0.02) / rectangle(0.01, 0.02).torsion_modulus - 1.0,
              0.043, 5e-4);
}

TEST(ReportFormulas, TorsionCapOfASquareIsRightWithinAThousandth) {
  EXPECT_NEAR(report::torsion_cap(1.0, 0.02, 0.02) / rectangle(0.02, 0.02).torsion_modulus, 1.0,
              1e-3);
}

TEST(ReportFormulas, BendingStrainOfEquationSevenSwapsTheSides) {
  const double b = 0.01, h = 0.03, angle = 0.01;
  EXPECT_DOUBLE_EQ(report::bending_strain_y(h, angle, kFormulaL),
                   report::bending_strain(h, angle, kFormulaL));
  // About x the distance is h/2; (7) takes b/2 there, a third of it.
  EXPECT_NEAR(report::bending_strain_x(b, angle, kFormulaL) / (h / 2.0 * angle / kFormulaL),
              1.0 / 3.0, 1e-5);
  EXPECT_NEAR(report::bending_strain_y(h, angle, kFormulaL) / (b / 2.0 * angle / kFormulaL), 3.0,
              1e-4);
}

TEST(ReportFormulas, TorsionStrainLeavesOutTheWarpingOfARectangle) {
  // gamma = (J/W_t) theta/l; Wendelius' report has c/2 for J/W_t.
  const SectionProperties square = rectangle(1.0, 1.0);
  EXPECT_NEAR(square.torsion_constant / square.torsion_modulus, 0.675, 5e-4);
  EXPECT_DOUBLE_EQ(report::torsion_strain(1.0, kFormulaL, kFormulaL), 0.5);
  const SectionProperties round = circle(0.5);
  EXPECT_NEAR(round.torsion_constant / round.torsion_modulus, 0.5, 1e-12);
  // At 2:1 the sign turns: c/2 = 1.000 s against 0.930 s.
  const SectionProperties flat = rectangle(2.0, 1.0);
  EXPECT_NEAR(flat.torsion_constant / flat.torsion_modulus, 0.930, 5e-4);
}

TEST(ReportFormulas, BendingStrainFallsAgainBeyondHalfATurn) {
  using std::numbers::pi;
  const double h = 0.03;
  EXPECT_NEAR(report::bending_strain(h, pi, kFormulaL), h / kFormulaL, 1e-12);
  EXPECT_NEAR(report::bending_strain(h, 2.0 * pi, kFormulaL), 0.0, 1e-12);
  // Against the linear (h/2) theta/l: 2/pi at half a turn.
  EXPECT_NEAR(report::bending_strain(h, pi, kFormulaL) / (h / 2.0 * pi / kFormulaL), 2.0 / pi,
              1e-12);
}

TEST(ReportFormulas, EqualYieldStressesInShearAreSeventyThreePercentTooHigh) {
  const Material m{.yield_stress = 300e6, .break_strain = 0.1};
  EXPECT_NEAR(m.yield_stress / resolved_shear_yield_stress(m), 1.7320508, 1e-7);
  EXPECT_NEAR(*m.break_strain / *resolved_break_shear_strain(m), 0.5773503, 1e-7);
}

}  // namespace
}  // namespace plastica::theory
