#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

// Regions act from where to where the scene says, whatever the number of segments.

namespace plastica {
namespace {

using testing::add_probe;
using testing::bending_stiffness_of;
using testing::cantilever_scene;
using testing::completed;
using testing::last_of;
using testing::tolerance;

constexpr double kTipForce = 1e-2;  ///< [N]; finite rotations cost 1e-11 of the deflection
constexpr double kSofter = 0.2;     ///< E of the region over that of the beam

/// A cantilever under a tip force with a soft region.
Scene with_region(int segments, double from, double to) {
  Scene scene = cantilever_scene(segments);
  Material soft = scene.material;
  soft.youngs_modulus *= kSofter;
  scene.regions.push_back({{from, {}}, {to, {}}, scene.section, soft});
  scene.loads.push_back({.force = {0.0, kTipForce, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  return scene;
}

/// int M^2/(P EI): of the whole beam, and what the region adds.
double exact_tip(double ei, double from, double to) {
  const double region = std::pow(1.0 - from, 3) - std::pow(1.0 - to, 3);
  return kTipForce / (3.0 * ei) * (1.0 + (1.0 / kSofter - 1.0) * region);
}

double tip_of(int segments, double from, double to) {
  return last_of(completed(with_region(segments, from, to), {.steps = 1}), 0);
}

TEST(RegionEnds, MoveTheTipAsTheirComplianceDoes) {
  const double ei = bending_stiffness_of(cantilever_scene(1));
  const double near = tip_of(10, 0.0, 0.449);
  const double far = tip_of(10, 0.0, 0.451);
  const double exact = exact_tip(ei, 0.0, 0.451) - exact_tip(ei, 0.0, 0.449);
  // The same deal of segments on both sides, so errors move along with the end.
  EXPECT_NEAR((far - near) / exact, 1.0, tolerance(0.02));
}

TEST(RegionEnds, LetARegionShorterThanASegmentAct) {
  const double ei = bending_stiffness_of(cantilever_scene(1));
  const double without = tip_of(10, 0.0, 1e-6);
  const double with = tip_of(10, 0.0, 0.04);
  const double exact = exact_tip(ei, 0.0, 0.04) - exact_tip(ei, 0.0, 0.0);
  EXPECT_NEAR((with - without) / exact, 1.0, tolerance(0.04));
}

TEST(RegionEnds, KeepOrderTwoWhereverTheyAre) {
  const double ei = bending_stiffness_of(cantilever_scene(1));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  for (int trial = 0; trial < 40; ++trial) {
    double from = anywhere(random);
    double to = anywhere(random);
    if (from > to) std::swap(from, to);
    const double exact = exact_tip(ei, from, to);
    for (const int segments : {16, 64, 256}) {
      // Joints are a trapezoidal rule of M^2/EI, which in a stretch of even segments of length h
      // gives too much by h^2/12 times the difference of its slopes, h^2/6 of P^2/EI times the
      // stretch. No segment is longer than in a deal of all of them but one for each stretch.
      const double h = 1.0 / (segments - 2);
      const double softness = kTipForce / ei * (1.0 + (1.0 / kSofter - 1.0) * (to - from));
      const double error = tip_of(segments, from, to) - exact;
      EXPECT_GT(error, 0.0) << from << ' ' << to << ' ' << segments;
      EXPECT_LT(error, h * h / 6.0 * softness) << from << ' ' << to << ' ' << segments;
    }
  }
}

TEST(RegionEnds, MayBeVeryNearToEachOtherInMotion) {
  // Segments of a millionth of the length neither stop a motion nor change it.
  const auto moved = [](double from, double to) {
    Scene scene = with_region(8, from, to);
    scene.loads[0].force[1] = 100.0;
    SolverOptions options;
    options.analysis = Analysis::Dynamics;
    options.scheme = Scheme::EnergyMomentum;
    options.duration = 0.02;
    options.steps = 20;
    const Response response = completed(scene, options);
    EXPECT_LT(response.energy_balance_error, 1e-6);
    return last_of(response, 0);
  };
  EXPECT_NEAR(moved(0.5, 0.5 + 1e-6) / moved(0.5, 0.5 + 3e-6), 1.0, tolerance(1e-4));
}

}  // namespace
}  // namespace plastica
