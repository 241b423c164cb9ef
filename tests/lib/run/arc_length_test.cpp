#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "plastica/run/peak_warning.hpp"
#include "tests/support/chain_scene.hpp"

namespace plastica {
namespace {

/// The end of a cantilever beyond its plastic moment: the moment at the clamp is M_p, so that the
/// lever of the tip's force is M_p/P whatever the way there. An arc that went past the end and came
/// back would leave what it yielded there; with 3 steps, more arcs are needed than there are
/// samples.
TEST(ArcLength, EndsAtTheLoadThatWasAskedForAndNotBehindIt) {
  Scene scene = testing::cantilever_scene(16);
  scene.material.youngs_modulus = 2e13;
  scene.beam.length = 5.0;  // its axial force takes (N/N_p)^2 < 1e-6 of M_p
  scene.section = {.width = 0.02, .height = 0.02};
  scene.yield_model = YieldModel::Interaction;
  scene.yield_cap = YieldCap::FullyPlastic;
  scene.end_rule = EndRule::HalfJoint;
  const double plastic =
      scene.material.yield_stress * testing::properties_of(scene).plastic_section_modulus_x;
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Z);
  for (const double factor : {1.05, 1.5}) {
    const double force = factor * plastic / scene.beam.length;
    scene.loads = {{.at = Place::end(), .force = {0.0, force, 0.0}}};
    for (const Level level : {Level::Planar, Level::Spatial}) {
      for (const int steps : {3, 20, 200}) {
        const Response response = testing::completed(
            scene, {.level = level, .steps = steps, .control = PathControl::ArcLength});
        const double lever = scene.beam.length + response.probes[0][response.samples - 1];
        EXPECT_NEAR(force * lever, plastic, 1e-6 * plastic) << factor << ", " << steps;
        EXPECT_EQ(response.chain.factor[response.samples - 1], 1.0);
      }
    }
  }
}

/// A shallow arch, pushed at its crown: its path winds, and no equilibrium beyond the first top is
/// stable before it has snapped through.
Scene pushed_arch() {
  Scene scene = testing::cantilever_scene(24);
  scene.beam.shape = BeamShape::Arc;
  scene.beam.arc_angle = 0.6;
  scene.supports = {{.at = Place::start(), .kind = SupportKind::Pin},
                    {.at = Place::end(), .kind = SupportKind::Pin}};
  scene.loads = {{.at = {0.5, {}}, .force = {0.0, 40e3 * std::cos(0.3), -40e3 * std::sin(0.3)}}};
  return scene;
}

/// With few steps the samples end on the way.
TEST(ArcLength, NeverCallsAPathCompletedThatEndsBelowItsLoad) {
  const Scene scene = pushed_arch();
  for (const int steps : {1, 2, 4, 8, 12, 16, 20, 25, 30}) {
    const Response response = simulate(scene, {.translation = JointTranslation::Elastic,
                                               .steps = steps,
                                               .control = PathControl::ArcLength});
    EXPECT_EQ(response.status, Status::Unstable) << steps;
    // It gets to 1 on its way up again, if there are samples for all of the way.
    EXPECT_TRUE(steps < 20 || response.chain.factor[response.samples - 1] == 1.0) << steps;
  }
}

/// The peak that it passes is where load control ends.
TEST(ArcLength, SaysThatItPassesAPeak) {
  const Scene scene = pushed_arch();
  SolverOptions options{
      .translation = JointTranslation::Elastic, .steps = 400, .control = PathControl::Load};
  const Response led = simulate(scene, options);
  ASSERT_TRUE(led.limit.has_value());
  EXPECT_TRUE(peak_warnings(scene, led).empty());
  options.control = PathControl::ArcLength;
  const std::vector<std::string> said = peak_warnings(scene, simulate(scene, options));
  ASSERT_EQ(said.size(), 1U);
  const std::string before = "the path passes a peak at a factor of ";
  ASSERT_TRUE(said[0].starts_with(before)) << said[0];
  EXPECT_NEAR(std::stod(said[0].substr(before.size())), led.limit->above, 5e-3) << said[0];
}

}  // namespace
}  // namespace plastica
