#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "plastica/run/chain_modes.hpp"
#include "plastica/run/natural_frequencies.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

// Roots that are there twice, beside which a count of eigenvalues may fall by rounding, and what
// tells that from a tangent that is not symmetric.

namespace plastica {
namespace {

using testing::tolerance;

constexpr SolverOptions kInPlane{.level = Level::Planar, .rotary_inertia = RotaryInertia::Off};

std::vector<double> unloaded_frequencies_of(Scene scene, SolverOptions options, int count) {
  scene.loads.push_back({.force = {0.0, 1.0, 0.0}});
  options.analysis = Analysis::Dynamics;
  options.duration = 1.0;
  return unloaded_frequencies(prepare(scene, options), count);
}

/// Two legs between which a clamp stands at the corner swing like one of them alone, and each
/// frequency is there twice: what counts eigenvalues beside such a root has little to go by.
TEST(DoubleRoots, OfTwoLegsFromAClampAreThoseOfOneTwice) {
  const auto legs = [](int count) {
    Scene scene = testing::chain_scene(count * 6);
    scene.beam.shape = BeamShape::Polyline;
    scene.beam.points = {{0.0, 0.0, 0.0}, {0.0, 0.2, 0.5}};
    if (count == 2) scene.beam.points.push_back({0.0, 0.0, 1.0});
    scene.beam.length = count * std::hypot(0.2, 0.5);
    scene.supports.push_back({.at = {1.0 / count, {}}, .kind = SupportKind::Clamp});
    return scene;
  };
  for (const auto translation : {JointTranslation::Rigid, JointTranslation::Elastic}) {
    SolverOptions options = kInPlane;
    options.translation = translation;
    const auto one = unloaded_frequencies_of(legs(1), options, 3);
    const auto two = unloaded_frequencies_of(legs(2), options, 6);
    // Half a segment of the second leg shears at the clamp itself, of one alone beyond it.
    const double within = translation == JointTranslation::Rigid ? 1e-6 : 2e-3;
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(two[i] / one[i / 2], 1.0, tolerance(within)) << i;
    }
  }
}

/// A thrust that follows its segment has no potential, one that does not has: by it counts that
/// rounding lets fall are told from others.
TEST(Asymmetry, OfATangentIsThatOfItsFollowers) {
  const auto asymmetry_under = [](bool follows) {
    using L = chain::Planar<double>;
    Scene scene = testing::cantilever_scene(12);
    const double thrust = 2.0 * testing::bending_stiffness_of(scene);
    scene.loads = {{.force = {0.0, 0.0, -thrust}, .follows = follows}};
    const Model model = prepare(scene, kInPlane);
    ChainBody<L, false> body(*model.chain, {model.chain->across});
    body.reset(material_values(model.chain->scene.material));
    const chain::Coordinates<L> straight = body.work.q;
    const ChainModes<L, false> modes(body, straight, 1.0, false);
    auto& w = body.work;
    w.recursion.factor(body.build.chain, w.q, w.placement, w.stage, w.joints, w.outer_forces,
                       w.transmitted);
    return solve::asymmetry(body.build.chain, w);
  };
  EXPECT_LT(asymmetry_under(false), 1e-12);
  EXPECT_GT(asymmetry_under(true), 1e-3);
}

}  // namespace
}  // namespace plastica
