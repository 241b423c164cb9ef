#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plastica/model/profile_table.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/sanitized.hpp"

// Planar beams that leave their plane, and that yield before or after: their moments are those of
// statics, so that theory's critical load is known in any case. What flows resists with the slope
// of its hardening (Engesser; Shanley, J. Aeronaut. Sci. 14, 1947).

namespace plastica {
namespace {

using testing::properties_of;

/// A strip on edge under a tip force, and its critical force 4.0126 sqrt(E I_y G J)/L^2 (Timoshenko
/// & Gere, Theory of Elastic Stability, 6.2).
Scene strip(double beyond, double& critical) {
  Scene scene = testing::cantilever_scene(32);
  scene.section.width = 1e-4;
  scene.section.height = 0.1;
  const SectionProperties p = properties_of(scene);
  const double e = scene.material.youngs_modulus;
  const double g = e / 2.6;
  critical = 4.0126 * std::sqrt(e * p.second_moment_y * g * p.torsion_constant);
  scene.loads.push_back({.force = {0.0, -beyond * critical, 0.0}});
  return scene;
}

/// The tip force of an ideal plastic strip on edge, over 4.0126 sqrt(E I_y G J)/L^2, by
///   G J beta'' + (P (L - x))^2/(E I_y c(x)) beta = 0,  beta(0) = beta'(L) = 0,
/// with c = sqrt(3 - 2 M/M_y) where the depth yields: its elastic fraction. By Runge and Kutta from
/// the tip, and by halving.
/// @param yield  moment of first yield over that of the critical force at the clamp
double critical_of_yielding_strip(double yield) {
  const auto clamp_angle = [&](double load) {
    const double unit = 4.0126 * load;
    const auto curvature = [&](double z, double beta) {
      const double m = load * z / yield;
      return -unit * unit * z * z * beta / (m > 1.0 ? std::sqrt(3.0 - 2.0 * m) : 1.0);
    };
    double beta = 1.0;
    double slope = 0.0;
    constexpr int kSteps = 4000;
    const double h = 1.0 / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double z = i * h;
      const double a1 = curvature(z, beta);
      const double a2 = curvature(z + h / 2, beta + h / 2 * slope);
      const double a3 = curvature(z + h / 2, beta + h / 2 * (slope + h / 2 * a1));
      const double a4 = curvature(z + h, beta + h * (slope + h / 2 * a2));
      beta += h * slope + h * h / 6 * (a1 + a2 + a3);
      slope += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return beta;
  };
  double low = 0.0;
  double high = std::min(1.1, 1.4999 * yield);
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (clamp_angle(middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

/// Load over the critical one at which the plane is left.
double leaves_at(const Response& response, double beyond) {
  EXPECT_EQ(response.status, Status::Unstable);
  if (!response.critical || response.critical->factor.empty()) return 0.0;
  EXPECT_EQ(response.critical->out_of_plane.front(), 1);
  return beyond * response.critical->factor.front();
}

/// First yield is at 1.2 times the critical load: the path ends there, and what came before must
/// not be lost. One step meets it, too.
TEST(YieldedBuckling, BeforeALimitLoadIsTold) {
  for (const int steps : {1, 3, 20}) {
    double critical = 0.0;
    Scene scene = strip(3.0, critical);
    scene.yield_model = YieldModel::Interaction;
    scene.material.yield_stress = 1.2 * critical / properties_of(scene).section_modulus_x;
    const Response response = simulate(scene, {.level = Level::Planar, .steps = steps});
    EXPECT_NEAR(leaves_at(response, 3.0), 1.0, 2e-3) << steps;
  }
}

/// Fibres: the depth yields from a fraction of the critical load on, the whole section at 1.5 times
/// that.
TEST(YieldedBuckling, AfterYieldingIsToldAtTheLoadOfTheElasticCore) {
  for (const double yield : {0.95, 0.85, 0.75, 0.7}) {
    for (const int steps : {2, 20}) {
      double critical = 0.0;
      Scene scene = strip(1.2, critical);
      scene.beam.segments = 128;
      scene.yield_model = YieldModel::Fibre;
      scene.material.yield_stress = yield * critical / properties_of(scene).section_modulus_x;
      const Response response = simulate(scene, {.level = Level::Planar, .steps = steps});
      EXPECT_GT(response.permanent_strain, 0.0);
      const double exact = critical_of_yielding_strip(yield);
      EXPECT_NEAR(leaves_at(response, 1.2), exact, 1e-3) << yield << ' ' << steps;
    }
  }
}

/// A column of hardening fibres, pinned at both ends, whose critical stress about its weak axis is
/// beyond first yield: its chain is that of Euler's column with the tangent modulus.
TEST(YieldedBuckling, OfAColumnIsAtTheTangentModulusLoad) {
  for (const int steps : {3, 20}) {
    constexpr int kSegments = 16;
    Scene scene = testing::chain_scene(kSegments);
    scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
    scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
    scene.section = {.width = 0.02, .height = 0.03};
    const SectionProperties p = properties_of(scene);
    const double e = scene.material.youngs_modulus;
    const double chain = 2.0 * kSegments * std::sin(std::numbers::pi / (2.0 * kSegments));
    const double euler = chain * chain * e * p.second_moment_y;
    constexpr double kFraction = 0.6;  // tangent modulus over Young's
    const double exact = kFraction * euler;
    scene.material.yield_stress = exact / 1.2 / p.area;
    scene.material.hardening = {.law = HardeningLaw::Linear, .tangent_modulus = kFraction * e};
    scene.yield_model = YieldModel::Fibre;
    // What is so small that it only says which plane is meant.
    scene.loads.push_back({.force = {0.0, 1e-6, -1.5 * exact}});
    const Response response = simulate(scene, {.level = Level::Planar, .steps = steps});
    EXPECT_NEAR(leaves_at(response, 1.5), 1.0, 1e-3) << steps;
  }
}

/// An I-section loses its flanges first: bending out of the plane is left to the web. Another
/// formulation of the same section sees the same, fibre by fibre in space.
TEST(YieldedBuckling, OfAnISectionIsWhereTheSpatialLevelHasIt) {
  Scene scene = testing::cantilever_scene(10);
  scene.section = {.shape = SectionShape::ISection, .width = 0.2, .height = 0.3};
  scene.section.web_thickness = 0.008;
  scene.section.flange_thickness = 0.012;
  scene.beam.length = 2.0;
  scene.material.yield_stress = 235e6;
  scene.yield_model = YieldModel::Fibre;
  scene.loads.push_back({.force = {0.0, -200e3, 0.0}});
  const Response planar = simulate(scene, {.level = Level::Planar});
  const Response spatial = simulate(scene, {.level = Level::Spatial});
  ASSERT_TRUE(planar.critical && spatial.critical);
  EXPECT_LT(planar.critical->factor.front(), 0.48);  // of 0.4955, where the section is plastic
  EXPECT_NEAR(planar.critical->factor.front(), spatial.critical->factor.front(), 1e-3);
}

/// Under more than its plastic moment a cantilever turns about its clamp until it hangs, and hangs
/// in its plane: what it passed on the way is told whatever the load at the end.
TEST(YieldedBuckling, OnTheWayToAStateThatIsStableAgainIsTold) {
  for (const double fraction : {0.98, 1.05, 1.5, 3.0}) {
    for (const int steps : {5, 20, 100}) {
      if (steps == 100 && (testing::kSanitized || fraction != 1.05)) continue;
      Scene scene = testing::cantilever_scene(20);
      scene.section = {.width = 0.01, .height = 0.1};
      scene.material.youngs_modulus = 210e9;
      scene.material.yield_stress = 355e6;
      scene.yield_model = YieldModel::Fibre;
      const SectionProperties p = properties_of(scene);
      const double plastic = scene.material.yield_stress * p.plastic_section_modulus_x;
      const double g = scene.material.youngs_modulus / 2.6;
      double critical = 4.0126 * std::sqrt(scene.material.youngs_modulus * p.second_moment_y * g *
                                           p.torsion_constant);
      critical *= critical_of_yielding_strip(plastic / 1.5 / critical);
      scene.loads.push_back({.force = {0.0, -fraction * plastic, 0.0}});
      const Response response = simulate(scene, {.level = Level::Planar, .steps = steps});
      // The deflection before it buckles raises Prandtl's load by 1 %, and N = 20 by 0.5 %.
      EXPECT_NEAR(leaves_at(response, fraction * plastic / critical), 1.01, 0.015)
          << fraction << ' ' << steps;
    }
  }
}

/// A strip that yields and stays below is stable, yielded or not.
TEST(YieldedBuckling, IsNotToldOfWhatStaysBelow) {
  EXPECT_GT(critical_of_yielding_strip(0.7), 0.95);
  double critical = 0.0;
  Scene scene = strip(0.95, critical);
  scene.yield_model = YieldModel::Fibre;
  scene.material.yield_stress = 0.7 * critical / properties_of(scene).section_modulus_x;
  const Response response = testing::completed(scene, {.level = Level::Planar, .steps = 10});
  EXPECT_GT(response.permanent_strain, 0.0);
  EXPECT_FALSE(response.critical.has_value());
}

/// What nothing holds in its plane, a bar on a pin and a slope that pushes along it, may swing out
/// of it: of that nothing is told, whatever little the joints keep for Newton's method.
TEST(YieldedBuckling, IsNotToldOfWhatMayLeaveThePlaneFreely) {
  for (const int segments : {4, 64, 1000}) {
    Scene scene = testing::chain_scene(segments);
    scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
    scene.supports.push_back(
        {.at = Place::end(), .kind = SupportKind::InclinedRoller, .normal = {0.0, 0.6, -0.8}});
    scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, -0.1, 0.0}});
    const Response response = testing::completed(scene, {.level = Level::Planar, .steps = 1});
    EXPECT_FALSE(response.critical.has_value()) << segments;
  }
}

/// The load of a profile that no one holds sideways: IPE 200, 4 m, published I_z and I_T, without
/// warping. Theory with the deflection before is higher by 1/sqrt((1 - I_z/I_y)(1 - G J/E I_y)).
TEST(YieldedBuckling, OfAProfileIsBeforeItsPlasticMoment) {
  Scene scene = testing::cantilever_scene(32);
  scene.section = named_profile("IPE 200");
  scene.beam.length = 4.0;
  scene.material.yield_stress = 235e6;
  scene.yield_model = YieldModel::Interaction;
  scene.yield_cap = YieldCap::FullyPlastic;
  const double e = 200e9;
  const double g = e / 2.6;
  const double iy = 1943e-8, iz = 142.4e-8, it = 6.98e-8;
  const double before = std::sqrt((1.0 - iz / iy) * (1.0 - g * it / (e * iy)));
  const double critical = 4.0126 * std::sqrt(e * iz * g * it) / 16.0 / before;
  scene.loads.push_back({.force = {0.0, 15e3, 0.0}});
  const Response response = simulate(scene, {.steps = 20});
  EXPECT_NEAR(leaves_at(response, 15e3 / critical), 1.0, 5e-3);
}

}  // namespace
}  // namespace plastica
