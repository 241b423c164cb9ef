#include "plastica/law/break_criterion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"

namespace plastica::law {
namespace {

TEST(BreakCriterion, MechanicsIsLinearInTheAngle) {
  EXPECT_DOUBLE_EQ(permanent_bending_strain(0.2, 0.1, 0.05), 0.2);
  EXPECT_DOUBLE_EQ(permanent_bending_strain(-0.2, 0.1, 0.05), 0.2);
  EXPECT_DOUBLE_EQ(permanent_torsion_strain(0.1, 0.02, 0.5), 0.004);
  EXPECT_DOUBLE_EQ(permanent_stretch_strain(-0.01, 0.5), 0.02);
}

TEST(BreakCriterion, TakesTheResultantInACircleAndTheCornerInARectangle) {
  EXPECT_DOUBLE_EQ(permanent_biaxial_strain_circle(0.3, 0.4, 0.1, 1.0), 0.05);
  EXPECT_DOUBLE_EQ(permanent_biaxial_strain_rectangle(0.3, -0.4, 0.2, 0.1, 1.0),
                   0.5 * (0.1 * 0.3 + 0.2 * 0.4));
}

TEST(BreakCriterion, OfTheReportIsTheChordAndDoesNotHealBeyondHalfATurn) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(report_bending_strain(pi / 3.0, 0.1, 0.2), 0.25, 1e-15);
  EXPECT_NEAR(report_bending_strain(pi, 0.1, 0.2), 0.5, 1e-15);
  EXPECT_NEAR(report_bending_strain(1.5 * pi, 0.1, 0.2), 0.5, 1e-15);
  // Equation (24) as printed.
  const double angle = 0.7;
  EXPECT_NEAR(report_bending_strain(angle, 0.1, 0.2),
              std::sqrt(2.0 * 0.05 * 0.05 * (1.0 - std::cos(angle))) / 0.2, 1e-15);
}

TEST(BreakCriterion, FormulasAgreeForSmallAnglesAndDifferByTheSineForLargeOnes) {
  EXPECT_NEAR(report_bending_strain(1e-4, 0.1, 0.2) / permanent_bending_strain(1e-4, 0.1, 0.2), 1.0,
              1e-9);
  EXPECT_NEAR(report_bending_strain(1.0, 0.1, 0.2) / permanent_bending_strain(1.0, 0.1, 0.2),
              std::sin(0.5) / 0.5, 1e-15);
}

TEST(BreakCriterion, TakesEveryScalar) {
  using Lanes = Pack<double, 8>;
  using D = Dual<double, 1>;
  const Lanes lanes =
      report_bending_strain(constant<Lanes>(0.7), constant<Lanes>(0.1), constant<Lanes>(0.2));
  EXPECT_EQ(lanes[3], report_bending_strain(0.7, 0.1, 0.2));
  const D dual = report_bending_strain(D::parameter(0.7, 0), constant<D>(0.1), constant<D>(0.2));
  EXPECT_NEAR(dual.derivative(0), 0.5 / 2.0 * std::cos(0.35), 1e-15);
  EXPECT_NEAR(report_bending_strain(0.7F, 0.1F, 0.2F), report_bending_strain(0.7, 0.1, 0.2), 1e-7);
}

}  // namespace
}  // namespace plastica::law
