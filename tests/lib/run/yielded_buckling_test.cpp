#include <gtest/gtest.h>

#include <cmath>

#include "plastica/model/profile_table.hpp"
#include "tests/support/chain_scene.hpp"

// Planar beams that leave their plane, and that yield before or after: their moments are those of
// statics, so that theory's critical load is known in any case.

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

/// Fibres: the depth yields from 0.85 of the critical load on, the whole section would at 1.27. In
/// the plane of a strip so thin that changes nothing but the deflection, and out of it the elastic
/// stiffness is the most that there is: it is left at the critical load at the latest.
TEST(YieldedBuckling, AfterYieldingIsToldAtTheLoadWhichNothingStiffensBeyond) {
  for (const int steps : {2, 20}) {
    double critical = 0.0;
    Scene scene = strip(1.2, critical);
    scene.yield_model = YieldModel::Fibre;
    scene.material.yield_stress = 0.85 * critical / properties_of(scene).section_modulus_x;
    const Response response = simulate(scene, {.level = Level::Planar, .steps = steps});
    EXPECT_GT(response.permanent_strain, 0.0);
    EXPECT_NEAR(leaves_at(response, 1.2), 1.0, 2e-3) << steps;
  }
}

/// Under more than its plastic moment a cantilever turns about its clamp until it hangs, and hangs
/// in its plane: what it passed on the way is told whatever the load at the end.
TEST(YieldedBuckling, OnTheWayToAStateThatIsStableAgainIsTold) {
  for (const double share : {0.98, 1.05, 1.5, 3.0}) {
    for (const int steps : {5, 20}) {
      Scene scene = testing::cantilever_scene(20);
      scene.section = {.width = 0.01, .height = 0.1};
      scene.material.youngs_modulus = 210e9;
      scene.material.yield_stress = 355e6;
      scene.yield_model = YieldModel::Fibre;
      const SectionProperties p = properties_of(scene);
      const double plastic = scene.material.yield_stress * p.plastic_section_modulus_x;
      const double g = scene.material.youngs_modulus / 2.6;
      const double critical = 4.0126 * std::sqrt(scene.material.youngs_modulus * p.second_moment_y *
                                                 g * p.torsion_constant);
      scene.loads.push_back({.force = {0.0, -share * plastic, 0.0}});
      const Response response = simulate(scene, {.level = Level::Planar, .steps = steps});
      // The deflection before it buckles raises Prandtl's load by 1 %, and N = 20 by 0.5 %.
      EXPECT_NEAR(leaves_at(response, share * plastic / critical), 1.01, 0.015)
          << share << ' ' << steps;
    }
  }
}

/// A strip that yields and stays below is stable, yielded or not.
TEST(YieldedBuckling, IsNotToldOfWhatStaysBelow) {
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
