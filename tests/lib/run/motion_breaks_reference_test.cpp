#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"

/// Breaking scenes of many kinds: their energies balance, and none ends in a surprise.
namespace plastica {
namespace {

using testing::breaking_scene;
using testing::motion_options;
using testing::struck_scene;

TEST(MotionBreaks, BalancesItsEnergiesInElasticPlasticBreakingScenes) {
  std::vector<Scene> scenes{breaking_scene(16), breaking_scene(24, 20.0), breaking_scene(8, 40.0)};
  scenes.push_back(struck_scene(12, 20.0, YieldModel::Fibre));
  scenes.back().material.break_strain = 0.05;
  Scene sideways = breaking_scene(10);
  sideways.initial_motions[0].velocity = {10.0, -25.0, 0.0};
  scenes.push_back(sideways);
  for (const Scene& scene : scenes) {
    const Response exact = simulate(scene, motion_options(Scheme::EnergyMomentum, 5e-5, 400));
    EXPECT_EQ(exact.status, Status::Broken);
    EXPECT_LT(exact.energy_balance_error, 1e-8);
    for (const Scheme scheme : {Scheme::LinearlyImplicitEuler, Scheme::GeneralizedAlpha}) {
      const Response coarse = simulate(scene, motion_options(scheme, 1e-4, 60));
      const Response fine = simulate(scene, motion_options(scheme, 1.25e-5, 480));
      // An eighth of the step; when a joint breaks differs, too.
      const double most = scheme == Scheme::GeneralizedAlpha ? 1.0 / 20.0 : 1.0 / 2.0;
      EXPECT_LT(fine.energy_balance_error, most * coarse.energy_balance_error);
    }
  }
}

TEST(MotionBreaks, EndsRandomScenesWithoutASurprise) {
  std::mt19937 random(20);
  const auto between = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  std::vector<BatchCase> cases;
  for (int k = 0; k < 100; ++k) {
    Scene scene = struck_scene(static_cast<int>(between(3.0, 20.0)), between(2.0, 60.0));
    if (k % 3 == 0) scene.initial_motions[0].velocity[0] = between(-20.0, 20.0);
    if (k % 4 == 0) scene.supports.clear();
    if (k % 5 == 0) scene.yield_model = YieldModel::Fibre;
    scene.material.break_strain = between(0.005, 0.2);
    scene.on_break = k % 2 == 0 ? BreakPolicy::CutAll : BreakPolicy::CutWorst;
    if (k % 6 == 0) {
      Support pillar{.at = Place::end(), .kind = SupportKind::Pillar};
      pillar.gap = between(0.0, 0.1);
      pillar.restitution = between(0.0, 1.0);
      scene.supports.push_back(pillar);
    }
    auto options = motion_options(static_cast<Scheme>(k % 4), between(2e-5, 5e-4), 20);
    options.fibres = 8;
    cases.push_back({std::to_string(k), scene, options, {}});
  }
  for (const BatchRow& row : run_batch(cases)) {
    // Random steps may be too long for a scene: then its account says so, and its status.
    EXPECT_TRUE(is_complete(row.response.status))
        << row.id << ": " << name_of(row.response.status) << ' ' << row.reason;
    EXPECT_EQ(row.response.status == Status::NotBalanced, !row.response.balances()) << row.id;
    const auto scheme = static_cast<Scheme>(std::stoi(row.id) % 4);
    if (scheme == Scheme::EnergyMomentum || scheme == Scheme::LinearlyImplicitMidpoint) {
      EXPECT_LT(row.response.momentum_error, 1e-6) << row.id;
    }
    for (const Energies& energy : row.response.chain.energy) {
      EXPECT_TRUE(std::isfinite(energy.kinetic + energy.elastic)) << row.id;
    }
  }
}

}  // namespace
}  // namespace plastica
