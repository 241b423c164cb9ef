#include "plastica/theory/bending.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plastica/model/section.hpp"
#include "tests/reference/reference_table.hpp"

namespace plastica::theory {
namespace {

TEST(MomentCurvature, MatchesTheReferenceTable) {
  const testing::ReferenceTable table("elastoplastic-section/moment_curvature.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double k = table.at("kappa_over_kappa_y", i);
    SCOPED_TRACE(k);
    // Nine printed digits; tube and box stand in the table by quadrature.
    EXPECT_NEAR(moment_ratio_rectangle(k), table.at("M_over_My_rectangle_PragerHodge", i), 1e-9);
    EXPECT_NEAR(moment_ratio_circle(k), table.at("M_over_My_solid_circle", i), 1e-9);
    EXPECT_NEAR(moment_ratio_round_tube(k, 0.8), table.at("M_over_My_tube_ri_ro_0.8", i), 1e-6);
    EXPECT_NEAR(moment_ratio_rectangular_tube(k, 0.8, 0.8),
                table.at("M_over_My_box_inner_0.8x0.8", i), 1e-6);
  }
}

TEST(MomentCurvature, IsElasticUpToYieldAndOdd) {
  EXPECT_EQ(moment_ratio_rectangle(0.7), 0.7);
  EXPECT_EQ(moment_ratio_circle(-0.7), -0.7);
  EXPECT_EQ(moment_ratio_rectangle(-3.0), -moment_ratio_rectangle(3.0));
  EXPECT_EQ(moment_ratio_circle(-3.0), -moment_ratio_circle(3.0));
  EXPECT_NEAR(moment_ratio_round_tube(0.5, 0.8), 0.5, 1e-15);
}

TEST(MomentCurvature, TendsToTheShapeFactorOfTheSection) {
  const auto shape_factor = [](const Section& section) {
    const SectionProperties p = section_properties(section, 0.3);
    return p.plastic_section_modulus_x / p.section_modulus_x;
  };
  EXPECT_NEAR(moment_ratio_rectangle(1e6), shape_factor({}), 1e-11);
  EXPECT_NEAR(moment_ratio_circle(1e6), shape_factor({.shape = SectionShape::Circle}), 1e-11);
  EXPECT_NEAR(moment_ratio_round_tube(1e6, 0.8), shape_factor({.shape = SectionShape::RoundTube}),
              1e-11);
  EXPECT_NEAR(moment_ratio_rectangular_tube(1e6, 0.8, 0.8),
              shape_factor({.shape = SectionShape::RectangularTube}), 1e-11);
}

TEST(MomentCurvature, OfTheCircleIsTheIntegralOverItsStrips) {
  const double k = 1.7;
  constexpr int kStrips = 20000;
  double sum = 0.0;
  for (int i = 0; i < kStrips; ++i) {
    // y = sin(a) makes the integrand smooth at the rim.
    const double a = (i + 0.5) / kStrips * std::numbers::pi / 2.0;
    const double y = std::sin(a);
    sum += 4.0 * std::min(k * y, 1.0) * y * std::cos(a) * std::cos(a);
  }
  const double moment = sum * std::numbers::pi / 2.0 / kStrips;
  EXPECT_NEAR(moment_ratio_circle(k), moment / (std::numbers::pi / 4.0), 1e-8);
}

TEST(MomentCurvature, InverseOfTheRectangleReturnsTheCurvature) {
  for (const double k : {-20.0, -1.5, -0.2, 0.0, 0.9, 1.0, 1.1, 5.0, 20.0}) {
    EXPECT_NEAR(curvature_ratio_rectangle(moment_ratio_rectangle(k)), k, 1e-10);
  }
}

}  // namespace
}  // namespace plastica::theory
