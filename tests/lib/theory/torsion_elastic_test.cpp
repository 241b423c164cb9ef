#include "plastica/theory/torsion_elastic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/reference/reference_table.hpp"

namespace plastica::theory {
namespace {

constexpr double kShearG = 80e9;

TEST(ElasticTorsion, OfRectanglesMatchesTheReferenceTable) {
  const testing::ReferenceTable table("torsion-rectangle/coefficients.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double ratio = table.at("a_over_b", i), s = 0.02;
    SCOPED_TRACE(ratio);
    // Eight printed digits.
    const Section bar{.width = s, .height = ratio * s};
    const double J = table.at("beta_J_over_ab3", i) * ratio * std::pow(s, 4);
    const double W = table.at("alpha_T_over_taumax_ab2", i) * ratio * std::pow(s, 3);
    EXPECT_NEAR(end_twist(bar, kShearG, 1.5, 10.0) / (10.0 * 1.5 / (kShearG * J)), 1.0, 1e-7);
    EXPECT_NEAR(largest_shear_stress(bar, 10.0) / (10.0 / W), 1.0, 1e-7);
  }
}

TEST(ElasticTorsion, OfARoundBarIsThatOfThePolarMoment) {
  const Section bar{.shape = SectionShape::Circle, .radius = 0.01};
  const double J = std::numbers::pi * 1e-8 / 2.0;
  EXPECT_NEAR(end_twist(bar, kShearG, 2.0, 5.0), 10.0 / (kShearG * J), 1e-15);
  EXPECT_NEAR(largest_shear_stress(bar, 5.0) / (5.0 * 0.01 / J), 1.0, 1e-14);
}

TEST(ElasticTorsion, OfAnEvenTorqueIsTheIntegralOfTheTorqueAlongTheBar) {
  const Section bar{.width = 0.02, .height = 0.04};
  constexpr int kParts = 100;
  double sum = 0.0;
  for (int i = 0; i < kParts; ++i) {
    const double carried = 3.0 * 2.0 * (1.0 - (i + 0.5) / kParts);  // t (L - x)
    sum += end_twist(bar, kShearG, 2.0 / kParts, carried);
  }
  EXPECT_NEAR(end_twist_distributed(bar, kShearG, 2.0, 3.0) / sum, 1.0, 1e-12);
}

}  // namespace
}  // namespace plastica::theory
