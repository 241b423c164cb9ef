#include "plastica/law/fibre_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plastica/model/torsion.hpp"
#include "tests/lib/law/fibre_joint.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::law {
namespace {

using std::numbers::pi;
using Joint = testing::FibreJoint<double, IdealPlastic<double>>;

constexpr double kYield = 300e6;
const double kShearYield = kYield / std::sqrt(3.0);

Material metal() {
  Material material;
  material.yield_stress = kYield;
  return material;
}

Section rectangle(double width, double height) { return {.width = width, .height = height}; }
Section circle() { return {.shape = SectionShape::Circle, .radius = 0.05}; }
Section thin_tube() {
  return {.shape = SectionShape::RoundTube, .radius = 0.05, .inner_radius = 0.049};
}
Section thin_box() {
  return {.shape = SectionShape::RectangularTube,
          .width = 0.1,
          .height = 0.06,
          .inner_width = 0.098,
          .inner_height = 0.058};
}

/// Torque far beyond yield, from the undeformed section in one increment.
double plastic_torque(const Section& section, FibrePlane plane, int fibres = 20) {
  return Joint(section, metal(), plane, fibres)({{0.0, 0.0, 1e4, 0.0}}).force[kTorsion];
}

TEST(FibreGrid, CarriesTheTorqueOfTheSandHeap) {
  // Nadai, Z. angew. Math. Mech. 3 (1923) 442: twice the volume of the heap; circle 2/3 pi R^3.
  for (const FibrePlane plane : {FibrePlane::Both, FibrePlane::Torsion}) {
    for (const auto& [c, s] :
         {std::pair{0.1, 0.1}, {0.1, 0.06}, {0.1, 0.05}, {0.1, 0.03}, {0.1, 0.01}}) {
      const double heap = s * s * (3.0 * c - s) / 6.0;
      EXPECT_NEAR(plastic_torque(rectangle(c, s), plane) / (kShearYield * heap), 1.0, 1e-6);
      EXPECT_NEAR(plastic_torque(rectangle(s, c), plane) / (kShearYield * heap), 1.0, 1e-6);
    }
    const double disc = 2.0 / 3.0 * pi * 0.05 * 0.05 * 0.05;
    EXPECT_NEAR(plastic_torque(circle(), plane) / (kShearYield * disc), 1.0, 1e-3);
    // Thin walls: 2 tau t times the area within the middle line (Bredt), to t/b.
    EXPECT_NEAR(plastic_torque(thin_box(), plane) / (kShearYield * 2.0 * 1e-3 * 0.099 * 0.059), 1.0,
                2e-3);
    EXPECT_NEAR(
        plastic_torque(thin_tube(), plane) / (kShearYield * 2.0 * 1e-3 * pi * 0.0495 * 0.0495), 1.0,
        2e-3);
  }
}

TEST(FibreGrid, YieldsFirstByTorsionWhereSaintVenantSaysSo) {
  // Timoshenko & Goodier, Theory of Elasticity, table of sec. 109: T_y = tau alpha c s^2.
  struct Row {
    double ratio, alpha;
  };
  for (const Row row :
       {Row{1.0, 0.208}, Row{1.5, 0.231}, Row{2.0, 0.246}, Row{3.0, 0.267}, Row{10.0, 0.312}}) {
    const double s = 0.1 / row.ratio;
    const double yields = kShearYield * row.alpha * 0.1 * s * s;
    Joint joint(rectangle(0.1, s), metal(), FibrePlane::Both, 40);
    const double unit = joint({{0.0, 0.0, 1e-4, 0.0}}).force[kTorsion] / 1e-4;
    EXPECT_EQ(joint({{0.0, 0.0, 0.995 * yields / unit, 0.0}}).plastic_work, 0.0) << row.ratio;
    EXPECT_GT(joint({{0.0, 0.0, 1.02 * yields / unit, 0.0}}).plastic_work, 0.0) << row.ratio;
  }
}

/// The plastic limit under bending and torsion in a given ratio of strains: m and t.
struct Limit {
  double m, t;
  double size() const { return std::hypot(m, t); }
};

Limit limit_of(const Section& section, double twist_over_curvature, std::size_t axis = kBendingX,
               int fibres = 12) {
  const SectionProperties p = section_properties(section, 0.3);
  Joint joint(section, metal(), FibrePlane::Both, fibres);
  SectionForce<double> force;
  for (int i = 1; i <= 12; ++i) {
    SectionStrain<double> strain;
    strain[axis] = 125.0 * i;
    strain[kTorsion] = twist_over_curvature * strain[axis];
    force = joint(strain).force;
  }
  const double modulus =
      axis == kBendingX ? p.plastic_section_modulus_x : p.plastic_section_modulus_y;
  return {force[axis] / (kYield * modulus),
          force[kTorsion] / (kShearYield * p.plastic_torsion_modulus)};
}

TEST(FibreGrid, OfAThinTubeYieldsByBendingWithTorsionOnTheCircle) {
  // Its shear flow is the same all around, so each point carries Y sqrt(1 - t^2): exact.
  for (double ratio = 0.1; ratio < 20.0; ratio *= 2.5) {
    const Limit limit = limit_of(thin_tube(), ratio);
    EXPECT_NEAR(limit.size(), 1.0, 0.005) << ratio;
  }
}

TEST(FibreGrid, OfACircleYieldsBetweenBothBoundsOfTheLimit) {
  // m^2 + t^2 = 1 is a lower bound (the stress everywhere Y sqrt(1 - t^2) and t tau_y). Plane
  // sections that turn as a whole give an upper one, with s = twist/(sqrt(3) curvature):
  // m = 1/4 integral of sin^2/r and t = s/(2 pi) integral of 1/r, r = sqrt(sin^2 + s^2).
  for (double ratio = 0.2; ratio < 20.0; ratio *= 2.0) {
    const double s = ratio / std::sqrt(3.0);
    Limit upper{};
    constexpr int kPoints = 4000;
    for (int i = 0; i < kPoints; ++i) {
      const double sine = std::sin(2.0 * pi * (i + 0.5) / kPoints);
      const double r = std::hypot(sine, s);
      upper.m += 0.25 * sine * sine / r * 2.0 * pi / kPoints;
      upper.t += s / r / kPoints;
    }
    const Limit limit = limit_of(circle(), ratio, kBendingX, 16);
    EXPECT_GT(limit.size(), 1.0 - 0.002) << ratio;
    EXPECT_LT(limit.size(), 1.01) << ratio;
    // Work on this ratio of strains is no more than the upper bound's.
    EXPECT_LT(4.0 / 3.0 * limit.m + s * 2.0 * pi / 3.0 * limit.t,
              (4.0 / 3.0 * upper.m + s * 2.0 * pi / 3.0 * upper.t) * 1.002)
        << ratio;
  }
}

TEST(FibreGrid, OfARectangleYieldsOutsideOfTheLowerBoundAndInsideOfPlaneSections) {
  for (const Section& section : {rectangle(0.1, 0.1), rectangle(0.05, 0.1), rectangle(0.02, 0.1)}) {
    for (const std::size_t axis : {kBendingX, kBendingY}) {
      for (double ratio = 0.4; ratio < 7.0; ratio *= 2.0) {
        if (plastica::testing::kSanitized && ratio < 3.0) continue;
        const Limit limit = limit_of(section, ratio, axis);
        EXPECT_GT(limit.size(), 1.0 - 1e-3) << ratio;
        // The strong way of a flat one is the worst.
        const bool strong = axis == kBendingX && section.width < section.height;
        EXPECT_LT(limit.size(), strong ? 1.065 : 1.03) << section.width << ' ' << ratio;
      }
    }
  }
}

TEST(FibreGrid, TurnsWithARoundSection) {
  // Bent about x or about an axis in between, with the same torsion.
  const double along = std::sqrt(0.5);
  Joint about_x(circle(), metal(), FibrePlane::Both, 20);
  Joint between(circle(), metal(), FibrePlane::Both, 20);
  for (int i = 1; i <= 40; ++i) {
    const double s = 0.2 * std::sin(0.15 * i);
    const auto a = about_x({{s, 0.0, 0.6 * s, 0.0}}).force;
    const auto b = between({{along * s, along * s, 0.6 * s, 0.0}}).force;
    const double cap = kYield * 4.0 / 3.0 * 0.05 * 0.05 * 0.05;
    EXPECT_NEAR(std::hypot(b[kBendingX], b[kBendingY]), std::fabs(a[kBendingX]), 1e-3 * cap);
    EXPECT_NEAR(b[kTorsion], a[kTorsion], 1e-3 * cap);
  }
}

TEST(FibreGrid, TwistsBackToTheSameLimitsBothWays) {
  const double cap = kShearYield * sand_heap_modulus_rectangle(0.05, 0.1);
  Joint joint(testing::upright(), metal(), FibrePlane::Both, 20);
  double torque = 0.0;
  for (int i = 0; i <= (plastica::testing::kSanitized ? 50 : 100); ++i) {
    torque = joint({{0.0, 0.0, 4.0 * std::sin(0.1 * i), 0.0}}).force[kTorsion];
    EXPECT_LE(std::fabs(torque), cap * (1.0 + 1e-9));
  }
}

}  // namespace
}  // namespace plastica::law
