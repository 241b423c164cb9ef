#include "plastica/theory/torsion_circle.hpp"

#include <gtest/gtest.h>

#include "plastica/model/section.hpp"
#include "tests/reference/reference_table.hpp"

namespace plastica::theory {
namespace {

TEST(TorsionCircle, MatchesTheReferenceTable) {
  const testing::ReferenceTable table("torsion-elastoplastic-circle/torque_twist.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double t = table.at("theta_over_theta_y", i);
    SCOPED_TRACE(t);
    EXPECT_NEAR(torque_ratio_circle(t), table.at("T_over_Ty", i), 1e-9);
    EXPECT_NEAR(residual_twist_ratio_circle(t),
                table.at("residual_theta_over_theta_y_after_unload", i), 1e-9);
    EXPECT_NEAR(elastic_core_ratio_circle(t), table.at("elastic_core_radius_over_R", i), 1e-9);
  }
}

TEST(TorsionCircle, IsElasticUpToYieldAndOdd) {
  EXPECT_EQ(torque_ratio_circle(-0.4), -0.4);
  EXPECT_EQ(residual_twist_ratio_circle(0.4), 0.0);
  EXPECT_EQ(elastic_core_ratio_circle(0.4), 1.0);
  EXPECT_EQ(torque_ratio_circle(-2.0), -torque_ratio_circle(2.0));
}

TEST(TorsionCircle, TendsToTheFullyPlasticTorqueOfTheSection) {
  const SectionProperties p = section_properties({.shape = SectionShape::Circle}, 0.3);
  EXPECT_NEAR(torque_ratio_circle(1e5), p.plastic_torsion_modulus / p.torsion_modulus, 1e-14);
}

}  // namespace
}  // namespace plastica::theory
