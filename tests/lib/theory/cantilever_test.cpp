#include "plastica/theory/cantilever.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "plastica/theory/bending.hpp"
#include "tests/reference/reference_table.hpp"

namespace plastica::theory {
namespace {

TEST(ElastoplasticCantilever, MatchesTheReferenceTable) {
  const testing::ReferenceTable table("elastoplastic-cantilever/tip_load_deflection_rectangle.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double p = table.at("P_over_Py", i);
    SCOPED_TRACE(p);
    EXPECT_NEAR(tip_deflection_ratio(p), table.at("delta_over_delta_y", i), 1e-9);
    EXPECT_NEAR(plastic_zone_ratio(p), table.at("plastic_zone_length_over_L", i), 1e-9);
  }
}

TEST(ElastoplasticCantilever, EndsAtTwentyNinthsAtTheLimitLoad) {
  EXPECT_NEAR(tip_deflection_ratio(1.5), 20.0 / 9.0, 1e-14);
  EXPECT_NEAR(plastic_zone_ratio(1.5), 1.0 / 3.0, 1e-14);
}

TEST(ElastoplasticCantilever, IsToldFromWhatHasNoNumber) {
  EXPECT_THROW(tip_deflection_ratio(-1.2), std::domain_error);
  EXPECT_THROW(tip_deflection_ratio(std::nan("")), std::domain_error);
  EXPECT_THROW(curvature_ratio_rectangle(1.5), std::domain_error);
  EXPECT_THROW(moment_ratio_round_tube(2.0, 1.0), std::domain_error);
  try {
    tip_deflection_ratio(1.6);
    ADD_FAILURE() << "beyond the limit load";
  } catch (const std::domain_error& error) {
    EXPECT_TRUE(
        std::string(error.what()).ends_with("tip_deflection_ratio: needs p >= 0.0 && p <= 1.5"))
        << error.what();
  }
}

TEST(ElastoplasticCantilever, IsElasticUpToYield) {
  EXPECT_EQ(tip_deflection_ratio(0.6), 0.6);
  EXPECT_EQ(plastic_zone_ratio(0.6), 0.0);
}

TEST(ElastoplasticCantilever, IsTheMomentCurvatureLawIntegratedAlongTheBeam) {
  const double p = 1.3;
  constexpr int kPoints = 20000;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double x = (i + 0.5) / kPoints;  // from the tip, where the moment is zero
    sum += curvature_ratio_rectangle(p * x) * x / kPoints;
  }
  EXPECT_NEAR(tip_deflection_ratio(p), 3.0 * sum, 1e-7);
}

TEST(ElastoplasticCantilever, KeepsHalfAMillimetreAfterTwelveTenthsOfFirstYield) {
  // 1 m of 20 x 20 mm steel, E = 200 GPa, sigma_y = 250 MPa: P_y = 333.3 N, loaded to 400 N.
  const double I = std::pow(0.02, 4) / 12.0, P_y = 250e6 * I / 0.01;
  const double delta_y = P_y / (3.0 * 200e9 * I);
  EXPECT_NEAR(residual_tip_ratio(400.0 / P_y) * delta_y, 5.409e-4, 5e-8);
  EXPECT_EQ(residual_tip_ratio(0.9), 0.0);
}

}  // namespace
}  // namespace plastica::theory
