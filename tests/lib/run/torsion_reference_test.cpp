#include <gtest/gtest.h>

#include "plastica/theory/torsion_circle.hpp"
#include "plastica/theory/torsion_elastic.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

/// Twisted bars against Saint-Venant and the elastoplastic circle.
namespace plastica {
namespace {

using testing::tolerance;

const Section kSquare{.width = 0.02, .height = 0.02};
const Section kFlat{.width = 0.02, .height = 0.04};
const Section kRound{.shape = SectionShape::Circle, .radius = 0.01};

/// A bar whose end is turned about its axis; probe 0 is the torque at the start.
Scene turned_bar(const Section& section, int segments, double angle) {
  Scene scene = testing::cantilever_scene(segments);
  scene.section = section;
  scene.supports.push_back({.at = Place::end(),
                            .kind = SupportKind::Guide,
                            .hold = HeldFreedoms{false, false, false, false, false, true},
                            .rotation = {0.0, 0.0, angle}});
  testing::add_probe(scene, ProbeQuantity::Moment, Place::start(), Component::Z);
  return scene;
}

double torsion_yield_twist(const Scene& scene) {
  const SectionProperties p = testing::properties_of(scene);
  return resolved_shear_yield_stress(scene.material) * p.torsion_modulus * scene.beam.length /
         (resolved_shear_modulus(scene.material) * p.torsion_constant);
}

double yield_torque(const Scene& scene) {
  return resolved_shear_yield_stress(scene.material) *
         testing::properties_of(scene).torsion_modulus;
}

TEST(TorsionRun, TurnsUnderAnEndTorqueAsSaintVenantSays) {
  constexpr int kSegments = 8;
  for (const Section& section : {kSquare, kFlat, kRound}) {
    Scene scene = testing::cantilever_scene(kSegments);
    scene.section = section;
    scene.loads.push_back({.moment = {0.0, 0.0, 30.0}});
    // A segment turns as the bar does at its middle.
    testing::add_probe(scene, ProbeQuantity::Rotation, Place{0.5 / kSegments, {}}, Component::Z);
    testing::add_probe(scene, ProbeQuantity::Rotation, Place::end(), Component::Z);
    const double whole =
        theory::end_twist(section, resolved_shear_modulus(scene.material), 1.0, 30.0);
    const Response response = testing::completed(scene);
    EXPECT_NEAR(testing::last_of(response, 0) / whole, 0.5 / kSegments, tolerance(1e-10));
    // The last one as the end does, whose half its joint has, too.
    EXPECT_NEAR(testing::last_of(response, 1) / whole, 1.0, tolerance(1e-10));
  }
}

TEST(TorsionRun, ResistsATurnedEndAsSaintVenantSaysWhateverTheSegments) {
  for (const Section& section : {kSquare, kFlat, kRound}) {
    for (const int segments : {1, 2, 50}) {
      const Scene scene = turned_bar(section, segments, 0.1);
      const double per_torque =
          theory::end_twist(section, resolved_shear_modulus(scene.material), 1.0, 1.0);
      EXPECT_NEAR(testing::last_of(testing::completed(scene), 0) * per_torque, 0.1,
                  tolerance(1e-10));
    }
  }
}

TEST(TorsionRun, OfACircleOfFibresFollowsTheElastoplasticCurveAndKeepsItsTwist) {
  for (const double ratio : {0.8, 1.5, 3.0}) {
    SCOPED_TRACE(ratio);
    Scene scene = turned_bar(kRound, 10, 0.0);
    scene.yield_model = YieldModel::Fibre;
    const double first = torsion_yield_twist(scene);
    scene.supports.back().rotation = {0.0, 0.0, ratio * first};
    const Response response = testing::completed(scene);
    EXPECT_NEAR(testing::last_of(response, 0) / yield_torque(scene),
                theory::torque_ratio_circle(ratio), tolerance(0.002));
    // Back by the elastic part, the torque is gone.
    const double kept = theory::residual_twist_ratio_circle(ratio) / ratio;
    scene.supports.back().history = History::turning_points({1.0, kept});
    const Response released = testing::completed(scene, {.steps = 40});
    EXPECT_NEAR(testing::last_of(released, 0) / yield_torque(scene), 0.0, tolerance(0.003));
  }
}

TEST(TorsionRun, OfTheReportStaysOnThePlateauOfItsCap) {
  Scene scene = turned_bar(kSquare, 10, 0.0);
  scene.yield_model = YieldModel::PerAxis;
  const double first = torsion_yield_twist(scene);
  scene.supports.back().rotation = {0.0, 0.0, 4.0 * first};
  const Response response = testing::completed(scene, {.steps = 40});
  for (std::size_t i = 0; i < response.samples; ++i) {
    const double turned = 4.0 * response.chain.factor.at(i);
    EXPECT_NEAR(response.probes[0][i] / yield_torque(scene), std::min(turned, 1.0),
                tolerance(1e-9));
  }
}

}  // namespace
}  // namespace plastica
