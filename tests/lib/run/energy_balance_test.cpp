#include <gtest/gtest.h>

#include <array>

#include "plastica/model/section.hpp"
#include "plastica/run/response.hpp"
#include "tests/support/chain_scene.hpp"

namespace plastica {
namespace {

TEST(EnergyBalance, CountsWhatItCannotExplain) {
  const std::array samples{Energies{.kinetic = 2.0, .external = 2.0},
                           Energies{.kinetic = 1.0, .external = 1.1, .residual = -0.1}};
  EXPECT_DOUBLE_EQ(energy_balance_error(samples), 0.05);
}

TEST(EnergyBalance, CountsWhatASchemeMakesAndNotWhatItDissipates) {
  const std::array makes{Energies{.kinetic = 3.0, .numerical_dissipation = -1.0, .external = 2.0}};
  EXPECT_DOUBLE_EQ(energy_balance_error(makes), 1.0 / 3.0);
  const std::array takes{Energies{.kinetic = 1.0, .numerical_dissipation = 1.0, .external = 2.0}};
  EXPECT_DOUBLE_EQ(energy_balance_error(takes), 0.0);
}

TEST(EnergyBalance, IsRightWhereNothingMoves) {
  EXPECT_EQ(energy_balance_error(std::array<Energies, 2>{}), 0.0);
}

/// Large steps of fibres that go on and off leave energy that nothing explains: a path says so.
TEST(EnergyBalance, IsJudgedAtRestToo) {
  Scene scene = testing::cantilever_scene(8);
  scene.yield_model = YieldModel::Fibre;
  const double yield =
      scene.material.yield_stress * section_properties(scene.section, 0.3).section_modulus_x;
  scene.loads.push_back({.at = Place::end(),
                         .force = {0.0, -1.3 * yield / scene.beam.length, 0.0},
                         .history = History::turning_points({1.0, -1.0, 1.0})});
  const auto error = [&](int steps) {
    return testing::completed(scene, {.steps = steps}).energy_balance_error;
  };
  EXPECT_GT(error(10), 1e-3);
  EXPECT_LT(error(80), 0.2 * error(20));
}

}  // namespace
}  // namespace plastica
