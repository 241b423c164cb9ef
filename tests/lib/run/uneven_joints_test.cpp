#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/chain_scene.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/tolerance.hpp"

// A joint between two sections of unlike aspect ratios has another length about each axis.

namespace plastica {
namespace {

using testing::add_probe;
using testing::completed;
using testing::last_of;
using testing::tolerance;

/// A square bar whose outer half is narrow, bent askew beyond yield.
/// @param mirrored  x for y
Scene narrowing_bar(bool mirrored, YieldModel model) {
  Scene scene = testing::cantilever_scene(2);
  scene.material.youngs_modulus = 200e9;
  scene.material.yield_stress = 250e6;
  scene.material.density = 7850.0;
  scene.section = {.width = 0.02, .height = 0.02};
  scene.yield_model = model;
  Section narrow = scene.section;
  (mirrored ? narrow.height : narrow.width) = 0.012;
  scene.regions.push_back({{0.5, {}}, {1.0, {}}, narrow, scene.material});
  // Fibres carry more than what yields at first.
  const double factor = model == YieldModel::Fibre ? 1.3 : 1.0;
  const double along = 180.0 * factor;
  const double across = 150.0 * factor;
  scene.loads.push_back({.force = {mirrored ? across : along, mirrored ? along : across, 0.0}});
  for (const Component c : {Component::X, Component::Y}) {
    add_probe(scene, ProbeQuantity::Displacement, Place::end(),
              mirrored ? (c == Component::X ? Component::Y : Component::X) : c);
  }
  return scene;
}

constexpr YieldModel kCoupled[] = {YieldModel::Interaction, YieldModel::Fibre};

Response moved(bool mirrored, Scheme scheme) {
  SolverOptions options;
  options.analysis = Analysis::Dynamics;
  options.level = Level::Spatial;
  options.scheme = scheme;
  options.duration = 1.0;  // over which the load grows
  options.time_step = 1e-3;
  return completed(narrowing_bar(mirrored, YieldModel::Interaction), options);
}

TEST(UnevenJoints, MoveAsTheirMirrorImageDoes) {
  // Its moments are those of the law and follow from no energy.
  const Response by_forces = moved(false, Scheme::GeneralizedAlpha);
  for (const Scheme scheme : {Scheme::EnergyMomentum, Scheme::LinearlyImplicitMidpoint}) {
    const Response one = moved(false, scheme);
    const Response other = moved(true, scheme);
    for (const std::size_t probe : {0U, 1U}) {
      const double tip = last_of(one, probe);
      EXPECT_NEAR(tip, last_of(other, probe), tolerance(1e-6 * std::fabs(tip)));
      EXPECT_NEAR(tip, last_of(by_forces, probe), tolerance(2e-3 * std::fabs(tip)));
    }
    const double plastic = one.chain.energy.back().plastic;
    EXPECT_NEAR(plastic, other.chain.energy.back().plastic, tolerance(1e-6 * plastic));
    EXPECT_GT(plastic, 1.0);
  }
}

TEST(UnevenJoints, DissipateWhatIsDoneOnThem) {
  for (const YieldModel model : kCoupled) {
    std::array<double, 2> plastic{};
    for (const bool mirrored : {false, true}) {
      double before = 0.0;
      for (const int steps : {25, 100}) {
        const Response path =
            completed(narrowing_bar(mirrored, model), {.level = Level::Spatial, .steps = steps});
        const Energies& end = path.chain.energy.back();
        const double error = std::fabs(end.residual) / end.external;
        EXPECT_LT(error, steps == 25 ? 0.02 : 2e-3) << steps;
        if (steps == 100) {
          EXPECT_LT(error, 0.35 * before);
        }
        before = error;
        plastic[mirrored ? 1 : 0] = end.plastic;
      }
    }
    EXPECT_GT(plastic[0], 0.5);
    // What fibres keep by their own stresses is that of the length about one axis.
    const double same = model == YieldModel::Fibre ? 0.03 : 1e-3;
    EXPECT_NEAR(plastic[0], plastic[1], tolerance(same * plastic[0]));
  }
}

}  // namespace
}  // namespace plastica
