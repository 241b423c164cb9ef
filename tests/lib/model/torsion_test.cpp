#include "plastica/model/torsion.hpp"

#include <gtest/gtest.h>

#include "tests/reference/reference_table.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica {
namespace {

TEST(Torsion, SaintVenantCoefficientsMatchTheReferenceTable) {
  const testing::ReferenceTable table("torsion-rectangle/coefficients.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double ratio = table.at("a_over_b", i);
    SCOPED_TRACE(ratio);
    // The table has eight digits; its eta comes from a truncated series (0.99999999 at 1).
    EXPECT_NEAR(saint_venant_beta(ratio), table.at("beta_J_over_ab3", i), 1e-8);
    EXPECT_NEAR(saint_venant_alpha(ratio), table.at("alpha_T_over_taumax_ab2", i), 1e-8);
    EXPECT_NEAR(saint_venant_eta(ratio), table.at("eta_tau_shortside_over_taumax", i), 2e-8);
    const double first_yield = saint_venant_alpha(ratio) * ratio;
    EXPECT_NEAR(sand_heap_modulus_rectangle(ratio, 1.0) / first_yield,
                table.at("Tp_over_Ty_plastic_shape_factor", i), 1e-6);
  }
}

TEST(Torsion, SquareHasEqualStressOnAllSides) { EXPECT_NEAR(saint_venant_eta(1.0), 1.0, 1e-13); }

TEST(Torsion, StripHasOneThirdOfItsLength) {
  // beta -> 1/3 - 0.21025 s/c, alpha the same.
  EXPECT_NEAR(saint_venant_beta(1e6), 1.0 / 3.0, 1e-6);
  EXPECT_NEAR(saint_venant_alpha(1e6), 1.0 / 3.0, 1e-6);
}

TEST(Torsion, ShearOfARectangleIsLargestInTheMiddleOfItsLongSides) {
  for (const double ratio : {1.0, 1.5, 3.0, 10.0}) {
    SCOPED_TRACE(ratio);
    const double largest = saint_venant_beta(ratio) / saint_venant_alpha(ratio);
    EXPECT_NEAR(saint_venant_shear(1.0, ratio, 0.5, 0.0), largest, 1e-6);
    EXPECT_NEAR(saint_venant_shear(ratio, 1.0, 0.0, -0.5), largest, 1e-6);
    EXPECT_NEAR(saint_venant_shear(1.0, ratio, 0.0, 0.0), 0.0, 1e-12);
    // In the middle of the short sides, eta times that.
    EXPECT_NEAR(saint_venant_shear(1.0, ratio, 0.0, 0.5 * ratio), largest * saint_venant_eta(ratio),
                1e-3 * largest);
  }
}

TEST(Torsion, ShearOfARectangleStoresTheEnergyOfItsTorsionConstant) {
  // J theta^2 = integral of the squared shear (midpoints, second order).
  const double ratio = 1.5;
  constexpr int kPoints = 100;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    for (int j = 0; j < kPoints; ++j) {
      const double shear = saint_venant_shear(1.0, ratio, (i + 0.5) / kPoints - 0.5,
                                              ratio * ((j + 0.5) / kPoints - 0.5));
      sum += shear * shear * ratio / (kPoints * kPoints);
    }
  }
  EXPECT_NEAR(sum, saint_venant_beta(ratio) * ratio, 1e-4);
}

TEST(BoxTorsion, ShearOfAThinWallIsBredts) {
  // Flow 2 A_m/(circumference/t) over the wall of each side; through the wall it changes by 2 t.
  // Bredt's is off by wall over side.
  const BoxDimensions box{1.0, 0.6, 0.98, 0.57};
  const double side = 0.99 * 0.585;
  const double flow = 2.0 * side / (2.0 * 0.99 / 0.015 + 2.0 * 0.585 / 0.01);
  const auto solved = solved_box(box);
  EXPECT_NEAR(solved->shear_at({0.3, 0.2925}), flow / 0.015, 0.02 * flow / 0.015);
  EXPECT_NEAR(solved->shear_at({0.495, 0.1}), flow / 0.01, 0.02 * flow / 0.01);
  EXPECT_EQ(solved->shear_at({0.3, 0.2925}), solved->shear_at({-0.3, -0.2925}));
  EXPECT_EQ(solved->shear_at({0.495, 0.1}), solved->shear_at({-0.495, 0.1}));
}

TEST(BoxTorsion, ThinWallTendsToBredt) {
  for (const double wall : {1e-2, 1e-3, 1e-4}) {
    if (testing::kSanitized && wall < 1e-2) continue;
    SCOPED_TRACE(wall);
    const BoxDimensions box{2.0, 1.0, 2.0 - 2.0 * wall, 1.0 - 2.0 * wall};
    const BoxTorsion exact = solved_box(box)->torsion;
    const BoxTorsion bredt = bredt_box(box);
    // Bredt leaves out the slope of the stress through the wall: of order wall / side.
    EXPECT_NEAR(exact.constant / bredt.constant, 1.0, 2.0 * wall);
    EXPECT_NEAR(exact.modulus / bredt.modulus, 1.0, 2.0 * wall);
    EXPECT_GT(exact.constant, bredt.constant);
    EXPECT_LT(exact.modulus, bredt.modulus);
  }
}

TEST(BoxTorsion, OuterStressOfAThinWallIsBredtsMeanPlusHalfItsSlope) {
  // Through a straight wall the stress falls by 2 G theta t, half of it on either side of the mean.
  const double wall = 0.01;
  const BoxTorsion exact = solved_box({1.0, 1.0, 1.0 - 2.0 * wall, 1.0 - 2.0 * wall})->torsion;
  const double middle = 1.0 - wall;
  const double mean = exact.constant / (2.0 * middle * middle * wall);
  EXPECT_NEAR(exact.constant / exact.modulus, mean + wall, 1e-3 * mean);
}

TEST(BoxTorsion, VanishingHoleTendsToTheSolidRectangle) {
  for (const double ratio : {1.0, 2.0, 3.0}) {
    if (testing::kSanitized && ratio != 2.0) continue;
    SCOPED_TRACE(ratio);
    // A hole in the middle, where the stress is zero, matters only as its size to the fourth.
    const BoxTorsion box = solved_box({ratio, 1.0, 0.01, 0.01})->torsion;
    EXPECT_NEAR(box.constant / (saint_venant_beta(ratio) * ratio), 1.0, 1e-4);
    EXPECT_NEAR(box.modulus / (saint_venant_alpha(ratio) * ratio), 1.0, 1e-4);
  }
}

TEST(BoxTorsion, LiesBetweenItsBounds) {
  // From above, the solid rectangle. From below, any stress function phi: (2 integral phi)^2 over
  // integral |grad phi|^2; the sand heap's slope is 1, so that this is T_p^2 over the wall's area.
  for (const double hole : {0.1, 0.5, 0.9, 0.98}) {
    if (testing::kSanitized && hole != 0.5) continue;
    SCOPED_TRACE(hole);
    const BoxDimensions box{1.0, 1.0, hole, hole};
    const double heap = sand_heap_modulus_box(box);
    const double constant = solved_box(box)->torsion.constant;
    EXPECT_LT(constant, saint_venant_beta(1.0));
    EXPECT_GT(constant, heap * heap / (1.0 - hole * hole));
  }
}

/// NaN has no place among the boxes that are kept: it would find another box, or none after it.
TEST(BoxTorsion, RefusesSidesThatAreNotFinite) {
  const BoxDimensions box{1.0, 1.0, 0.25, 0.75};
  const double constant = solved_box(box)->torsion.constant;
  for (const double side :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(solved_box({1.0, side, 0.25, 0.75}), std::invalid_argument);
  }
  EXPECT_EQ(solved_box(box)->torsion.constant, constant);
}

TEST(BoxTorsion, DoesNotDependOnWhichSideIsTheWidth) {
  const BoxTorsion lying = solved_box({2.0, 1.0, 1.9, 0.5})->torsion;
  const BoxTorsion standing = solved_box({1.0, 2.0, 0.5, 1.9})->torsion;
  EXPECT_NEAR(lying.constant / standing.constant, 1.0, 1e-10);
  EXPECT_NEAR(lying.modulus / standing.modulus, 1.0, 1e-10);
}

TEST(BoxTorsion, ScalesWithThePowersOfLength) {
  const BoxTorsion metres = solved_box({1.0, 2.0, 0.8, 1.7})->torsion;
  const BoxTorsion millimetres = solved_box({1e-3, 2e-3, 0.8e-3, 1.7e-3})->torsion;
  EXPECT_NEAR(millimetres.constant / metres.constant, 1e-12, 1e-22);
  EXPECT_NEAR(millimetres.modulus / metres.modulus, 1e-9, 1e-19);
}

TEST(SandHeap, OfAnEvenWallIsTheFrustum) {
  EXPECT_NEAR(sand_heap_modulus_box({2.0, 1.0, 1.8, 0.8}),
              sand_heap_modulus_rectangle(2.0, 1.0) - sand_heap_modulus_rectangle(1.8, 0.8), 1e-15);
}

TEST(SandHeap, IntegratedForUnevenWallsJoinsTheFrustum) {
  const double even = sand_heap_modulus_box({2.0, 1.0, 1.8, 0.8});
  EXPECT_NEAR(sand_heap_modulus_box({2.0, 1.0, 1.8 + 1e-9, 0.8}) / even, 1.0, 1e-5);
}

TEST(SandHeap, OfAVanishingHoleIsThatOfTheRectangle) {
  EXPECT_NEAR(sand_heap_modulus_box({2.0, 1.0, 1e-6, 1e-6}), sand_heap_modulus_rectangle(2.0, 1.0),
              1e-4);
}

TEST(SandHeap, IsNeverBelowFirstYield) {
  for (const BoxDimensions& box : {BoxDimensions{1.0, 1.0, 0.5, 0.5},
                                   {2.0, 1.0, 1.9, 0.5},
                                   {2.0, 1.0, 0.5, 0.9},
                                   {1.0, 1.0, 0.98, 0.98}}) {
    EXPECT_GT(sand_heap_modulus_box(box), solved_box(box)->torsion.modulus);
  }
}

}  // namespace
}  // namespace plastica
